"""Which robots can run a program."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock import language, parse, robots
from learnblock.blocks import BlockConfiguration, builtin
from learnblock.language import check
from learnblock.language.check.robots import asked, demands, verdict
from learnblock.senses import equipment

TWINS = ("sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo")


def judged(text, robot, read=parse):
    have = robots.find(robot).load().known_equipment()
    return verdict(demands(read(text), builtin()), have)


def named(lacks):
    return {one.skill.name: one.needs for one in lacks}


@pytest.mark.parametrize("robot", TWINS)
def test_a_program_whose_senses_a_robot_serves_runs(robot):
    found = judged("main:\n    function.turn(90)\n    function.set_orientation(0)\nend", robot)
    assert found.runs
    assert found.missed == ()


def test_a_program_that_loses_decoration_runs_without_it():
    found = judged('function.say_Text("hi")\nfunction.expressJoy()', "sim-thymio")
    assert found.runs
    assert named(found.missed) == {"say_Text": ("Speaker:say",)}


def test_a_program_that_loses_a_sense_is_refused():
    text = "while function.is_left_obstacle():\n    function.turn(9)\nend"
    found = judged(text, "sim-ev3")
    assert not found.runs
    assert named(found.refused) == {"is_left_obstacle": ("obstacle-left",)}


def test_a_question_about_decoration_is_refused_as_it_has_no_answer():
    assert named(judged("x = function.is_Joy()", "sim-ev3").refused) == {"is_Joy": ("Display",)}


def test_a_part_that_moves_things_is_no_decoration():
    assert not judged('function.setAngleMotor("ARM", 10)', "sim-ebo").runs
    assert judged('function.setAngleMotor("ARM", 10)', "sim-cozmo").runs


def test_another_gyroscope_than_the_upright_one_is_no_heading():
    assert judged('function.reset_orientation("Z_AXIS")', "sim-ebo").runs
    found = judged('function.reset_orientation("X_AXIS")', "sim-ev3")
    assert named(found.refused) == {"reset_orientation": ("Gyroscope:X_AXIS",)}


def test_calls_that_demand_the_same_are_listed_once():
    text = "function.turn(1)\nfunction.turn(2)\nx = [function.get_light()]"
    assert [one.skill.name for one in demands(parse(text), builtin())] == ["turn", "get_light"]


def test_a_device_that_serves_several_missing_senses_is_named_once():
    found = judged("x = function.is_shaken() or function.is_tilted()", "sim-ebo")
    assert str(found.phrase) == "can't run it: has no accelerometer"


LINE_AND_OBSTACLE = """
when seen = function.is_tag(8):
    function.drive_distance(100)
end
main:
    if function.is_left_ground_line() or function.is_right_ground_line():
        x = function.get_heading()
    elif function.is_front_obstacle(200):
        function.expressJoy()
    end
end
"""


def answers(text, robot):
    have = robot and robots.find(robot).load().known_equipment()
    return asked(demands(parse(text), builtin()), have)


@pytest.mark.parametrize(
    ("robot", "found"),
    [
        ("sim-ev3", ("GroundSensors:line", "DistanceSensors:front", "Gyroscope:Z_AXIS")),
        ("sim-ebo", ("Camera", "DistanceSensors:front", "Base")),
        (None, ("Camera", "GroundSensors:line", "DistanceSensors:front", "Gyroscope:Z_AXIS")),
    ],
)
def test_the_questions_of_a_program_are_answered_by_what_the_robot_has(robot, found):
    assert answers(LINE_AND_OBSTACLE, robot) == found


def test_a_skill_that_answers_nothing_asks_for_nothing():
    assert answers("function.drive_distance(100)\nfunction.set_orientation(0)", "sim-ev3") == ()


@pytest.mark.parametrize(
    ("sides", "needs"),
    [
        ("", ("obstacle-front",)),
        ("left=True", ("obstacle-left", "obstacle-front")),
        ("True, False, False", ("obstacle-left",)),
        ("False, False, False", ("obstacle-left", "obstacle-front", "obstacle-right")),
        # Only the run will tell which of them it looks at.
        ("x, False, x", ("obstacle-left", "obstacle-right")),
    ],
)
def test_the_nearest_obstacle_needs_the_sides_that_are_asked_for(sides, needs):
    [found] = demands(parse(f"x = True\ny = function.get_min_distance({sides})"), builtin())
    assert found.needs == needs


def test_needs_of_parameters_agree_with_those_that_are_listed():
    for block in builtin().values():
        if any(one.needs for one in block.parameters):
            assert block.needed() == block.needs


CALLS = st.lists(st.sampled_from(sorted(builtin())), min_size=1, max_size=4)
NEEDS = st.sampled_from(sorted(equipment(
    ["Base:ROBOT", "Camera:ROBOT", "Gyroscope:Z_AXIS", "Speaker:ROBOT", "Display:ROBOT",
     "GroundSensors:ROBOT", "DistanceSensors:ROBOT", "JointMotor:CAMERA", "Bumper:ROBOT"], None
)))  # fmt: skip


@given(CALLS, st.frozensets(NEEDS))
def test_the_verdict_says_what_the_check_reports(names, have):
    tree = parse("\n".join(f"x = function.{name}()" for name in names))
    found = verdict(demands(tree, builtin()), have)
    severities = [
        one.severity for one in check(tree, builtin(), have) if one.code == "missing-device"
    ]

    assert found.runs == ("error" not in severities)
    assert bool(found.missed) == ("warning" in severities)


@pytest.mark.parametrize(
    ("asked", "needs"),
    [
        ("distance('left')", {"senses.distance": ("obstacle-left",)}),
        ("line('red').left", {"senses.line": ("red-line",)}),
        ("distance(side)", {}),
        ("heading()", {}),
    ],
)
def test_a_sense_that_raw_python_asks_for_is_a_demand(asked, needs):
    text = f"from learnblock.robots.ebo import Robot\n\nrobot = Robot()\nx = robot.senses.{asked}\n"
    found = judged(text, "sim-ev3", language.from_python)
    assert named(found.refused) == needs


def test_a_skill_that_loses_a_part_is_said_to_lose_a_part():
    both = BlockConfiguration("others", "", "dance", needs=("Base", "Speaker:say"))
    have = robots.find("sim-thymio").load().known_equipment()
    skills = {**builtin(), "dance": both}
    (problem,) = language.check(parse("function.dance()"), skills, have)
    assert (problem.message.code, problem.severity) == ("check-skill-partly", "warning")
