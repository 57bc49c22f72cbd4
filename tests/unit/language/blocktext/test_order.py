"""Definitions come before their uses in Python, wherever a program has them."""

import ast

import pytest

from learnblock.language import check, from_python, from_workspace, parse, to_python, to_workspace
from learnblock.language import format as format_program
from learnblock.language.check.python_order_checker import early_uses

HALT = "def halt():\n    print(1)\nend\n"
SEARCH = "when search:\n    print(time_search)\nend\n"
EARLY = {
    "a call": ("halt()\n", HALT),
    "a call in a loop": ("repeat 2:\n    halt()\nend\n", HALT),
    "a call in a value": ("x = 1\nprint(halt())\n", HALT),
    "a call through another function": ("def stop():\n    halt()\nend\n\nstop()\n", HALT),
    "a start of an event": ("activate search\n", SEARCH),
    "the state of an event": ("print(state_search)\n", SEARCH),
    "a statement in raw Python": ("python:\n    x = [halt() for _ in [1]]\nend\n", HALT),
    "a function in raw Python": ("python:\n    def f(): halt(); yield\nend\nf()\n", HALT),
    "a value in raw Python": ("x = `[halt() for _ in [1]]`\n", HALT),
    "a call below an import": ('import "dance"\n\nhalt()\n', HALT),
}
every_early_use = pytest.mark.parametrize(("use", "definition"), EARLY.values(), ids=EARLY)


def too_early(python):
    return list(early_uses(ast.parse(python), {"halt", "search", "stop"}))


@every_early_use
def test_a_definition_comes_before_its_use_in_python(use, definition):
    program = parse(f"{use}\n{definition}")
    python = to_python(program).text
    assert [] == too_early(python)
    assert program == from_python(python) == parse(format_program(program))


@every_early_use
def test_blocks_that_were_drawn_in_another_order_are_the_same_program(use, definition):
    program = parse(f"{use}\n{definition}")
    workspace = to_workspace(program, {}).workspace
    workspace.stacks.reverse()
    reversed_program = from_workspace(workspace, {}).program
    assert [] == too_early(to_python(reversed_program).text)
    again = to_workspace(reversed_program, {}, workspace).workspace
    assert sorted(hat.id for hat, *_ in workspace.stacks) == sorted(
        hat.id for hat, *_ in again.stacks
    )


def test_definitions_move_past_a_whole_run_of_statements_with_their_comments():
    text = "# Top\n\nx = 1\n# go\nhalt()\n# stops\n" + HALT + "y = 2\n"
    expected = "# Top\n\n# stops\n" + HALT + "\nx = 1\n# go\nhalt()\ny = 2\n"
    assert expected == format_program(parse(text))


@pytest.mark.parametrize(
    "text",
    [
        "x = 1\n\n" + HALT + "\nhalt()\n",
        "x = 1\n\n" + HALT + "\nmain:\n    halt()\nend\n",
        "print(1)\n\nwhen go = True:\n    halt()\nend\n\n" + HALT,
        "x = 1\n\n" + SEARCH + "\nactivate search\n",
    ],
)
def test_an_order_that_works_stays(text):
    assert text == format_program(parse(text))


def test_events_keep_their_order_when_definitions_move():
    text = "activate second\n\nwhen first = True:\n    pass\nend\n\nwhen second:\n    pass\nend\n"
    python = to_python(parse(text)).text
    assert ["first", "second"] == list(parse(text).whens)
    assert python.index("def first") < python.index("def second") < python.index("activate()")


def test_an_import_and_the_statements_below_moved_definitions_stay_one_stack():
    program = parse('import "dance"\n\nhalt()\n\n' + HALT)
    stacks = to_workspace(program, {}).workspace.stacks
    assert ["lb_start", "procedures_defnoreturn"] == [stack[0].type for stack in stacks]
    assert program == from_workspace(to_workspace(program, {}).workspace, {}).program


PYTHON = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\n"


def early(text):
    python = PYTHON + text
    return [(one.line, one.message.code) for one in check(from_python(python), {}, python=python)]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("halt()\n\n\ndef halt():\n    print(1)\n", 5),
        ("for _ in range(2):\n    halt()\n\n\ndef halt():\n    print(1)\n", 6),
        ("def stop():\n    halt()\n\n\nstop()\n\n\ndef halt():\n    print(1)\n", 6),
        ("go.activate()\n\n\n@robot.when\ndef go():\n    print(1)\n\n\nrobot.run()\n", 5),
        ("a = Dog()\n\n\nclass Dog:\n    pass\n", 5),
        ("robot.wait_until(lambda: halt())\n\n\ndef halt():\n    return True\n", 5),
    ],
)
def test_python_that_uses_what_it_defines_below_is_a_mistake(text, line):
    assert [(line, "check-defined-below")] == early(text)


@pytest.mark.parametrize(
    "text",
    [
        "def stop():\n    halt()\n\n\ndef halt():\n    print(1)\n\n\nstop()\n",
        "print(1)\n\n\ndef print_(x):\n    pass\n",
        "try:\n    halt()\nexcept NameError:\n    pass\n\n\ndef halt():\n    pass\n",
        "f = lambda: halt()\n\n\ndef halt():\n    pass\n\n\nprint(f)\n",
        "def show(halt):\n    print(halt)\n\n\nshow(1)\n\n\ndef halt():\n    pass\n",
    ],
)
def test_python_that_runs_in_its_order_has_no_mistake(text):
    assert [] == early(text)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("print([a for a in [1]])\nprint(a)\na = 1\n", 6),
        ("def show():\n    print(x)\n    yield x\n\n\nshow()\nx = 1\n", 6),
        ("def show():\n    print(x)\n    x = 1\n\n\nshow()\n", 6),
        ("x += 1\nx: int = 3\n", 5),
    ],
)
def test_python_that_reads_what_it_sets_below_is_a_mistake(text, line):
    assert [(line, "check-read-before-set")] == early(text)


@pytest.mark.parametrize(
    "text",
    [
        "print([a for a in [1]])\n",
        "if (n := 3) > 2:\n    print(n)\n",
        "class A:\n    b = 1\n    c = b\n\n\nprint(A)\n",
        "for i in range(3):\n    if i:\n        print(x)\n    else:\n        x = 1\n",
        "def work():\n    global x\n    x = 1\n\n\nmap(work, [])\nprint(x)\n",
    ],
)
def test_python_that_may_have_set_a_variable_has_no_mistake(text):
    assert [] == early(text)


def test_a_warning_on_the_same_line_does_not_hide_a_mistake():
    text = (
        "go.activate()\n\n\n@robot.when(lambda: True)\ndef go():\n    print(1)\n\n\nrobot.run()\n"
    )
    assert [(5, "check-follows-condition-python"), (5, "check-defined-below")] == early(text)
