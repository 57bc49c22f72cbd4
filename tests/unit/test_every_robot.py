"""The page "One program, every robot" says what becomes of each example on each robot."""

import pytest

from every_robot import MISSED, PATIENCE, REACHED, REAL, cell, missed_goals, verdict
from every_robot import written_outcomes as written
from runs import TASKS, TWINS

OUTCOMES = written()
OVER_WIRES = written("wires")
#: What CoppeliaSim's robot has is known only once it is connected.
KNOWN = [robot for robot in REAL if robot != "coppeliasim"]
PAIRS = [(name, robot) for name in OUTCOMES for robot in TWINS]
#: They drive, turn, avoid, follow a line or react to what they see, with sensors on the front.
FOR_THREE = [
    "avoid.bt",
    "first/bump.bt",
    "first/edge.bt",
    "first/line.bt",
    "first/park.bt",
    "line-ebo.bt",
    "line-states.bt",
    "line-thymio.bt",
    "patrol.bt",
    "square.bt",
    "watch-out.bt",
]


def done(cell):
    return cell.partition(",")[0]


def test_the_tables_have_every_example():
    assert list(OUTCOMES) == list(OVER_WIRES) == list(TASKS)


@pytest.mark.parametrize("name", TASKS)
def test_the_tables_say_of_each_robot_what_the_check_says(name):
    written = OUTCOMES[name] | OVER_WIRES[name]
    for robot in (*TWINS, *KNOWN):
        found = verdict(name, robot)
        goal = written[robot].partition(",")[0]
        assert written[robot] == cell(found, goal)


@pytest.mark.slow
@pytest.mark.sample(6)
@pytest.mark.parametrize(
    ("name", "robot"),
    [pair for pair in PAIRS if done(OUTCOMES[pair[0]][pair[1]]) in {REACHED, MISSED}],
)
def test_a_run_ends_as_the_table_says(made, name, robot):
    report = made(name, robot).report
    if report.error is None and missed_goals(report):
        report = made(name, robot, seconds=PATIENCE * TASKS[name][1]).report
    assert report.error is None
    assert done(OUTCOMES[name][robot]) == (MISSED if missed_goals(report) else REACHED)


@pytest.mark.parametrize("name", FOR_THREE)
def test_a_program_reaches_its_goal_on_three_twins_or_more(name):
    assert sum(done(cell) == REACHED for cell in OUTCOMES[name].values()) >= 3
