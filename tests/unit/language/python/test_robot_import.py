"""The import of a program's robot, next to imports of other classes of that name."""

from importlib import metadata
from importlib.metadata import EntryPoint, EntryPoints
from pathlib import Path

import pytest

from learnblock.blocks import builtin
from learnblock.language import check, from_python, to_python
from learnblock.language import format as format_program
from learnblock.language.python.robot_import import for_any_robot, robot_import
from learnblock.language.tree.nodes import SkillCall
from learnblock.language.tree.traversal import all_expressions, statements
from learnblock.project.document.notations import read_python
from learnblock.running.source import source_of
from learnblock.runtime.program import Program
from learnblock.why.edits import edits

OURS = ["learnblock.robots.sim_ebo", "learnblock_home.robots.rover"]
OTHERS = ["gpiozero", "mything", ".x", "..parts.x", ".", "learnblock.robots", "robots.x"]


def program(module):
    return f"from {module} import Robot\n\nrobot = Robot()\n\nrobot.turn(90)\n"


@pytest.mark.parametrize("module", OURS)
def test_a_robot_is_imported_from_a_built_in_module_or_the_users_folder(module):
    assert robot_import(program(module))[1] == module
    assert format_program(from_python(program(module))) == "function.turn(90)\n"


def test_a_robot_is_imported_from_an_installed_package_with_robots(monkeypatch):
    point = EntryPoint("acme-rover", "acme.rover", "learnblock.robots")
    monkeypatch.setattr(metadata, "entry_points", lambda: EntryPoints([point]))
    assert format_program(from_python(program("acme.rover"))) == "function.turn(90)\n"


@pytest.mark.parametrize("module", OTHERS)
def test_another_robot_keeps_its_module_everywhere(module):
    text = program(module)
    assert robot_import(text) is None
    assert for_any_robot(text) == text
    assert to_python(from_python(text), "learnblock.robots.ebo").text == text
    assert to_python(read_python(text)).text == text
    assert source_of(Path("p.py"), text, is_python=True).robot is None


def test_another_robot_makes_another_program():
    ours, user, other = (Program("p.py", text, text) for text in map(program, [*OURS, "gpiozero"]))
    assert (ours.identity == user.identity, ours.identity == other.identity) == (True, False)
    assert edits(ours, user) == ()
    assert [edit.line for edit in edits(ours, other)] == [1]


@pytest.mark.parametrize("module", ["gpiozero", "mything", ".x"])
def test_another_robot_may_have_methods_of_its_own(module):
    text = (
        f"from {module} import Robot\n\nrobot = Robot()\nrobot.turn(90)\nrobot.turm(1)\n"
        "if robot.turn:\n    Robot.turn(robot)\n"
    )
    assert check(from_python(text), builtin(), frozenset(), python=text) == []


@pytest.mark.parametrize(
    "text",
    [
        "import robot.arm\n\nrobot.turn(90)\n",
        "import parts.arm as robot\n\nrobot.turn(90)\n",
        "match x:\n    case {**robot}:\n        robot.turn(90)\n",
        "match x:\n    case [1, *robot]:\n        robot.turn(90)\n",
        "def f():\n    global robot\n    robot.turn(90)\n",
    ],
)
def test_a_program_may_have_another_thing_called_robot(text):
    calls = [
        node
        for item in statements(from_python(text).items)
        for node in all_expressions(item)
        if isinstance(node, SkillCall)
    ]
    assert calls == []
