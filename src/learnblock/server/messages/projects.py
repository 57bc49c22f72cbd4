"""Messages about projects: choices, files, versions and runs."""

from collections.abc import Mapping
from typing import Annotated, Literal

from msgspec import Meta, Struct, field

from learnblock.i18n import Phrase
from learnblock.project.document.views import LONGEST_TEXT
from learnblock.project.files.history import PastRun, Version
from learnblock.project.files.picture import LARGEST_PICTURE
from learnblock.project.files.project import ProjectEntry
from learnblock.server.messages.base import (
    LONGEST_CONTENT,
    LONGEST_FILE,
    Look,
    Name,
    Own,
    ShortText,
    ToPage,
)
from learnblock.server.messages.worlds import WorldChoice

#: The maximum number of libraries that come with a project.
MOST_BESIDE = 10

Stage = Literal["starter", "explorer", "coder"]

# From the page.


class Open(Look, frozen=True):
    """Open a project; the reply is `Opened`.

    Args:
        name: its name.
        tab: the robot to show; by default, and if there is no such robot, the first one.
    """

    name: Name
    tab: ShortText = ""


class New(Own, frozen=True):
    """Create a project and open it.

    Args:
        name: the name; a number is added if it is taken.
        example: the example to start with; None for an empty program.
        robot: the user's robot, for an empty program and for an example that it can run; empty for
            the default.
        world: the world of an empty program; empty for the default.
        language: the code of the language in which the example speaks.
    """

    name: Name = "program"
    example: str | None = None
    robot: ShortText = ""
    world: ShortText = ""
    language: ShortText = "en"


class OpenExample(Own, frozen=True):
    """Open a project of an example that has not been changed; create one if there is none.

    Args:
        name: the name of a new project; a number is added if it is taken.
        example: the example.
        robot: the user's robot, used if it can run the example; empty for that of the example.
        language: the code of the language in which the example speaks.
    """

    name: Name
    example: Name
    robot: ShortText = ""
    language: ShortText = "en"


class CloseProject(Look, frozen=True):
    """Leave the open project; a page of the server need not have one.

    As when a page is closed, its program continues for a while.
    """


class Import(Own, frozen=True):
    """Import a file as a project and open it.

    Args:
        filename: the file name, ending in .bt, .py or .learnblock.
        text: the text of the file.
    """

    filename: Name
    text: Annotated[str, Meta(max_length=LONGEST_CONTENT)]


class ImportOriginal(Own, frozen=True):
    """Import a file from the original LearnBlock and open it; `OriginalImported` follows.

    Args:
        filename: ends in .blockProject or .lb.
        content: its bytes in base64.
        libraries: the .lb files next to a .blockProject, by the names of the libraries.
    """

    filename: Name
    content: Annotated[bytes, Meta(max_length=LONGEST_FILE)]
    libraries: Annotated[
        dict[Name, Annotated[bytes, Meta(max_length=LONGEST_TEXT)]], Meta(max_length=MOST_BESIDE)
    ] = field(default_factory=dict)


class SaveAs(Own, frozen=True):
    """Continue with a copy of the project under another name."""

    name: Name


class RenameProject(Own, frozen=True):
    """Rename a project and its history.

    Args:
        name: the new name.
        project: a project that no page shows, and `Projects` follows; empty for the open one,
            whose pages receive `ProjectRenamed`.
    """

    name: Name
    project: ShortText = ""


class CopyProject(Own, frozen=True):
    """Copy a project that need not be open; `Projects` follows.

    Args:
        project: its name.
        name: the name of the copy; a number is added if it is taken.
    """

    project: Name
    name: Name


class KeepPicture(Own, frozen=True):
    """Keep a picture of the open project's world for the list of projects, which follows.

    Args:
        project: its name; if it is no longer open, the picture is not kept.
        content: a JPEG in base64.
    """

    project: Name
    content: Annotated[bytes, Meta(max_length=LARGEST_PICTURE)]


class Delete(Own, frozen=True):
    """Move a project that is not open to the trash folder."""

    name: Name


class Export(Look, frozen=True):
    """Ask for a file of a project; the reply is `File`.

    Args:
        format: its type.
        project: the project; empty for the open one.
    """

    format: Literal["bt", "py", "learnblock"]
    project: ShortText = ""


