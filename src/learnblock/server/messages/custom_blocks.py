"""Messages about custom blocks."""

from typing import Annotated, Any, ClassVar, Literal

from msgspec import Meta, Struct, field

from learnblock.i18n import Phrase
from learnblock.server.messages.base import (
    FileText,
    FromReader,
    Look,
    Name,
    Own,
    Pace,
    ShortText,
    Text,
    ToPage,
)

#: The name of a function.
MOST_ARGUMENTS = 100

# From the page.


class ListCustomBlocks(Look, frozen=True):
    """Ask for `CustomBlocks`."""


class CheckCustomBlock(Look, frozen=True):
    """Check a block and preview it; the reply is `CustomBlockChecked`.

    Args:
        name: the name of its file, without suffix; empty for a new block.
        source: the Python source of its functions.
        configuration: the choices for them, as JSON; may be empty.
        replaces: its saved name, which may be the same as `name`.
        language: the language of the previews.
    """

    answer: ClassVar = "CustomBlockChecked"

    name: ShortText
    source: Text
    configuration: Text = ""
    replaces: ShortText = ""
    language: Name = "en"


class SaveCustomBlock(Own, frozen=True):
    """Save a block; the reply is `CustomBlockSaved`, or `CustomBlockChecked` if it has errors.

    Args:
        name: the new name of its file.
        source: see `CheckCustomBlock`.
        configuration: see `CheckCustomBlock`.
        replaces: its previous name; empty for a new block.
    """

    answer: ClassVar = "CustomBlockChecked"

    name: Name
    source: Text
    configuration: Text = ""
    replaces: ShortText = ""


class TryCustomBlock(Own, FromReader, frozen=True):
    """Run one function on the current robot, as a program of one line, without saving it.

    The result is printed; `Ended` follows, with `tried`.

    Args:
        name: see `CheckCustomBlock`.
        source: see `CheckCustomBlock`.
        function: the name of the function; empty for the first one.
        arguments: the values in the order of the parameters; the rest have their defaults.
    """

    pace: ClassVar = Pace(minute=20, burst=5)

    name: ShortText
    source: Text
    function: ShortText = ""
    arguments: Annotated[list[Any], Meta(max_length=MOST_ARGUMENTS)] = field(default_factory=list)


class DuplicateCustomBlock(Own, frozen=True):
    """Copy a block; its functions get free names; the reply is `CustomBlockSaved`."""

    name: Name
    new: Name


class DeleteCustomBlock(Own, frozen=True):
    """Delete a block; it can be restored until another block with the same name is deleted."""

    name: Name


class RestoreCustomBlock(Own, frozen=True):
    """Restore a deleted block; the reply is `CustomBlockSaved`."""

    name: Name


class ExportCustomBlock(Look, frozen=True):
    """Ask for a block as one file; the reply is `File`."""

    name: Name


class ImportCustomBlock(Own, frozen=True):
    """Add the block in an exported file; the reply is `CustomBlockSaved`, or `Failed`.

    Args:
        content: the content of the file.
        replace: whether to replace a block with the same name; otherwise `Failed`.
    """

    content: FileText
    replace: bool = False


# To the page.


class CustomBlockProblem(Struct, frozen=True, omit_defaults=True):
    """An error or a warning about a block.

    Args:
        part: the part that `line` and `column` are about.
        code: the kind of problem, for tests and help.
        message: what happened and what to do.
        severity: a block with an error can't be saved or used.
        line: the line, from 1; 0 for all of it.
        column: the column, from 1; 0 for the whole line.
        end_column: the column after the last character; 0 if unknown.
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
        name: the name of the file, without suffix.
        category: the tab of the palette.
        blocks: the names of its functions.
        source: the Python source.
        configuration: the choices for them, as JSON; may be empty.
        problems: the problems of both.
    """

    name: str
    category: str
    blocks: tuple[str, ...]
    source: str
    configuration: str
    problems: tuple[CustomBlockProblem, ...] = ()


class CustomBlocks(ToPage, frozen=True):
    """All custom blocks; sent to every page after each change."""

    blocks: tuple[CustomBlock, ...]


class CustomBlockPreview(Struct, frozen=True):
    """A preview of a block.

    Args:
        name: the name of the function.
        definition: the definition of the block, in Blockly's JSON.
        block: the block as in the palette, with its shadow blocks.
    """

    name: str
    definition: dict[str, Any]
    block: dict[str, Any]


class CustomBlockChecked(ToPage, frozen=True):
    """The problems of a block, and its preview.

    Args:
        request: the number of the request: a check, or saving that failed.
        problems: the problems of the source, the configuration and the name.
        configuration: complete, as JSON: from the source and from the choices. Empty if the
            source cannot be parsed.
        chosen: the same without what is already in the source, such as the words of a
            docstring: this is saved, and should be sent after a new choice, because otherwise
            an old docstring would override a new one.
        previews: a preview of each block, in the requested language.
    """

    request: int
    problems: tuple[CustomBlockProblem, ...] = ()
    configuration: str = ""
    chosen: str = ""
    previews: tuple[CustomBlockPreview, ...] = ()


class CustomBlockSaved(ToPage, frozen=True):
    """A block is saved under this name."""

    name: str


class PaletteChanged(ToPage, frozen=True):
    """The blocks have changed: fetch the palette again."""
