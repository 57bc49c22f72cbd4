"""How programs are built: constructs, calls and size."""

import pytest

from learnblock.language import parse
from learnblock.lessons.checks import Construct, Uses
from learnblock.lessons.structure import count, size

PROGRAM = parse(
    """
def jump(height):
    function.led(True)
    return height + 1
end

when near = function.is_obstacle_front():
    print("near")
end

main:
    # A comment.
    steps = [1, 2]
    repeat 4:
        function.turn(90)
        x = jump(jump(2))
    end
    forever:
        if x > 3:
            function.turn(10)
        else:
            break
        end
    end
end
""",
    "p.bt",
)
EXPECTED = {
    "loop": 2,
    "repeat": 1,
    "forever": 1,
    "if": 1,
    "else": 1,
    "when": 1,
    "function": 1,
    "parameter": 1,
    "return": 1,
    "variable": 2,
    "list": 1,
    "print": 1,
    "input": 0,
}


@pytest.mark.parametrize(("construct", "times"), EXPECTED.items())
def test_constructs_are_counted(construct, times):
    assert count(PROGRAM, Uses(construct=construct)) == times


def test_every_construct_is_counted():
    assert {*EXPECTED} == {*Construct.__args__}


def test_calls_of_skills_and_of_own_functions_are_counted():
    assert count(PROGRAM, Uses(skill="turn")) == 2
    assert count(PROGRAM, Uses(function="jump")) == 2
    assert count(PROGRAM, Uses(skill="jump")) == 0


def test_the_size_is_that_of_the_statements_without_heads_and_comments():
    # led, return; when, print; steps, repeat, turn, x, forever, if, turn, break.
    assert size(PROGRAM) == 12
