"""What functions need, read from their source."""

import ast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.blocks import builtin
from learnblock.blocks.known import all_configurations
from learnblock.blocks.source.uses import dotted, imported_names, uses_of


def needs(source, name="skill"):
    return uses_of(ast.parse(source))[name].needed(builtin())


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("robot.turn(90)", ("Base",)),
        ("robot.get_min_distance(True, False, False)", ("obstacle-left",)),
        ("robot.get_min_distance(left=True, front=False)", ("obstacle-left",)),
        ("robot.senses.distance('back')", ("obstacle-back",)),
        ("robot.senses.heading()", ("heading",)),
        ("robot.read(Camera)", ("Camera",)),
        ("open('notes').read(5)", ()),
        ("robot.senses.line(colour)", ()),
        ("return [one.is_tag(3) for one in robots]", ("Camera",)),
    ],
)
def test_a_function_needs_what_it_asks_for(body, expected):
    assert needs(f"def skill(robot):\n    {body}\n") == expected


def test_a_function_needs_what_functions_of_its_file_need_even_if_they_call_each_other():
    source = (
        "def skill(robot):\n    _look(robot)\n"
        "def _look(who):\n    skill(who)\n    return Eye(who).tag\n"
        "class Eye:\n    def __init__(self, who):\n        self.tag = who.is_tag(1)\n"
        "def other(robot):\n    robot.turn(90)\n"
    )
    assert needs(source) == needs(source, "_look") == ("Camera",)


@pytest.mark.parametrize(
    "body",
    [
        "if robot.has(Camera):\n        robot.is_tag(1)",
        "if not robot.has(Camera):\n        pass\n    else:\n        robot.is_tag(1)",
        "if quick or not robot.has(Camera):\n        return\n    robot.is_tag(1)",
        "for one in (1, 2):\n        if not robot.has(Camera):\n            continue\n"
        "        robot.is_tag(one)",
        "return robot.has(Camera) and robot.is_tag(1)",
        "return robot.is_tag(1) if robot.has(Camera) and quick else False",
    ],
)
def test_what_is_done_only_with_a_device_is_not_needed(body):
    assert needs(f"def skill(robot, quick=True):\n    {body}\n") == ()


@pytest.mark.parametrize(
    "body",
    [
        "if not robot.has(Camera):\n        robot.is_tag(1)",
        "if robot.has(Camera):\n        return False\n    return robot.is_tag(1)",
        "if quick and not robot.has(Camera):\n        return\n    robot.is_tag(1)",
        "return robot.has(Camera) or robot.is_tag(1)",
        "return max(robot.has(Camera), robot.is_tag(1))",
        "if quick or robot.has(Camera):\n        robot.is_tag(1)",
    ],
)
def test_what_may_be_done_without_the_device_is_needed(body):
    assert needs(f"def skill(robot, quick=True):\n    {body}\n") == ("Camera",)


def own_file(monkeypatch, tmp_path, source):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "skills").mkdir()
    (tmp_path / "skills" / "mine.py").write_text(source)


def test_own_skills_need_what_the_skills_need_that_they_call(monkeypatch, tmp_path):
    own_file(
        monkeypatch,
        tmp_path,
        "def first(robot):\n    robot.second()\n    robot.say_Text('hi')\n"
        "def second(robot):\n    robot.turn(9)\n",
    )
    known = all_configurations()
    assert known["first"].needs == ("Base", "Speaker:say")
    assert known["second"].needs == ("Base",)


def test_a_question_is_answered_without_its_decoration(monkeypatch, tmp_path):
    source = "def seen(robot) -> bool:\n    robot.say_Text('hm')\n    return robot.is_tag(1)\n"
    own_file(monkeypatch, tmp_path, source)
    assert all_configurations()["seen"].needs == ("Camera",)


def test_a_configuration_that_names_needs_is_right(monkeypatch, tmp_path):
    own_file(monkeypatch, tmp_path, "def seen(robot):\n    robot.is_tag(1)\n")
    (tmp_path / "blocks").mkdir()
    (tmp_path / "blocks" / "mine.json").write_text(
        '[{"type": "others", "category": "Mine", "name": "seen", "variables": [],'
        ' "shape": ["blockVertical"], "languages": {"EN": "seen"}, "needs": ["Base"]}]'
    )
    assert all_configurations()["seen"].needs == ("Base",)


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("from helpers import look", "look"),
        ("from helpers import look as see", "see"),
        ("from helpers import *", "look"),
        ("import helpers", "helpers.look"),
        ("import helpers as h", "h.look"),
        ("def f():\n    import helpers", "helpers.look"),
    ],
)
def test_an_imported_function_has_the_name_that_the_program_writes(text, written):
    look = uses_of(ast.parse("def look(robot):\n    robot.is_tag(1)\n"))
    found = imported_names(ast.parse(text), lambda module: look if module == "helpers" else {})
    assert found == {written: look["look"]}


@given(st.lists(st.sampled_from("abc"), max_size=9))
def test_a_dotted_name_is_found_again_unless_it_is_long(parts):
    text = ".".join(("x", *parts))
    assert dotted(ast.parse(text, mode="eval").body) == (text if len(parts) <= 5 else "")
