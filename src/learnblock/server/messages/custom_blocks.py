"""Messages about custom blocks."""

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct, field

from learnblock.i18n import Phrase
from learnblock.server.messages.base import Message, Name, ShortText, Text

#: Of a function.
MOST_ARGUMENTS = 100

# From the page.


class ListCustomBlocks(Message, frozen=True):
    """Ask for `CustomBlocks`."""


class CheckCustomBlock(Message, frozen=True):
    """Check a block and preview it: `CustomBlockChecked`.

    Args:
        request: repeated in the answer.
        name: of its file, without suffix; empty for a new block.
        source: the Python of its functions.
        configuration: the choices for them, as JSON; may be empty.
        replaces: its saved name, which it may keep.
        language: of the previews.
    """

    request: int
    name: ShortText
    source: Text
    configuration: Text = ""
    replaces: ShortText = ""
    language: Name = "en"


class SaveCustomBlock(Message, frozen=True):
    """Save a block. Answers `CustomBlockSaved`, or `CustomBlockChecked` with the request 0.

    Args:
        name: the new name of its file.
        source: see `CheckCustomBlock`.
        configuration: likewise.
        replaces: its name until now; empty for a new block.
    """

    name: Name
    source: Text
    configuration: Text = ""
    replaces: ShortText = ""


class TryCustomBlock(Message, frozen=True):
    """Run one function on the current robot, as a program of one line, without saving it.

    The result is printed; `Ended` follows, with `tried`.

    Args:
        name: see `CheckCustomBlock`.
        source: likewise.
        function: its name; empty for the first one.
        arguments: in the order of the parameters; the rest have their defaults.
    """

    name: ShortText
    source: Text
    function: ShortText = ""
    arguments: Annotated[list[Any], Meta(max_length=MOST_ARGUMENTS)] = field(default_factory=list)


class DuplicateCustomBlock(Message, frozen=True):
    """Copy a block; its functions get free names: `CustomBlockSaved`."""

    name: Name
    new: Name


class DeleteCustomBlock(Message, frozen=True):
    """Delete a block; it can be restored until one of the same name is deleted."""

    name: Name


class RestoreCustomBlock(Message, frozen=True):
    """Restore a deleted block: `CustomBlockSaved`."""

    name: Name


class ExportCustomBlock(Message, frozen=True):
    """Ask for a block as one file: `File`."""

    name: Name


class ImportCustomBlock(Message, frozen=True):
    """Add the block in a file that was exported: `CustomBlockSaved`, or `Failed`.

    Args:
        content: of the file.
        replace: whether to replace a block of the same name; otherwise `Failed`.
    """

    content: Text
    replace: bool = False


# To the page.


class CustomBlockProblem(Struct, frozen=True, omit_defaults=True):
    """An error or a warning about a block.

    Args:
        part: the part that `line` and `column` are about.
        code: the kind of problem, for tests and help.
        message: what happened and what to do.
        severity: a block with an error can't be saved or used.
        line: from 1; 0 for all of it.
        column: from 1; 0 for the whole line.
        end_column: after the last character; 0 if unknown.
    """

    part: Literal["name", "source", "configuration"]
    code: str
    message: Phrase
    severity: Literal["error", "warning"]
    line: int = 0
    column: int = 0
    end_column: int = 0


class CustomBlock(Struct, frozen=True):
    """A file of custom blocks, with one block or several.

    Args:
        name: of the file, without suffix.
        category: the tab of the palette.
        blocks: the names of its functions.
        source: its Python.
        configuration: the choices for them, as JSON; may be empty.
        problems: of both.
    """

    name: str
    category: str
    blocks: tuple[str, ...]
    source: str
    configuration: str
    problems: tuple[CustomBlockProblem, ...] = ()


class CustomBlocks(Message, frozen=True):
    """All custom blocks; sent to every page after each change."""

    blocks: tuple[CustomBlock, ...]


class CustomBlockPreview(Struct, frozen=True):
    """A preview of a block.

    Args:
        name: of the function.
        definition: of the block, in Blockly's JSON.
        block: as in the palette, with its shadow blocks.
    """

    name: str
    definition: dict[str, Any]
    block: dict[str, Any]


class CustomBlockChecked(Message, frozen=True):
    """The problems of a block, and its preview.

    Args:
        request: of the question; 0 if saving failed.
        problems: of the source, the configuration and the name.
        configuration: complete, as JSON: what the source says and what was chosen. Empty where the
            source cannot be read.
        chosen: the same without the words that the source says by itself, such as those of a
            docstring: this is what is saved, and what to send after something was chosen, or else
            an old docstring goes before a new one.
        previews: each block, in the requested language.
    """

    request: int
    problems: tuple[CustomBlockProblem, ...] = ()
    configuration: str = ""
    chosen: str = ""
    previews: tuple[CustomBlockPreview, ...] = ()


class CustomBlockSaved(Message, frozen=True):
    """A block is saved under this name."""

    name: str


class PaletteChanged(Message, frozen=True):
    """The blocks have changed: fetch the palette again."""
