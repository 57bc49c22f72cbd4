"""First programs: each does its task on every twin, or the check says why it does not."""

import pytest

from learnblock import running
from runs import EXAMPLES, TASKS, TWINS, run_file

pytestmark = pytest.mark.spread

FIRST = sorted(name for name in TASKS if name.startswith("first/"))
#: What else beginners want: remote control, notes, a pen; programs for two robots are elsewhere.
FIRST += ["flower.bt", "melody.bt", "remote-control.bt"]
#: A lap of a line takes minutes.
SHORT = [name for name in FIRST if TASKS[name][0] not in {"line", "red-line"}]
VERDICTS = {name: running.runs_on(running.read(EXAMPLES / name)) for name in FIRST}
#: A camera sees tags, faces and colours, an accelerometer feels hands: two twins have one.
ON_TWO_TWINS = {"first/caught.bt", "first/face.bt", "first/red-line.bt", "first/tag.bt"}
#: Goals that a robot's body or its sensors miss, although it has all that the program asks for.
MISSED = {
    # Root only feels what it touches.
    ("first/park.bt", "sim-root"),
    ("first/turn-away.bt", "sim-root"),
    # Create 3 is too large to get to these places.
    ("first/bump.bt", "sim-create3"),
    ("first/park.bt", "sim-create3"),
}
DRIVE_ON = """
main:
    function.move_straight(60)
    function.sleep(60)
end
"""


def runs_wholly(name, robot):
    verdict = VERDICTS[name][robot]
    return verdict.runs and not verdict.missed and (name, robot) not in MISSED


@pytest.mark.parametrize(
    ("name", "robot"),
    [(name, robot) for name in SHORT for robot in TWINS if runs_wholly(name, robot)],
)
def test_a_program_that_runs_wholly_reaches_every_goal(made, name, robot):
    report = made(name, robot).report
    assert report.error is None
    assert {goal.state for goal in report.goals} == {"reached"}


@pytest.mark.slow
@pytest.mark.parametrize("robot", ["sim-thymio", "sim-ev3"])
def test_a_control_loop_follows_a_line_by_sensors_under_the_robot(made, robot):
    report = made("first/pid.bt", robot).report
    assert {goal.state for goal in report.goals} == {"reached"}


@pytest.mark.parametrize("name", FIRST)
def test_a_program_runs_on_three_twins_unless_it_needs_a_sense_that_only_two_have(name):
    count = sum(VERDICTS[name][robot].runs for robot in TWINS)
    assert count == 2 if name in ON_TWO_TWINS else count >= 3


@pytest.mark.parametrize(
    "world", sorted({TASKS[name][0] for name in SHORT} - {"applause", "stage"})
)
def test_a_robot_that_only_drives_straight_on_does_not_reach_the_goals(world, tmp_path):
    program = tmp_path / "program.bt"
    program.write_text(DRIVE_ON.removeprefix("\n"))
    report = run_file(program, "sim-ev3", world=world, seconds=65).report
    assert {goal.state for goal in report.goals} & {"open", "failed"}


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("first/guess.bt", "Yes, it is "),
        ("first/quiz.bt", "3 of 3: great!\n"),
        ("first/reaction.bt", " seconds.\n"),
    ],
)
def test_a_program_asks_and_answers(made, name, said):
    printed = "".join(f"{line['print']}\n" for line in made(name, "sim-ebo").entries("print"))
    assert said in printed
