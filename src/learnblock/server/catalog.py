"""What there is to choose from: robots, worlds and examples."""

from collections.abc import Iterator
from functools import cache
from importlib.metadata import version

from learnblock import robots
from learnblock.errors import LearnBlockError, UnknownNameError, WorldError
from learnblock.server.messages import ExampleChoice, RobotChoice, Welcome, WorldChoice

#: For each example a title, what it does, and the robot and world that suit it. The simplest first.
_EXAMPLES = (
    ("square", "Square", "Drives a square.", "sim-cozmo", "empty"),
    ("dance", "Dance", "Dances with feelings.", "sim-cozmo", "empty"),
    (
        "polygons",
        "Polygons",
        "Drives polygons: functions with parameters, lists.",
        "sim-ev3",
        "empty",
    ),
    ("avoid", "Avoid obstacles", "Drives about among obstacles.", "sim-ev3", "obstacles"),
    ("wall", "Follow a wall", "Follows walls with the right hand.", "sim-thymio", "walls"),
    ("labyrinth", "Labyrinth", "Finds the way through a labyrinth.", "sim-ebo", "labyrinth"),
    ("line-ebo", "Line by camera", "Follows a line by camera.", "sim-ebo", "line"),
    (
        "line-thymio",
        "Line by ground sensors",
        "Follows a line by ground sensors.",
        "sim-thymio",
        "line",
    ),
    (
        "line-states",
        "Line with states",
        "Follows a line with states, and searches when lost.",
        "sim-cozmo",
        "line",
    ),
    (
        "tags",
        "Reaction to tags",
        "Searches tags and shows a feeling for each.",
        "sim-ebo",
        "tags",
    ),
    (
        "tag-tour",
        "Tour of tags",
        "Visits three tags in order, with a function and a list.",
        "sim-ebo",
        "tags",
    ),
    (
        "imitate",
        "Imitate feelings",
        "Goes up to faces and feels as they do.",
        "sim-cozmo",
        "faces",
    ),
    ("patrol", "Patrol", "Patrols for a minute and reports.", "sim-cozmo", "empty"),
    ("watch-out", "Watch out", "Stops where there is no ground.", "sim-thymio", "line"),
)


@cache
def examples() -> dict[str, ExampleChoice]:
    """The examples by name."""
    return {name: ExampleChoice(name, *rest) for name, *rest in _EXAMPLES}


def example(name: str) -> ExampleChoice:
    """One of the examples.

    Raises:
        UnknownNameError: there is none of that name.
    """
    known = examples()
    if name not in known:
        raise UnknownNameError("example", name, known)
    return known[name]


def world_choices() -> tuple[WorldChoice, ...]:
    """The worlds there are; a file of the user's own that is no world is not among them."""
    return tuple(_world_choices())


def check_world_name(name: str) -> None:
    """Refuse what is no world of ours or the user's: a project must not name a path.

    Raises:
        UnknownNameError: there is no world of that name.
    """
    from learnblock.robots.simulated import known_worlds  # noqa: PLC0415 - see `_robot_choice`

    known = known_worlds()
    if name not in known:
        raise UnknownNameError("world", name, known)


def usual_world(entry: robots.RobotEntry) -> str | None:
    """The world in which a simulated robot is by itself; None for one that is not simulated."""
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415 - see `_robot_choice`

    robot = entry.load()
    return robot.description().world if issubclass(robot, SimulatedRobot) else None


def welcome(folder: str) -> Welcome:
    """What a page hears first.

    Args:
        folder: where the projects are.
    """
    return Welcome(
        version=version("learnblock-studio"),
        robots=robot_choices(),
        worlds=world_choices(),
        examples=tuple(examples().values()),
        folder=folder,
    )


def robot_choices() -> tuple[RobotChoice, ...]:
    """The robots there are."""
    return tuple(map(_robot_choice, robots.entries().values()))


def _robot_choice(entry: robots.RobotEntry) -> RobotChoice:
    if entry.simulated is False:
        # The drivers of real robots take their time to be loaded as well.
        return RobotChoice(entry.name, entry.name, simulated=False)
    # The simulator takes its time to be imported, and the server answers before it is.
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    try:
        robot = entry.load()
        simulated = issubclass(robot, SimulatedRobot)
        title = robot.description().title if issubclass(robot, SimulatedRobot) else entry.name
    except LearnBlockError:
        # It is in the list all the same: choosing it says what is wrong with it.
        return RobotChoice(entry.name, entry.name, simulated=False)
    return RobotChoice(entry.name, title or entry.name, simulated)


def _world_choices() -> Iterator[WorldChoice]:
    from learnblock.robots import simulated  # noqa: PLC0415 - see `_robot_choice`

    own = simulated.own_worlds()
    for name in simulated.known_worlds():
        try:
            world = simulated.find_world(name)
        except WorldError:
            continue
        yield WorldChoice(name, world.title, own=(own / f"{name}.toml").is_file())
