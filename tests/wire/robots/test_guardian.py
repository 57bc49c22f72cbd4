"""A robot whose program was killed is stopped by its guardian, which then ends."""

import os
import signal
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import pytest

from emulated import LONG, reachable
from learnblock.errors import RobotConnectionError
from learnblock.ice import Adapter, Servant
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.robots.guardian import Guardian
from learnblock.robots.rcis import Robot, Settings
from processes import runs, wait_until_gone
from twins import let_pass, x_of
from waiting import wait_for

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="looks for processes in /proc")

#: Drives, prints its guardian's process id, and then either waits to be killed or exits at once.
PROGRAM = """
from learnblock.robots.rcis import Robot
import os, signal, sys

robot = Robot()
robot.set_move(60, 0)
print(robot._guardian._process.pid, flush=True)
if "--at-once" in sys.argv:
    os.kill(os.getpid(), signal.SIGKILL)
for _ in range(600):
    robot.sleep(0.1)
    robot.set_move(60, 0)
"""
#: Seconds within which the motors must stop, and the mm that count as standing still.
LIMIT, STILL = 0.5, 1.0


@pytest.fixture
def begin(tmp_path):
    """Run the program; yield its process and its guardian's process id."""
    begun = []

    def begin(*options):
        program = tmp_path / "drive.py"
        program.write_text(PROGRAM)
        command = [sys.executable, program, *options]
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        begun.append(subprocess.Popen(command, text=True, **pipes))
        return begun[-1], int(begun[-1].stdout.readline())

    yield begin
    for process in begun:
        process.kill()
        process.wait()
        process.stdout.close()
        process.stderr.close()


def test_a_killed_program_leaves_neither_a_driving_robot_nor_a_process(begin):
    with reachable("rcis") as twin:
        process, guardian = begin()
        start = x_of(twin)
        wait_for(lambda: x_of(twin) >= start + 20, "it drives")
        assert process.poll() is None
        assert runs(guardian)
        process.send_signal(signal.SIGKILL)
        let_pass(twin, LIMIT)
        there = x_of(twin)
        let_pass(twin, LIMIT)
        assert abs(x_of(twin) - there) < STILL
        wait_until_gone(guardian)


def test_a_guardian_that_has_just_started_stops_the_robot(begin):
    with reachable("rcis") as twin:
        process, guardian = begin("--at-once")
        process.wait()
        wait_until_gone(guardian)
        # Wheels need some time to stop.
        let_pass(twin, 0.2)
        there = x_of(twin)
        let_pass(twin, LIMIT)
        assert abs(x_of(twin) - there) < STILL


def test_a_frozen_program_leaves_no_driving_robot_and_is_told_when_it_wakes(begin):
    with reachable("rcis") as twin:
        process, guardian = begin()
        start = x_of(twin)
        wait_for(lambda: x_of(twin) >= start + 20, "it drives")
        process.send_signal(signal.SIGSTOP)
        wait_until_gone(guardian)
        let_pass(twin, 0.2)
        there = x_of(twin)
        let_pass(twin, LIMIT)
        assert abs(x_of(twin) - there) < STILL
        process.send_signal(signal.SIGCONT)
        assert "This computer was frozen" in process.stderr.read()


def test_a_guardian_that_has_ended_by_itself_is_reported():
    with guarded(Wheels()) as guardian:
        guardian.check()
        os.kill(guardian._process.pid, signal.SIGKILL)
        wait_until_gone(guardian._process.pid)
        with pytest.raises(RobotConnectionError) as error:
            guardian.check()
        guardian.dismiss()
    assert error.value.phrase.code == "robot-guardian-ended"


def test_ctrl_c_does_not_end_a_guardian():
    wheels = Wheels()
    with guarded(wheels) as guardian:
        wait_until_it_ignores_ctrl_c(guardian._process.pid)
        os.kill(guardian._process.pid, signal.SIGINT)
        # Only a guardian that has survived stops the robot.
        guardian.leave_in_charge()
        wait_until_gone(guardian._process.pid)
    assert wheels.told == [(0.0, 0.0)]


def wait_until_it_ignores_ctrl_c(pid):
    bit = 1 << (signal.SIGINT - 1)

    def ignores():
        status = Path(f"/proc/{pid}/status").read_text().split("SigIgn:")[1]
        return int(status.split()[0], 16) & bit

    wait_for(ignores, "it ignores Ctrl-C")


class Wheels:
    def __init__(self):
        self.told = []

    def setSpeedBase(self, adv, rot):  # noqa: N802 - RoboComp's name
        self.told.append((adv, rot))


@contextmanager
def guarded(wheels):
    """Serve a robot's wheels; yield its guardian."""
    with Adapter() as adapter:
        known = interfaces(Layout.TOOL)["differentialrobot"]
        port = adapter.serve({"differentialrobot": Servant(known, wheels)})
        yield Guardian(Robot, Settings(base_port=port, patience=LONG))


def test_a_guardian_that_is_dismissed_does_nothing():
    wheels = Wheels()
    with guarded(wheels) as guardian:
        guardian.dismiss()
        guardian.dismiss()
        assert not runs(guardian._process.pid)
    assert wheels.told == []


def test_a_guardian_left_in_charge_stops_the_robot_and_ends():
    wheels = Wheels()
    with guarded(wheels) as guardian:
        guardian.leave_in_charge()
        wait_until_gone(guardian._process.pid)
    assert wheels.told == [(0.0, 0.0)]
