"""What a condition found, in words, with the reading behind it."""

import pytest

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import CONDITIONS
from learnblock.why.readings import Readings
from learnblock.why.slices import Slices
from logged_runs import logged_text


def fact(folder, condition, robot="sim-ebo", world="arena"):
    """The first fact of a condition, as its code and words."""
    program = f"x = 3\nif {condition}:\n    pass\nend\n"
    # Some robots lack the sense that is asked for.
    options = {"world": world, "seconds": 2, "seed": 0, "anyway": True}
    history = logged_text(folder, program, robot, **options).history
    asked = next(
        index
        for index, event in enumerate(history.events)
        if event[0] == Op.CONDITION and history.node(index).kind in CONDITIONS
    )
    [first, *_] = Readings(Slices(history)).facts(asked)
    return first.code, str(first)


@pytest.mark.parametrize(
    ("condition", "robot", "world", "told"),
    [
        ("x > 2", "sim-ebo", "arena", ("why-name-was", "x was 3")),
        (
            "function.is_front_obstacle(900)",
            "sim-ebo",
            "arena",
            ("why-measured-limit", "less than 900 mm"),
        ),
        (
            "function.is_front_obstacle()",
            "sim-ebo",
            "arena",
            ("why-measured-limit", "not less than 200 mm"),
        ),
        (
            "function.get_min_distance() < 5",
            "sim-ebo",
            "arena",
            ("why-measured", "the front sensor"),
        ),
        ("function.is_front_obstacle()", "sim-thymio", "empty", ("why-saw-nothing", "saw nothing")),
        ("function.is_back_obstacle()", "sim-ebo", "arena", ("why-never-answers", "has no")),
        ("function.is_right_obstacle()", "sim-ev3", "arena", ("why-never-answers", "has no")),
        ("function.is_there_ground()", "sim-thymio", "table", ("why-ground-saw", "on the left")),
        ("function.is_any_tag()", "sim-ebo", "empty", ("why-saw-no-tag", "saw no tag")),
        (
            "function.is_there_black_line()",
            "sim-ebo",
            "empty",
            ("why-saw-no-line", "saw nothing black"),
        ),
        ("elapsedTime(3)", "sim-ebo", "empty", ("why-time-was", "not more than 3 s")),
        ("function.is_moving_left()", "sim-ebo", "empty", ("why-answered", "answered no")),
    ],
)
def test_a_fact_names_its_reading(tmp_path, condition, robot, world, told):
    found, text = fact(tmp_path, condition, robot, world)
    code, words = told
    assert (found, words in text) == (code, True), text
