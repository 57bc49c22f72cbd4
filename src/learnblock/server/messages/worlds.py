"""What is said of worlds: how one looks, and how it is edited."""

from typing import Any

from msgspec import Struct

from learnblock.server.messages.base import Message, Name

# The page speaks.


class ReadWorld(Message, frozen=True):
    """Ask for a world to edit: `WorldToEdit`."""

    name: Name


class CheckWorld(Message, frozen=True):
    """Ask what is wrong with a world, and how it looks: `WorldChecked`."""

    world: dict[str, Any]


class SaveWorld(Message, frozen=True):
    """Save a world in the user's folder and choose it; `WorldChecked` when it is wrong.

    Args:
        name: to be, and of the file.
        world: its values.
        replace: the user's own world of that name, if there is one; otherwise that is refused.
    """

    name: Name
    world: dict[str, Any]
    replace: bool = False


# The server speaks.


class WorldChoice(Struct, frozen=True):
    """A world one can choose; `own` ones can be edited in place."""

    name: str
    title: str
    own: bool


class Worlds(Message, frozen=True):
    """The worlds there are now, after one was saved."""

    worlds: tuple[WorldChoice, ...]


class Scene(Message, frozen=True):
    """What stands in the world, for drawing it; `Telemetry` moves it.

    Args:
        name: the world's.
        world: as its file says (`WorldFile`).
        lines: for each painted line the corners of its middle, mm.
        robots: name and description of each (`RobotDescription`).
        start: x, y, heading where the next run begins.
    """

    name: str
    world: dict[str, Any]
    lines: tuple[tuple[tuple[float, float], ...], ...]
    robots: tuple[tuple[str, dict[str, Any]], ...]
    start: tuple[float, float, float] | None = None


class WorldToEdit(Message, frozen=True):
    """A world as its file says (`WorldFile`), and the corners of its lines, mm.

    Args:
        save_as: its own name where it is the user's; else a free one, so that none is replaced.
    """

    name: str
    world: dict[str, Any]
    lines: tuple[tuple[tuple[float, float], ...], ...]
    save_as: str


class WorldChecked(Message, frozen=True):
    """What is wrong with a world; `lines` as in `Scene` when nothing is."""

    problems: tuple[str, ...]
    lines: tuple[tuple[tuple[float, float], ...], ...] = ()
