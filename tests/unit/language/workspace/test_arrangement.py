"""What runs first is drawn first, where the program stays the same."""

import pytest

from learnblock.language import parse
from learnblock.language.tree.nodes import Comment, Def, Main
from learnblock.language.workspace.arrangement import arranged, drawn

SQUARE = "def square():\n    function.turn(90)\nend\n"
EVENT = "when bump = function.is_bumped():\n    pass\nend\n"
MAIN = "main:\n    square()\nend\n"


def order(program):
    """The kinds of what is drawn, from top to bottom."""
    return [
        "main" if type(statement) is Main else getattr(statement, "name", "statement")
        for _, statement in drawn(program)
        if type(statement) is not Comment
    ]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (f"{SQUARE}\n{MAIN}", ["main", "square"]),
        (f"x = 0\n\n{SQUARE}\n{MAIN}", ["statement", "main", "square"]),
        (f"{SQUARE}\nsquare()\n\n{MAIN}", ["statement", "main", "square"]),
        (f"{SQUARE}\nsquare()\n", ["statement", "square"]),
        (f"# How far\nx = 0\n\n# A square\n{SQUARE}\n{EVENT}\n# Go\n{MAIN}", None),
        (f"# By Ada\n\n{SQUARE}\n{MAIN}", ["main", "square"]),
    ],
)
def test_what_runs_first_is_drawn_first(text, expected):
    program = parse(text)
    assert (expected or ["statement", "main", "square", "bump"]) == order(program)
    assert program == arranged(drawn(program))


def test_statements_that_would_move_past_a_function_stay_below_it():
    program = parse(f"{SQUARE}\nx = 0\n\n{MAIN}")
    assert ["main", "square", "statement"] == order(program)


def test_a_comment_below_main_keeps_the_order_of_the_text():
    program = parse(f"{SQUARE}\n{MAIN}\n# The end\n")
    assert ["square", "main"] == order(program)


def test_a_comment_stays_with_its_function():
    program = parse(f"# A square\n{SQUARE}\n{MAIN}")
    [square] = [one for one in drawn(program) if type(one.statement) is Def]
    assert ("A square",) == tuple(one.text for one in square.lead)