class ListProjects(Look, frozen=True):
    """Ask for `Projects`."""


class ListHistory(Look, frozen=True):
    """Ask for `History`."""


class Restore(Own, frozen=True):
    """Restore a version; the current program is saved as a version too."""

    version: Name


# To the page.


class RobotChoice(Struct, frozen=True, omit_defaults=True):
    """A robot to choose; simulated robots are in a world.

    Args:
        name: its name.
        title: its name for readers.
        simulated: whether it is in a world.
        lacks: the needs of blocks that it can't serve, such as ``Pen``; see `learnblock.senses`.
        serves: what serves each sense that it has.
        given: the name given by the user; empty without one.
        ours: whether it comes with LearnBlock.
    """

    name: str
    title: str
    simulated: bool
    lacks: tuple[str, ...] = ()
    serves: Mapping[str, str] = {}
    given: str = ""
    ours: bool = False


class ExampleChoice(Struct, frozen=True, omit_defaults=True):
    """An example to open, with its kinds of robots and its world.

    Args:
        name: its name.
        title: its title.
        description: what it does.
        robot: the kinds of robots.
        world: the world.
        robots: how many robots there are.
        stage: its level of difficulty.
        is_first: whether it is one of the first programs, which do one task each.
        is_game: whether it is a game to play, and to change.
    """

    name: str
    title: str
    description: str
    robot: str
    world: str
    robots: int = 1
    stage: Stage = "starter"
    is_first: bool = False
    is_game: bool = False


class Welcome(ToPage, frozen=True):
    """The first message of the server.

    Args:
        version: the version of LearnBlock.
        robots: the robots to choose from.
        worlds: the worlds to choose from.
        examples: the examples to open.
        folder: the projects folder.
        read_only: why nothing may be changed; None if it may.
        warns: whether the page warns about missing limits for programs: once for a server
            that other computers can use, to a user at the server's own.
        teaches: whether the page may have what only the teacher has.
        address: the numeric address by which other devices reach the server; None if they can't.
    """

    version: str
    robots: tuple[RobotChoice, ...]
    worlds: tuple[WorldChoice, ...]
    examples: tuple[ExampleChoice, ...]
    folder: str
    read_only: Phrase | None = None
    warns: bool = False
    teaches: bool = False
    address: str | None = None


class Projects(ToPage, frozen=True):
    """All projects, the last changed first."""

    projects: tuple[ProjectEntry, ...]


class Opened(ToPage, frozen=True):
    """A project is open; `Tabs`, a `Document`, a `Scene` and a `RunState` follow.

    Args:
        name: its name.
        robot: the kind of the robot that is shown.
        world: the world.
        breakpoints: those of the robot's program.
        tab: the name of the robot; empty if it is alone.
    """

    name: str
    robot: str
    world: str
    breakpoints: tuple[str, ...] = ()
    tab: str = ""


class ProjectRenamed(ToPage, frozen=True):
    """The open project has another name."""

    name: str


class OriginalImported(ToPage, frozen=True):
    """What an import changed, and what it could not carry over."""

    filename: str
    changed: tuple[Phrase, ...]
    missing: tuple[Phrase, ...]


class Settings(ToPage, frozen=True):
    """The settings of the next run, after a change by any page."""

    robot: str
    world: str
    breakpoints: tuple[str, ...] = ()


class File(ToPage, frozen=True):
    """A file to download."""

    filename: str
    text: str


class History(ToPage, frozen=True):
    """The versions and runs of the project, the newest first."""

    versions: tuple[Version, ...]
    runs: tuple[PastRun, ...]


class Saved(ToPage, frozen=True):
    """The project is saved on disk, up to and including `edit`."""

    edit: int


class TakenIn(ToPage, frozen=True):
    """Another program has changed the project's file, and the project has its changes now."""


class Failed(ToPage, frozen=True):
    """A request failed, and nothing has changed.

    Args:
        message: what happened and what to do.
        refused: the kind of the message that failed; empty if none did.
        request: the number of the message that failed, for the page that waits for its answer.
    """

    message: Phrase
    refused: str = ""
    request: int = 0


class Done(ToPage, frozen=True):
    """A request that the page waits for has been handled, and did not fail."""

    request: int
