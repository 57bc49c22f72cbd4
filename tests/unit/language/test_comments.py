"""No comment is lost, doubled or changed, wherever Python or Block-Text allow one."""

import random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from comment_places import (
    EXAMPLES,
    HEAD,
    UNHARMED,
    apart,
    block_text_places,
    fate,
    library_files,
    python_places,
    same_python,
    squeezed,
    with_comments,
)
from gate import examples
from learnblock.language import format as format_program
from learnblock.language import from_python, parse, to_python
from learnblock.language.tree.nodes import Comment
from workspaces import BlockTrees

every_example = pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
many = settings(suppress_health_check=list(HealthCheck), database=None)
seeds = st.integers(min_value=0, max_value=2**32)

EVENTS = f"""{HEAD}x = 0


def go(a):
    global x
    x = a; robot.turn(a)
    if x > 1: robot.turn(90)
    elif x > (2 + a):
        else_x = 3
    else:
        else_x = 4


@robot.when(lambda: x > 3)
def seen():
    go(1)


# main
go(2)

robot.run()
"""

#: Python with comments that Block-Text has no place for, and Block-Text with them nearby.
MOVED = {
    "above elif": (
        "if x:\n    f()\n# note\nelif y:\n    g()\n",
        "if x:\n    f()\n    # note\nelif y:\n    g()\nend\n",
    ),
    "above else, at any depth": (
        "while x:\n    if x:\n        f()\n\n    # if y:\n        # h()\n    else:\n        g()\n",
        "while x:\n    if x:\n        f()\n\n        # if y:\n        # h()\n"
        "    else:\n        g()\n    end\nend\n",
    ),
    "in the brackets of elif": (
        "if x:\n    f()\nelif (y  # note\n      and z):  # end\n    g()\n",
        "if x:\n    f()\n    # note\nelif y and z:  # end\n    g()\nend\n",
    ),
    "in an else whose first word begins like it": (
        "if x:\n    f()\nelse:  # note\n    else_x = 1\n",
        "if x:\n    f()\nelse:  # note\n    else_x = 1\nend\n",
    ),
    "after two statements": ("a = 1; b = 2  # note\n", "a = 1\nb = 2  # note\n"),
    "after global": (
        "def f():\n    global x  # note\n    x = 1\n",
        "def f():\n    # note\n    x = 1\nend\n",
    ),
    "at a decorator": (
        "@robot.when(  # one\n    lambda: x)  # two\n# three\ndef seen():  # four\n    f()\n\n\n"
        "robot.run()  # five\n",
        "# one\n# two\n# three\nwhen seen = x:  # four\n    f()\nend\n\n# five\n",
    ),
    "in one line": (
        "if x: f()  # one\nelif y: g(  # two\n    1)  # three\n",
        "if x:\n    f()  # one\nelif y:\n    # two\n    g(1)  # three\nend\n",
    ),
}


@pytest.mark.parametrize(("python", "block_text"), MOVED.values(), ids=MOVED)
def test_a_comment_that_has_no_place_in_block_text_moves_to_the_nearest(python, block_text):
    assert block_text == format_program(from_python(HEAD + python))


@pytest.mark.parametrize("words", ["main", "end", "python", "# end", "note"])
def test_a_comment_after_run_is_no_marker(words):
    python = f"{HEAD}@robot.when\ndef go():\n    f()\n\n\nrobot.run()  # {words}\n"
    assert (Comment(words),) == from_python(python).items[-1:]


def test_comments_at_the_import_and_in_the_creation_of_the_robot_move_above_it():
    python = "from learnblock.robots.sim_ebo import Robot  # one\n"
    python += 'robot = Robot(  # two\n    world="line")  # three\n'
    tree = from_python(python)
    assert '# one\n# two\nrobot(world="line")  # three\n' == format_program(tree)
    assert tree == from_python(to_python(parse(format_program(tree))).text)


def test_markers_below_main_are_comments_like_any_other():
    python = HEAD + "# main\nrobot.turn(90)\n# end\n# python\n# note\n# end\n"
    assert format_program(from_python(python)).endswith("\n# python\n# note\n# end\n")


def test_a_colon_in_a_comment_does_not_end_a_line_inside_brackets():
    text = "x = (1\n    if y  # or: z\n    else 2)\n"
    assert "# or: z\nx = 1 if y else 2\n" == format_program(parse(text))


@every_example
def test_comments_at_all_places_of_an_example_survive_from_python(path):
    python = to_python(parse(path.read_text("utf-8"))).text
    places = python_places(python)
    assert same_python(python, with_comments(python, places))
    assert UNHARMED == fate(python, places)


@every_example
def test_comments_at_all_places_of_an_example_survive_from_block_text(path):
    text = path.read_text("utf-8")
    assert UNHARMED == fate(text, block_text_places(text), parse)


def test_a_comment_at_each_place_of_events_and_one_line_statements_survives():
    for place in python_places(EVENTS):
        assert UNHARMED == fate(EVENTS, [place])


@pytest.mark.parametrize("path", library_files(examples(6, gate=2)), ids=lambda path: path.stem)
def test_comments_in_a_file_of_the_standard_library_survive(path):
    text = path.read_text("utf-8")
    assert UNHARMED == fate(text, python_places(text))
    program = HEAD + text
    places = python_places(program)
    assert UNHARMED == fate(program, places)
    assert UNHARMED == fate(program, apart(places, 41)[len(text) % 41])


@settings(many, max_examples=examples(60, gate=20))
@given(seeds)
def test_comments_in_a_random_program_survive(seed):
    choice = random.Random(seed)  # noqa: S311 - no secret
    program = BlockTrees(seed).program()
    python = squeezed(to_python(program).text, choice)
    distance = choice.choice((1, 5, 50))
    assert UNHARMED == fate(python, choice.choice(apart(python_places(python), distance)))
    text = format_program(program)
    assert UNHARMED == fate(text, choice.choice(apart(block_text_places(text), distance)), parse)
