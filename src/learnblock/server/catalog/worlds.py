"""The worlds that a project can use.

The functions import the simulator, because it is slow and the server should answer before that.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.errors import UnknownNameError, WorldError
from learnblock.robots import RobotEntry
from learnblock.server.messages import WorldChoice

if TYPE_CHECKING:
    from learnblock.monitor.gallery import WorldDescription


def world_choices() -> tuple[WorldChoice, ...]:
    """The available worlds, without invalid files of the user."""
    return tuple(_world_choices())


def check_world_name(name: str) -> None:
    """Refuse anything but a known world: a project must not contain a path.

    Raises:
        UnknownNameError: there is no world with this name.
    """
    from learnblock.robots.simulated import known_worlds  # noqa: PLC0415

    worlds = known_worlds()
    if name not in worlds:
        raise UnknownNameError("world", name, worlds)


def usual_world(entry: RobotEntry) -> str | None:
    """The default world of a simulated robot; None for a real robot."""
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    robot = entry.load()
    return robot.description().world if issubclass(robot, SimulatedRobot) else None


def _world_choices() -> Iterator[WorldChoice]:
    from learnblock.robots import simulated  # noqa: PLC0415

    own = simulated.own_worlds()
    for name in simulated.known_worlds():
        try:
            world = simulated.find_world(name)
        except WorldError:
            continue
        yield _world_choice(world, own / f"{name}.toml")


def _world_choice(world: "WorldDescription", own: Path) -> WorldChoice:
    """A world; `own` is its file if it is the user's."""
    from learnblock.monitor import gallery  # noqa: PLC0415

    is_own = own.is_file()
    return WorldChoice(
        world.name,
        world.title or world.name,
        own=is_own,
        robots=gallery.robots_for(world),
        group=gallery.group_of(world),
        difficulty=world.difficulty,
        needs=gallery.needs_of(world),
        changed=own.stat().st_mtime if is_own else 0.0,
    )
