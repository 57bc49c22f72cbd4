"""What is said of projects: what there is to choose from, their files, versions and runs."""

from typing import Literal

from msgspec import Struct

from learnblock.server.messages.base import Message, Name, Text
from learnblock.server.messages.worlds import WorldChoice

# The page speaks.


class Open(Message, frozen=True):
    """Open a project; the page then hears `Opened`."""

    name: Name


class New(Message, frozen=True):
    """Make a project and open it.

    Args:
        name: made unique by a number behind it where there is one of that name.
        example: begin with this example, or else with an empty program.
    """

    name: Name = "program"
    example: str | None = None


class Import(Message, frozen=True):
    """Make a project from a file and open it.

    Args:
        filename: ends in .bt, .py or .learnblock.
        text: what stands in it.
    """

    filename: Name
    text: Text


class SaveAs(Message, frozen=True):
    """Go on with a copy of the project under another name."""

    name: Name


class Delete(Message, frozen=True):
    """Delete a project that is not open; it is kept in the folder's trash."""

    name: Name


class Export(Message, frozen=True):
    """Ask for a file of the open project: `File`."""

    format: Literal["bt", "py", "learnblock"]


class ListProjects(Message, frozen=True):
    """Ask for `Projects`."""


class ListHistory(Message, frozen=True):
    """Ask for `History`."""


class Restore(Message, frozen=True):
    """Go back to a version; the present one becomes a version itself."""

    version: Name


# The server speaks.


class RobotChoice(Struct, frozen=True):
    """A robot one can choose; `simulated` ones live in a world."""

    name: str
    title: str
    simulated: bool


class ExampleChoice(Struct, frozen=True):
    """An example to open, with the robot and world that suit it."""

    name: str
    title: str
    description: str
    robot: str
    world: str


class Welcome(Message, frozen=True):
    """The first message of the server."""

    version: str
    robots: tuple[RobotChoice, ...]
    worlds: tuple[WorldChoice, ...]
    examples: tuple[ExampleChoice, ...]
    folder: str


class ProjectEntry(Struct, frozen=True):
    """A project; `changed` is seconds since 1970."""

    name: str
    changed: float


class Projects(Message, frozen=True):
    """Every project, the last changed first."""

    projects: tuple[ProjectEntry, ...]


class Opened(Message, frozen=True):
    """A project is open; a `Document`, a `Scene` and a `RunState` follow."""

    name: str
    robot: str
    world: str
    breakpoints: tuple[str, ...] = ()


class Settings(Message, frozen=True):
    """What is set for the next run, after anyone has changed it."""

    robot: str
    world: str
    breakpoints: tuple[str, ...] = ()


class File(Message, frozen=True):
    """A file to download."""

    filename: str
    text: str


class Version(Struct, frozen=True):
    """A version of the program that one can go back to.

    Args:
        id: for `Restore`.
        time: seconds since 1970.
        reason: why it was kept.
        lines: of its Block-Text.
    """

    id: str
    time: float
    reason: Literal["run", "time", "restored", "opened"]
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
    """What was, the newest first."""

    versions: tuple[Version, ...]
    runs: tuple[PastRun, ...]


class Saved(Message, frozen=True):
    """The project is on disk as it was at `edit`."""

    edit: int


class Failed(Message, frozen=True):
    """A message could not be obeyed; nothing has changed."""

    message: str
    request: str = ""
