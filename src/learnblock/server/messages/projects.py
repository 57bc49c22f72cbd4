"""Messages about projects: choices, files, versions and runs."""

from typing import Annotated, Literal

from msgspec import Meta, Struct, field

from learnblock.i18n import Phrase
from learnblock.server.messages.base import (
    LONGEST_CONTENT,
    LONGEST_FILE,
    LONGEST_TEXT,
    Message,
    Name,
)
from learnblock.server.messages.worlds import WorldChoice

#: The maximum number of libraries that come with a project.
MOST_BESIDE = 10

# From the page.


class Open(Message, frozen=True):
    """Open a project; the reply is `Opened`."""

    name: Name


class New(Message, frozen=True):
    """Create a project and open it.

    Args:
        name: the name; a number is added if it is taken.
        example: the example to start with; None for an empty program.
    """

    name: Name = "program"
    example: str | None = None


class Import(Message, frozen=True):
    """Import a file as a project and open it.

    Args:
        filename: the file name, ending in .bt, .py or .learnblock.
        text: the text of the file.
    """

    filename: Name
    text: Annotated[str, Meta(max_length=LONGEST_CONTENT)]


class ImportOriginal(Message, frozen=True):
    """Import a file from the original LearnBlock and open it; `OriginalImported` follows.

    Args:
        filename: ends in .blockProject or .lb.
        content: its bytes in base64.
        libraries: the .lb files that are beside a .blockProject, by the names of the libraries.
    """

    filename: Name
    content: Annotated[bytes, Meta(max_length=LONGEST_FILE)]
    libraries: Annotated[
        dict[Name, Annotated[bytes, Meta(max_length=LONGEST_TEXT)]], Meta(max_length=MOST_BESIDE)
    ] = field(default_factory=dict)


class SaveAs(Message, frozen=True):
    """Continue with a copy of the project under another name."""

    name: Name


class RenameProject(Message, frozen=True):
    """Rename the open project and its history; its pages receive `ProjectRenamed`."""

    name: Name


class Delete(Message, frozen=True):
    """Move a project that is not open to the trash folder."""

    name: Name


class Export(Message, frozen=True):
    """Ask for a file of the open project; the reply is `File`."""

    format: Literal["bt", "py", "learnblock"]


class ListProjects(Message, frozen=True):
    """Ask for `Projects`."""


class ListHistory(Message, frozen=True):
    """Ask for `History`."""


class Restore(Message, frozen=True):
    """Restore a version; the current program is saved as a version too."""

    version: Name


# To the page.


class RobotChoice(Struct, frozen=True):
    """A robot to choose; simulated robots are in a world."""

    name: str
    title: str
    simulated: bool


class ExampleChoice(Struct, frozen=True):
    """An example to open, with its robot and world."""

    name: str
    title: str
    description: str
    robot: str
    world: str


class Welcome(Message, frozen=True):
    """The first message of the server.

    Args:
        version: the version of LearnBlock.
        robots: the robots to choose from.
        worlds: the worlds to choose from.
        examples: the examples to open.
        folder: the projects folder.
        read_only: why nothing may be changed; None if it may.
        warns: whether the page says by itself what does not contain programs: once for a server
            that other computers can use, to a user at the server's own.
    """

    version: str
    robots: tuple[RobotChoice, ...]
    worlds: tuple[WorldChoice, ...]
    examples: tuple[ExampleChoice, ...]
    folder: str
    read_only: Phrase | None = None
    warns: bool = False


class ProjectEntry(Struct, frozen=True):
    """A project; `changed` is seconds since 1970."""

    name: str
    changed: float


class Projects(Message, frozen=True):
    """All projects, the last changed first."""

    projects: tuple[ProjectEntry, ...]


class Opened(Message, frozen=True):
    """A project is open; a `Document`, a `Scene` and a `RunState` follow."""

    name: str
    robot: str
    world: str
    breakpoints: tuple[str, ...] = ()


class ProjectRenamed(Message, frozen=True):
    """The open project has another name."""

    name: str


class OriginalImported(Message, frozen=True):
    """What an import changed, and what it could not carry over."""

    filename: str
    changed: tuple[Phrase, ...]
    missing: tuple[Phrase, ...]


class Settings(Message, frozen=True):
    """The settings of the next run, after a change by any page."""

    robot: str
    world: str
    breakpoints: tuple[str, ...] = ()


class File(Message, frozen=True):
    """A file to download."""

    filename: str
    text: str


class Version(Struct, frozen=True):
    """A version of the program to restore.

    Args:
        id: the id for `Restore`.
        time: the time in seconds since 1970.
        reason: why it was saved.
        lines: the number of lines of its Block-Text.
    """

    id: str
    time: float
    reason: Literal["run", "time", "restored", "outside", "conflict"]
    lines: int


class PastRun(Struct, frozen=True):
    """A run of the program: see `Ended`."""

    time: float
    robot: str
    world: str
    ended: str
    seconds: float
    goals: tuple[str, ...]
    trace_sha256: str
    version: str


class History(Message, frozen=True):
    """The versions and runs of the project, the newest first."""

    versions: tuple[Version, ...]
    runs: tuple[PastRun, ...]


class Saved(Message, frozen=True):
    """The project is saved on disk, up to `edit`."""

    edit: int


class TakenIn(Message, frozen=True):
    """Another program has changed the project's file, and the project has its changes now."""


class Failed(Message, frozen=True):
    """A request failed, and nothing has changed.

    Args:
        message: what happened and what to do.
        request: the kind of the message that failed; empty if none did.
    """

    message: Phrase
    request: str = ""
