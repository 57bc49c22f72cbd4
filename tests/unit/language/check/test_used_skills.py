"""The calls of skills in a program, wherever they are."""

import pytest

from learnblock import language, parse, robots
from learnblock.blocks import builtin
from learnblock.language import check
from learnblock.language.check.used_skills import skill_calls

HEADER = "from learnblock.robots.sim_ev3 import Robot\n\nrobot = Robot()\n"


def in_python(text, header=HEADER):
    return [one.name for one in skill_calls(language.from_python(header + text), builtin())]


def in_blocktext(text):
    return [one.name for one in skill_calls(parse(text), builtin())]


@pytest.mark.parametrize(
    "text",
    [
        "x = [robot.is_left_obstacle() for _ in range(2)]\n",
        "look = robot.is_left_obstacle\n",
        "x = getattr(robot, 'is_left_obstacle')()\n",
        "class Pilot:\n    def look(self):\n        return robot.is_left_obstacle()\n",
        "def look(r):\n    return r.is_left_obstacle()\n\nlook(robot)\n",
        "x = robot.is_left_obstacle() if robot.senses.heading() else 1\n",
        "try:\n    x = robot.is_left_obstacle()\nfinally:\n    x = 1\n",
        "x = 1 if (y := robot.is_left_obstacle()) else 2\n",
        "robot.wait_until(lambda: robot.is_left_obstacle() and [y for y in range(2)])\n",
    ],
)
def test_skills_are_found_in_parts_that_stay_python(text):
    assert "is_left_obstacle" in in_python(text)


def test_a_robot_of_any_name_has_skills():
    header = "from learnblock.robots.sim_ev3 import Robot\n\n"
    assert in_python("with Robot() as bot:\n    bot.is_left_obstacle()\n", header) == [
        "is_left_obstacle"
    ]


def test_functions_of_modules_and_methods_of_own_classes_are_no_skills():
    text = (
        "class Page:\n    def turn(self):\n        return 1\n\n[Page().turn() for _ in range(2)]\n"
    )
    assert in_python(text) == []
    assert in_python("import clock\nx = [clock.sleep(1) for _ in range(2)]\n") == []


def test_an_argument_in_python_chooses_a_device_as_in_blocks():
    [found] = skill_calls(
        language.from_python(HEADER + "[robot.led(1, slot='Up') for _ in range(2)]\n"), builtin()
    )
    assert [(one.name, one.value.value) for one in found.keywords] == [("slot", "Up")]


LOOK = "def look():\n    return function.is_any_tag()\nend\n\n"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (LOOK + "main:\n    x = 1\nend\n", []),
        (LOOK + "main:\n    x = look()\nend\n", ["is_any_tag"]),
        (LOOK + "when seen = look():\n    x = 1\nend\n", ["is_any_tag"]),
        (LOOK + "def more():\n    return look()\nend\n\nmain:\n    x = 1\nend\n", []),
        (LOOK + "def more():\n    return look()\nend\n\nx = more()\n", ["is_any_tag"]),
        (LOOK + "main:\n    x = `[look() for _ in range(2)]`\nend\n", ["is_any_tag"]),
        # A file for others to import.
        (LOOK, ["is_any_tag"]),
    ],
)
def test_a_function_that_never_runs_needs_nothing(text, found):
    assert in_blocktext(text) == found


def places(program, python=None):
    have = robots.find("sim-ev3").load().known_equipment()
    found = check(program, builtin(), have, python=python)
    return [(one.line, one.column) for one in found if one.code == "missing-device"]


def test_a_missing_sense_is_reported_at_its_line_in_raw_python():
    text = HEADER + "class Pilot:\n    def look(self):\n        return robot.is_left_obstacle()\n"
    assert places(language.from_python(text), text) == [(6, 16)]


def test_a_missing_sense_is_reported_at_its_line_in_a_python_block():
    text = "main:\n    python:\n        x = 1\n        y = robot.is_left_obstacle()\n    end\nend\n"
    assert places(parse(text)) == [(4, 13)]


def test_a_missing_sense_is_reported_in_a_program_that_stays_python_as_a_whole():
    text = HEADER.replace("robot =", "bot =") + "while bot.is_left_obstacle():\n    bot.turn(9)\n"
    assert places(language.from_python(text), text) == [(4, 7)]
