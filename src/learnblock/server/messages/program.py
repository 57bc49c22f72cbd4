"""Messages about the program: edits, its three views, completion and help."""

from typing import Annotated, ClassVar, Literal

from msgspec import Meta, Struct

from learnblock.i18n import Phrase
from learnblock.language.workspace.blocks import Workspace
from learnblock.project.document.views import Notation, Place, Problem, View
from learnblock.project.files.project import MOST_BREAKPOINTS, BlockId
from learnblock.project.help import describing
from learnblock.project.help.completion import Completion
from learnblock.server.messages.base import FromReader, Look, Name, Text, ToPage, Write

# From the page.


class EditBlocks(Write, frozen=True):
    """Replace the workspace; what others have changed since stays.

    Args:
        edit: the number of the page's edit; the resulting `Document` has the same number.
        workspace: the workspace after the edit.
        revision: the revision that the page shows, apart from its own edits; 0 for the current one.
        shown: the number of the program that it edits, of `TabOpened`.
    """

    edit: int
    workspace: Workspace
    revision: int = 0
    shown: int = 0


class EditText(Write, frozen=True):
    """Replace a text; what others have changed since stays. See `EditBlocks`."""

    edit: int
    notation: Notation
    text: Text
    revision: int = 0
    shown: int = 0


class RecoverBlocks(Write, frozen=True):
    """Repeat an edit of the blocks that may not have been saved, after a crash for example.

    Args:
        edit: the number of the page's edit.
        workspace: the workspace after the edit.
        base: the workspace that was edited.
        shown: as in `EditBlocks`.
    """

    edit: int
    workspace: Workspace
    base: Workspace
    shown: int = 0


class RecoverText(Write, frozen=True):
    """Repeat an edit of a text that may not have been saved. See `RecoverBlocks`."""

    edit: int
    notation: Notation
    text: Text
    base: Text
    shown: int = 0


class Undo(Write, frozen=True):
    """Undo the last edit in any view."""


class Redo(Write, frozen=True):
    """Redo the last undone edit."""


class Format(Write, frozen=True):
    """Give Block-Text its canonical form."""


class Rename(Write, frozen=True):
    """Rename a variable, a function or a `when` everywhere; the reply is `Document`."""

    sort: Literal["variable", "function", "when"]
    name: Name
    new: Name


class Complete(Look, frozen=True):
    """Ask for `Completions` at a position of a text; line and column are counted from 1."""

    answer: ClassVar = "Completions"

    notation: Notation
    line: int
    column: int
    language: Name = "en"


class Describe(Look, frozen=True):
    """Ask for help on a position of a text, and for its definition; the reply is `Description`."""

    answer: ClassVar = "Description"

    notation: Notation
    line: int
    column: int
    language: Name = "en"


class ReadRunsOn(Look, frozen=True):
    """Ask which robots can run the program; the reply is `RunsOn`."""


class SetBreakpoints(Write, FromReader, frozen=True):
    """Set breakpoints at these blocks."""

    blocks: Annotated[list[BlockId], Meta(max_length=MOST_BREAKPOINTS)]


# To the page.


class Verdict(Struct, frozen=True, omit_defaults=True):
    """Whether a robot can run the program.

    Args:
        robot: its name.
        state: ``without`` if it runs without some decoration; ``unknown`` if the robot's devices
            are known only once it is connected.
        message: the verdict in words, with what the robot lacks.
    """

    robot: str
    state: Literal["runs", "without", "refused", "unknown"]
    message: Phrase


class RunsOn(ToPage, frozen=True):
    """Which robots can run the program."""

    robots: tuple[Verdict, ...]


class Document(ToPage, frozen=True):
    """The current program; a view that is None has not changed.

    Args:
        edit: the page's last edit that it contains.
        revision: counts the changes of the program while it is open.
        origin: the view that was edited last.
        blocktext: the text in Block-Text.
        python: the text in Python.
        workspace: the blocks; ids and positions are preserved.
        places: every statement in all three views.
        problems: the problems in all views.
        stale: the views that show the last good program while another one has errors.
        asked: what answers the program's questions on the chosen robot, such as
            ``DistanceSensors:front``; see `learnblock.senses`.
    """

    edit: int
    revision: int
    origin: View
    blocktext: str | None = None
    python: str | None = None
    workspace: Workspace | None = None
    places: tuple[Place, ...] = ()
    problems: tuple[Problem, ...] = ()
    stale: tuple[View, ...] = ()
    asked: tuple[str, ...] = ()
    can_undo: bool = False
    can_redo: bool = False


class Conflict(ToPage, frozen=True):
    """Two edits changed the same line, and the program has only one of them.

    Args:
        version: the version of the project with the other one; empty if it can't be saved.
        by: which edit is in the version: that of another `page`, that of this page `before` its
            connection was lost, or that of another program in the `file`.
    """

    version: str
    by: Literal["page", "before", "file"]


class Completions(ToPage, frozen=True):
    """Suggestions for the text from `from_column` (from 1) to the requested position."""

    request: int
    from_column: int
    options: tuple[Completion, ...]


class Description(describing.Description, ToPage, frozen=True, kw_only=True):
    """Help on a position of a text."""

    request: int
