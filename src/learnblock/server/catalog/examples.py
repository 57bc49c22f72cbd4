"""The examples that a project can start from."""

from collections.abc import Iterator, Sequence
from functools import cache

from learnblock import robots, running
from learnblock.errors import UnknownNameError
from learnblock.server.messages import ExampleChoice, Stage

#: How the names of the first programs start; some have the name of an example.
_FIRST_NAME = "first-"
#: How the names of the games start, for the same reason.
_GAME_NAME = "game-"
#: A name, a title, a description, a robot, a world and a stage.
_Row = tuple[str, str, str, str, str, Stage]

#: The examples, simplest first, each with a title, a description, a suitable robot and world, and
#: its stage.
_EXAMPLES: tuple[_Row, ...] = (
    ("square", "Square", "Drives a square.", "sim-cozmo", "empty", "starter"),
    ("dance", "Dance", "Dances with feelings.", "sim-cozmo", "empty", "starter"),
    (
        "polygons",
        "Polygons",
        "Drives polygons: functions with parameters, lists.",
        "sim-cozmo",
        "empty",
        "coder",
    ),
    (
        "flower",
        "Flower",
        "Draws a flower: a pen, lists of angles and colours.",
        "sim-thymio",
        "flower",
        "explorer",
    ),
    (
        "avoid",
        "Avoid obstacles",
        "Drives about among obstacles.",
        "sim-ebo",
        "obstacles",
        "explorer",
    ),
    (
        "wall",
        "Follow a wall",
        "Follows walls with the right hand.",
        "sim-thymio",
        "walls",
        "explorer",
    ),
    (
        "labyrinth",
        "Labyrinth",
        "Finds the way through a labyrinth.",
        "sim-ebo",
        "labyrinth",
        "explorer",
    ),
    ("line-ebo", "Line by camera", "Follows a line by camera.", "sim-ebo", "line", "explorer"),
    (
        "line-thymio",
        "Line by ground sensors",
        "Follows a line by ground sensors.",
        "sim-thymio",
        "line",
        "explorer",
    ),
    (
        "line-states",
        "Line with states",
        "Follows a line with states, and searches when lost.",
        "sim-cozmo",
        "line",
        "coder",
    ),
    (
        "tags",
        "Reaction to tags",
        "Searches tags and shows a feeling for each.",
        "sim-ebo",
        "tags",
        "explorer",
    ),
    (
        "tag-tour",
        "Tour of tags",
        "Visits three tags in order, with a function and a list.",
        "sim-ebo",
        "tags",
        "coder",
    ),
    (
        "imitate",
        "Imitate feelings",
        "Goes up to faces and feels as they do.",
        "sim-cozmo",
        "faces",
        "explorer",
    ),
    ("patrol", "Patrol", "Patrols for a minute and reports.", "sim-cozmo", "empty", "explorer"),
    ("melody", "Melody", "Plays a melody.", "sim-cozmo", "stage", "starter"),
    (
        "remote-control",
        "Remote control",
        "Drives as you press the arrow keys.",
        "sim-cozmo",
        "square",
        "starter",
    ),
    ("watch-out", "Watch out", "Stops where there is no ground.", "sim-thymio", "line", "explorer"),
)

