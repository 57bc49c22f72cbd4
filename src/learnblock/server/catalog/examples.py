"""The examples that a project can start from."""

from functools import cache

from learnblock.errors import UnknownNameError
from learnblock.server.messages import ExampleChoice

#: The examples, simplest first, each with a title, a description, and a suitable robot and world.
_EXAMPLES = (
    ("square", "Square", "Drives a square.", "sim-cozmo", "empty"),
    ("dance", "Dance", "Dances with feelings.", "sim-cozmo", "empty"),
    (
        "polygons",
        "Polygons",
        "Drives polygons: functions with parameters, lists.",
        "sim-cozmo",
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
def example_choices() -> dict[str, ExampleChoice]:
    """The examples by name."""
    return {name: ExampleChoice(name, *rest) for name, *rest in _EXAMPLES}


def example(name: str) -> ExampleChoice:
    """One of the examples.

    Raises:
        UnknownNameError: there is no such example.
    """
    known = example_choices()
    if name not in known:
        raise UnknownNameError("example", name, known)
    return known[name]
