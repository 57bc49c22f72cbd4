"""The stub of all skills is what editors and type checkers see of robots."""

import ast
import inspect
import subprocess
import sys

import pytest

from learnblock import robots
from learnblock.blocks.schema.loading import builtin
from learnblock.client import skill_sets
from learnblock.senses import is_decoration
from learnblock.stubs.skill_sets import class_name, needs_of, stub
from places import ROOT

STUB = ROOT / "src" / "learnblock" / "client" / "skill_sets.pyi"


def methods() -> dict[str, set[str]]:
    """The skills of each class of the stub, with those that it inherits."""
    own: dict[str, set[str]] = {"OwnSkills": set()}
    for node in ast.parse(STUB.read_text("utf-8")).body:
        if isinstance(node, ast.ClassDef):
            inherited = [own[base.id] for base in node.bases if isinstance(base, ast.Name)]
            names = {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
            own[node.name] = names.union(*inherited)
    return own


@pytest.fixture
def defaults(monkeypatch, tmp_path):
    """No settings of a user."""
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))


def test_it_is_what_the_skills_say(defaults):
    assert STUB.read_text("utf-8") == stub(), "run scripts/docs"


@pytest.mark.parametrize("name", robots.built_in())
def test_a_robot_has_the_skills_that_the_check_accepts(name, defaults):
    equipment = robots.find(name).load().known_equipment()
    accepted = {
        block.name
        for block in builtin().values()
        if equipment is None or all(map(is_decoration, block.lacks(equipment)))
    }
    assert accepted == methods()[class_name(name)]


def test_a_skill_with_a_choice_of_senses_needs_any_of_them():
    needs = needs_of(builtin()["get_min_distance"])
    assert (("obstacle-left",), ("obstacle-front",), ("obstacle-right",)) == needs


def test_every_robot_has_its_class():
    for name in robots.built_in():
        kind = robots.find(name).load()
        assert issubclass(kind, getattr(skill_sets, class_name(name)))


#: Gives the classes the skills that robots get at run time, then compares stub and source.
COMPARE = """
import ast, inspect, sys
from mypy import stubtest
from learnblock.client import skill_sets, skills

def method(function):
    def skill(*args, **kwargs): ...
    signature = inspect.signature(function)
    robot, *others = signature.parameters.values()
    skill.__signature__ = signature.replace(parameters=[robot.replace(name="self"), *others])
    return skill

functions = skills.find()
for node in ast.parse(open(sys.argv[1], encoding="utf-8").read()).body:
    if isinstance(node, ast.ClassDef):
        kind = getattr(skill_sets, node.name, None) or type(node.name, (), {})
        setattr(skill_sets, node.name, kind)
        for each in node.body:
            if isinstance(each, ast.FunctionDef):
                setattr(kind, each.name, method(functions[each.name]))
sys.argv[1:] = ["learnblock.client.skill_sets"]
sys.exit(stubtest.main())
"""


@pytest.mark.exhaustive
def test_stubtest_finds_no_difference_to_the_functions(tmp_path):
    command = [sys.executable, "-c", COMPARE, str(STUB)]
    compared = subprocess.run(command, check=False, capture_output=True, text=True, cwd=tmp_path)
    assert "Success: no issues found in 1 module\n" == compared.stdout


def test_the_signature_of_a_skill_is_its_functions_without_the_robot():
    from learnblock.testing import FakeRobot

    with FakeRobot() as robot:
        assert "(angle: float, rotSpeed: float = 120) -> None" == str(inspect.signature(robot.turn))