#: The first programs, of a few lines each, simplest first.
_FIRST: tuple[_Row, ...] = (
    ("distance", "Half a metre", "Drive 500 mm and stop.", "sim-ebo", "distance", "starter"),
    ("corner", "Turn a corner", "Turn right by 90°.", "sim-thymio", "heading", "starter"),
    ("square", "Drive a square", "Drive four sides with a loop.", "sim-ev3", "square", "starter"),
    (
        "circle",
        "Drive a circle",
        "Drive a circle twice, in arcs.",
        "sim-cozmo",
        "patrol",
        "starter",
    ),
    ("feelings", "Show feelings", "Show three feelings.", "sim-cozmo", "stage", "starter"),
    ("park", "Park the robot", "Stop in front of the wall.", "sim-thymio", "parking", "starter"),
    ("tag", "Find the tag", "Drive until you see tag 3.", "sim-ebo", "tag-ahead", "starter"),
    (
        "face",
        "Smile back",
        "Stop at a happy face, and smile.",
        "sim-cozmo",
        "face-ahead",
        "starter",
    ),
    (
        "traffic-light",
        "Traffic light",
        "Stop at red, drive at green.",
        "sim-thymio",
        "patrol",
        "starter",
    ),
    (
        "edge",
        "Stay on the table",
        "Stop at the edge of the table.",
        "sim-cozmo",
        "edge",
        "explorer",
    ),
    (
        "turn-away",
        "Turn away",
        "Turn away from what is near.",
        "sim-thymio",
        "arena",
        "explorer",
    ),
    ("bump", "Touch the wall", "Drive to the wall and back off.", "sim-ev3", "bumper", "explorer"),
    (
        "caught",
        "Run away",
        "Wake up when you are shaken, and run away.",
        "sim-cozmo",
        "run-away",
        "explorer",
    ),
    (
        "line",
        "Follow the line",
        "Look left and right of the line.",
        "sim-thymio",
        "line",
        "explorer",
    ),
    (
        "there-and-back",
        "There and back",
        "Drive there and back with a function.",
        "sim-cozmo",
        "patrol",
        "explorer",
    ),
    (
        "timer",
        "Five seconds",
        "Drive for five seconds by the timer.",
        "sim-ebo",
        "distance",
        "explorer",
    ),
    (
        "red-line",
        "Follow the red line",
        "Follow the line with the camera.",
        "sim-ebo",
        "red-line",
        "explorer",
    ),
    (
        "reaction",
        "How fast are you?",
        "Measure how fast you are.",
        "sim-ebo",
        "applause",
        "explorer",
    ),
    (
        "guess",
        "Guess the number",
        "Guess the number that the robot thinks of.",
        "sim-ebo",
        "applause",
        "coder",
    ),
    ("quiz", "Quiz of capitals", "Ask for three capitals.", "sim-ebo", "applause", "coder"),
    ("pid", "Steer smoothly", "Follow the line with a control loop.", "sim-ev3", "line", "coder"),
)

#: The games, simplest first.
_GAMES: tuple[_Row, ...] = (
    (
        "stars",
        "Catch the stars",
        "Catch six stars with the arrow keys, and mind the bugs.",
        "sim-cozmo",
        "stars",
        "starter",
    ),
    (
        "race",
        "Race",
        "Race twice around the wall, faster than the roller.",
        "sim-ev3",
        "race-track",
        "starter",
    ),
    (
        "drawing",
        "Drawing by keys",
        "Draw a house with the arrow keys and a pen.",
        "sim-root",
        "drawing",
        "starter",
    ),
    (
        "maze",
        "Maze against the clock",
        "Open the door and find the flag before the time is up.",
        "sim-cozmo",
        "maze-clock",
        "starter",
    ),
    (
        "sumo",
        "Sumo with barrels",
        "Push three barrels out of the ring.",
        "sim-thymio",
        "sumo-barrels",
        "explorer",
    ),
    ("football", "Penalties", "Push the ball past the keeper.", "sim-cozmo", "penalty", "explorer"),
    (
        "delivery",
        "Delivery",
        "Push each parcel to the house of its colour.",
        "sim-spike",
        "delivery",
        "explorer",
    ),
    (
        "tag",
        "Tag",
        "Catch three ghosts, and keep away from the roller.",
        "sim-legoed",
        "tag",
        "explorer",
    ),
    (
        "simon",
        "Simon says",
        "Repeat the robot's tune, note by note.",
        "sim-thymio",
        "simon",
        "explorer",
    ),
    (
        "landing",
        "Space landing",
        "Land softly: gravity pulls, and the up key brakes.",
        "sim-cozmo",
        "landing",
        "explorer",
    ),
    (
        "collector",
        "Collect by itself",
        "The robot collects the stars without a key.",
        "sim-cozmo",
        "stars",
        "explorer",
    ),
)

