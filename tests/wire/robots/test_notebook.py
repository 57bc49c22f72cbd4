"""A real robot in the kernel of a notebook: Stop and a restart leave it standing.

Root, because nothing in its protocol stops it by itself.
"""

import math

import pytest

from emulated import reachable
from kernels import kernel
from twins import pose, stands_after, x_of
from waiting import wait_for

#: It drives until something stops it.
DRIVES = "robot.move_straight(40)\nwhile True:\n    pass"


@pytest.fixture
def driven():
    """A kernel, and the twin that its `robot` drives."""
    with reachable("root") as twin, kernel() as notebook:
        made = "from learnblock.robots.root import Robot\nrobot = Robot()"
        assert notebook.run(made) == "ok"
        yield notebook, twin


def begin(notebook, twin, code=DRIVES):
    cell, start = notebook.begin(code), x_of(twin)
    wait_for(lambda: x_of(twin) > start + 5, "it drives")
    return cell


@pytest.mark.parametrize("waiting", ["robot.sleep(60)", "while True:\n    pass"])
def test_stop_of_the_notebook_stops_the_wheels_and_keeps_the_robot(driven, waiting):
    notebook, twin = driven
    cell = begin(notebook, twin, f"robot.move_straight(40)\n{waiting}")
    notebook.manager.interrupt_kernel()
    assert notebook.end(cell) == "KeyboardInterrupt"
    assert stands_after(twin) < 0.5
    before = pose(twin)
    assert notebook.run("robot.turn(90)") == "ok"
    assert math.remainder(pose(twin)[2] - before[2] - 90, 360) == pytest.approx(0, abs=10)


def test_a_cell_that_fails_stops_the_wheels_and_one_that_ends_does_not(driven):
    notebook, twin = driven
    assert notebook.run("robot.move_straight(40)") == "ok"
    begun = x_of(twin)
    wait_for(lambda: x_of(twin) > begun + 10, "it drives after the cell")
    assert notebook.run("1 / 0") == "ZeroDivisionError"
    assert stands_after(twin) < 0.5


@pytest.mark.parametrize("now", [False, True])
def test_a_restarted_kernel_leaves_no_robot_running(driven, now):
    notebook, twin = driven
    assert notebook.run("robot.move_straight(40)") == "ok"
    begun = x_of(twin)
    wait_for(lambda: x_of(twin) > begun + 5, "it drives")
    notebook.manager.restart_kernel(now=now)
    assert stands_after(twin) < 1


def test_the_cell_that_connects_runs_again_and_takes_the_robot_over(driven):
    notebook, _ = driven
    texts, _ = notebook.outputs("robot = Robot()")
    assert texts == "The earlier connection to 'root' was closed, since a robot has only one.\n"
    assert notebook.run("robot.turn(10)") == "ok"


def test_it_says_why_it_turned(driven):
    notebook, _ = driven
    notebook.run("robot.turn(90)")
    _, [answer] = notebook.outputs("robot.why('why did it turn right?')")
    assert "line 1 of [2] says turn(90)." in answer["text/plain"]


def test_the_way_of_a_cell_is_shown_without_a_world(driven):
    notebook, _ = driven
    _, [first] = notebook.outputs("robot.show()")
    _, [shown] = notebook.outputs("robot.drive_distance(100)")
    assert "<title>root</title>" in first["image/svg+xml"]
    assert "0.1" in shown["image/svg+xml"].partition(" m in ")[0][-4:]
    assert notebook.outputs("robot.get_pose()")[1][0].keys() == {"text/plain"}
