"""The worlds that a project can use.

The simulator takes its time to import, and the server answers before that: the functions import it.
"""

from collections.abc import Iterator

from learnblock.errors import UnknownNameError, WorldError
from learnblock.robots import RobotEntry
from learnblock.server.messages import WorldChoice


def world_choices() -> tuple[WorldChoice, ...]:
    """The worlds there are; a file of the user's own that is no world is not among them."""
    return tuple(_world_choices())


def check_world_name(name: str) -> None:
    """Refuse what is no world of ours or the user's: a project must not name a path.

    Raises:
        UnknownNameError: there is no world of that name.
    """
    from learnblock.robots.simulated import known_worlds  # noqa: PLC0415

    known = known_worlds()
    if name not in known:
        raise UnknownNameError("world", name, known)


def usual_world(entry: RobotEntry) -> str | None:
    """The world in which a simulated robot is by itself; None for one that is not simulated."""
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
        yield WorldChoice(name, world.title, own=(own / f"{name}.toml").is_file())