#: The examples with several robots, each with its programs, and for each the kind of robot and how
#: many run it.
_TEAMS = (
    (
        "sumo",
        "Sumo",
        "Two robots: one pushes the other out of the ring.",
        "sumo",
        (("sumo", "sim-ebo", 1), ("bystander", "sim-thymio", 1)),
    ),
    (
        "relay",
        "Relay",
        "Two robots: the first hands over to the second with a message.",
        "relay",
        (("relay-first", "sim-thymio", 1), ("relay-second", "sim-ebo", 1)),
    ),
    (
        "convoy",
        "Convoy",
        "Two robots: the follower does what the leader's messages say.",
        "convoy",
        (("leader", "sim-ev3", 1), ("follower", "sim-ebo", 1)),
    ),
    (
        "football",
        "Football",
        "Two robots: a striker and a keeper.",
        "football",
        (("striker", "sim-ebo", 1), ("keeper", "sim-thymio", 1)),
    ),
    (
        "race",
        "Race for two",
        "Two players at one keyboard: one has the arrow keys, the other W, A, S and D.",
        "race",
        (("arrows", "sim-thymio", 1), ("wasd", "sim-cozmo", 1)),
    ),
    (
        "swarm",
        "Swarm",
        "Ten robots with one program meet in the middle.",
        "swarm",
        (("swarm", "sim-ebo", 10),),
    ),
)


@cache
def example_choices() -> dict[str, ExampleChoice]:
    """The examples by name."""
    chosen = (*_games(), *_examples(), *_teams(), *_first_programs())
    return {choice.name: choice for choice in chosen}


def example_programs(name: str) -> tuple[tuple[str, str, int], ...]:
    """The programs of an example: the name of the file without its ending, and its robots.

    Raises:
        UnknownNameError: there is no such example.
    """
    chosen = example(name)
    teams = {
        team: tuple((f"several/{program}", robot, count) for program, robot, count in programs)
        for team, _, _, _, programs in _TEAMS
    }
    return teams.get(name, ((_file_of(chosen), chosen.robot, 1),))


def _file_of(chosen: ExampleChoice) -> str:
    if chosen.is_game:
        return f"games/{chosen.name.removeprefix(_GAME_NAME)}"
    return f"first/{chosen.name.removeprefix(_FIRST_NAME)}" if chosen.is_first else chosen.name


def _games() -> Iterator[ExampleChoice]:
    for name, title, description, robot, world, stage in _GAMES:
        yield ExampleChoice(
            _GAME_NAME + name, title, description, robot, world, stage=stage, is_game=True
        )


def _first_programs() -> Iterator[ExampleChoice]:
    for name, title, description, robot, world, stage in _FIRST:
        yield ExampleChoice(
            _FIRST_NAME + name, title, description, robot, world, stage=stage, is_first=True
        )


def _examples() -> Iterator[ExampleChoice]:
    for name, title, description, robot, world, stage in _EXAMPLES:
        yield ExampleChoice(name, title, description, robot, world, stage=stage)


def _teams() -> Iterator[ExampleChoice]:
    for name, title, description, world, programs in _TEAMS:
        number = sum(count for _, _, count in programs)
        yield ExampleChoice(name, title, description, _robots(programs), world, number, "coder")


def suits(robot: str, name: str) -> bool:
    """Whether a robot can run an example without losing any of it.

    Raises:
        UnknownNameError: there is no such robot or example.
    """
    programs = example_programs(name)
    if sum(count for _, _, count in programs) > 1:
        return False
    source = running.read(running.example(f"{programs[0][0]}.bt"))
    return running.check(source, robots.find(robot)) == running.check(source)


def _robots(programs: Sequence[tuple[str, str, int]]) -> str:
    return ", ".join(dict.fromkeys(robot for _, robot, _ in programs))


def example(name: str) -> ExampleChoice:
    """One of the examples.

    Raises:
        UnknownNameError: there is no such example.
    """
    choices = example_choices()
    if name not in choices:
        raise UnknownNameError("example", name, choices)
    return choices[name]
