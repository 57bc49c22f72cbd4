"""What is said of blocks that people make themselves."""

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct, field

from learnblock.server.messages.base import Message, Name, ShortText, Text

#: Of a function.
MOST_ARGUMENTS = 100

# The page speaks.


class ListOwnBlocks(Message, frozen=True):
    """Ask for `OwnBlocks`."""


class CheckOwnBlock(Message, frozen=True):
    """Ask what is wrong with a block, and how it looks: `OwnBlockChecked`.

    Args:
        request: comes back with the answer.
        name: of its file, without the ending; empty where it has none yet.
        source: the Python of its functions.
        configuration: what is chosen for them, as JSON; empty for nothing.
        replaces: the name that it is saved under, since it clashes with everything but itself.
        language: of the previews.
    """

    request: int
    name: ShortText
    source: Text
    configuration: Text = ""
    replaces: ShortText = ""
    language: Name = "en"


class SaveOwnBlock(Message, frozen=True):
    """Save a block: `OwnBlockSaved`, or `OwnBlockChecked` with the request 0 when it is wrong.

    Args:
        name: to be, of its file.
        source: see `CheckOwnBlock`.
        configuration: likewise.
        replaces: the name that it had until now; empty for a new one.
    """

    name: Name
    source: Text
    configuration: Text = ""
    replaces: ShortText = ""


class TryOwnBlock(Message, frozen=True):
    """Run one function on the current robot, as a program of one line, without saving it.

    What it returns is printed; how it ends is `Ended`, with `tried`.

    Args:
        name: see `CheckOwnBlock`.
        source: likewise.
        function: which; empty for the first.
        arguments: in the order of its parameters; those left out have their defaults.
    """

    name: ShortText
    source: Text
    function: ShortText = ""
    arguments: Annotated[list[Any], Meta(max_length=MOST_ARGUMENTS)] = field(default_factory=list)


class DuplicateOwnBlock(Message, frozen=True):
    """Copy a block; its functions get names that are free. `OwnBlockSaved` follows."""

    name: Name
    new: Name


class DeleteOwnBlock(Message, frozen=True):
    """Delete a block; it is kept until one of the same name is deleted."""

    name: Name


class RestoreOwnBlock(Message, frozen=True):
    """Take back that a block was deleted: `OwnBlockSaved`."""

    name: Name


class ExportOwnBlock(Message, frozen=True):
    """Ask for a block as one file: `File`."""

    name: Name


class ImportOwnBlock(Message, frozen=True):
    """Add the block in a file that was exported: `OwnBlockSaved`, or `Failed` if it cannot be.

    Args:
        content: of the file.
        replace: the block of the same name, if there is one; otherwise that is refused.
    """

    content: Text
    replace: bool = False


# The server speaks.


class OwnBlockProblem(Struct, frozen=True, omit_defaults=True):
    """What is wrong or doubtful in a block.

    Args:
        part: where `line` and `column` lie.
        code: what kind of problem, for tests and help.
        message: what is wrong and what to do.
        severity: an error keeps the block from being saved, and from being used.
        line: from 1; 0 for all of it.
        column: from 1; 0 for the whole line.
        end_column: behind the last character; 0 where it is not known.
    """

    part: Literal["name", "source", "configuration"]
    code: str
    message: str
    severity: Literal["error", "warning"]
    line: int = 0
    column: int = 0
    end_column: int = 0


class OwnBlock(Struct, frozen=True):
    """A file of the user's own, which makes one block or several.

    Args:
        name: of the file, without the ending.
        category: the tab of the palette.
        blocks: the names of its functions.
        source: its Python.
        configuration: what is chosen for them, as JSON; empty for nothing.
        problems: of both.
    """

    name: str
    category: str
    blocks: tuple[str, ...]
    source: str
    configuration: str
    problems: tuple[OwnBlockProblem, ...] = ()


class OwnBlocks(Message, frozen=True):
    """Every block of the user's own; all pages hear it whenever one has changed."""

    blocks: tuple[OwnBlock, ...]


class OwnBlockPreview(Struct, frozen=True):
    """A block as it would look.

    Args:
        name: of the function.
        definition: of the block, as Blockly's JSON has it.
        block: as it lies in the palette, with its shadows.
    """

    name: str
    definition: dict[str, Any]
    block: dict[str, Any]


class OwnBlockChecked(Message, frozen=True):
    """What is wrong with a block, and how it looks.

    Args:
        request: of the question; 0 where it could not be saved.
        problems: of the source, the configuration and the name.
        configuration: complete, as JSON: what the source says and what was chosen. Empty where the
            source cannot be read.
        chosen: the same without the words that the source says by itself, such as those of a
            docstring: this is what is saved, and what to send after something was chosen, or else
            an old docstring goes before a new one.
        previews: each block, in the language that was asked for.
    """

    request: int
    problems: tuple[OwnBlockProblem, ...] = ()
    configuration: str = ""
    chosen: str = ""
    previews: tuple[OwnBlockPreview, ...] = ()


class OwnBlockSaved(Message, frozen=True):
    """A block is saved under this name."""

    name: str


class PaletteChanged(Message, frozen=True):
    """Other blocks are there than before: fetch the palette anew."""
