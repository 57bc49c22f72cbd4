"""What is said of the program: edits, its three views, completion and help."""

from typing import Annotated, Literal

from msgspec import Meta, Struct

from learnblock.language.workspace import Workspace
from learnblock.server.messages.base import (
    Id,
    Message,
    Name,
    Notation,
    Text,
    View,
)

MOST_BREAKPOINTS = 1000

# The page speaks.


class EditBlocks(Message, frozen=True):
    """The workspace as it is now.

    Args:
        edit: counts the page's edits; the `Document` that answers has the same number.
    """

    edit: int
    workspace: Workspace


class EditText(Message, frozen=True):
    """A text as it is now."""

    edit: int
    notation: Notation
    text: Text


class Undo(Message, frozen=True):
    """Take the last edit back, whichever view it was made in."""


class Redo(Message, frozen=True):
    """Make the last edit that was taken back again."""


class Format(Message, frozen=True):
    """Give Block-Text its canonical form."""


class Rename(Message, frozen=True):
    """Rename a variable, a function or a `when` everywhere; answered by a `Document`."""

    sort: Literal["variable", "function", "when"]
    name: Name
    new: Name


class Complete(Message, frozen=True):
    """Ask for `Completions` at a place (both from 1) of a text as last sent."""

    request: int
    notation: Notation
    line: int
    column: int
    language: Name = "en"


class Describe(Message, frozen=True):
    """Ask for the `Description` of what stands at a place of a text, and where it is defined."""

    request: int
    notation: Notation
    line: int
    column: int
    language: Name = "en"


class SetBreakpoints(Message, frozen=True):
    """Hold the program before these blocks."""

    blocks: Annotated[list[Id], Meta(max_length=MOST_BREAKPOINTS)]


# The server speaks.


class Problem(Struct, frozen=True, omit_defaults=True):
    """An error or a warning.

    Args:
        code: what kind of problem, for tests and help.
        message: what is wrong and what to do.
        severity: an error keeps the program from running.
        view: the text that `line` and `column` speak of; `blocks` where there is a block alone.
        line: from 1; 0 for all of it.
        column: from 1; 0 for the whole line.
        end_column: behind the last character; 0 where it is not known.
        block: the block it belongs to, if any.
    """

    code: str
    message: str
    severity: Literal["error", "warning"]
    view: View
    line: int = 0
    column: int = 0
    end_column: int = 0
    block: str | None = None


class Place(Struct, frozen=True, array_like=True):
    """Where a statement stands in each view: block, and first and last lines from 1 (0 nowhere)."""

    block: str
    blocktext: int
    blocktext_end: int
    python: int
    python_end: int


class Document(Message, frozen=True):
    """The program as it is now; a view that is None has not changed.

    Args:
        edit: the page's last edit that is in it.
        origin: the view that was edited last.
        blocktext: the text, as its author wrote it if they wrote it.
        python: likewise.
        workspace: with ids and places kept.
        places: every statement in all three views.
        problems: of all views.
        stale: the views that show the last good program, since another one has errors.
    """

    edit: int
    origin: View
    blocktext: str | None = None
    python: str | None = None
    workspace: Workspace | None = None
    places: tuple[Place, ...] = ()
    problems: tuple[Problem, ...] = ()
    stale: tuple[View, ...] = ()
    can_undo: bool = False
    can_redo: bool = False


class Completion(Struct, frozen=True, omit_defaults=True):
    """Something that could stand here.

    Args:
        label: what is shown and filtered by.
        insert: what is inserted.
        sort: skill, function, variable, when, keyword, robot, library.
        detail: its parameters.
        help: one sentence.
        category: of a skill, as sets of blocks name it.
    """

    label: str
    insert: str
    sort: str
    detail: str = ""
    help: str = ""
    category: str = ""


class Completions(Message, frozen=True):
    """They replace the text from `from_column` (from 1) to the place that was asked for."""

    request: int
    from_column: int
    options: tuple[Completion, ...]


class Description(Message, frozen=True):
    """What stands at a place.

    Args:
        title: its name with its parameters; empty when there is nothing to say.
        text: what it does.
        needs: devices that it needs and the chosen robot lacks.
        line: where it is defined in the same text, from 1; 0 for nowhere.
        column: likewise.
        from_column: where its name begins.
        to_column: behind its end.
        sort: of what can be renamed (variable, function, when), else empty.
        name: as `Rename` wants it.
    """

    request: int
    title: str = ""
    text: str = ""
    needs: tuple[str, ...] = ()
    line: int = 0
    column: int = 0
    from_column: int = 0
    to_column: int = 0
    sort: Literal["variable", "function", "when", ""] = ""
    name: str = ""
