"""Checks of the end of a client: its motors stop, and the next client can connect."""

import math

from learnblock.client import Client
from learnblock.devices import Base, Sensor
from learnblock.errors import RobotConnectionError, RobotStoppedError
from learnblock.testing.bench import Bench, BrokenClaimError, require
from learnblock.testing.driving_claims import pose

#: The seconds within which the motors must stop.
STOPPING = 0.5


def stops(bench: Bench) -> str:
    """Check that the motors stop after `stop`, at the end of `with`, and after an error."""
    for end in (_by_stop, _by_leaving, _by_error):
        robot = bench.make()
        if base := robot.device(Base):
            base.move(50, 20)
        with bench.in_time("stopping", STOPPING):
            end(robot)
        require(robot.stopped, f"it is not stopped after its end {end.__name__.replace('_', ' ')}")
        _require_mute(robot)
        _require_rest(bench)
    return "by stop, by leaving with, by an error"


def _by_stop(robot: Client) -> None:
    robot.stop()


def _by_leaving(robot: Client) -> None:
    with robot:
        pass


def _by_error(robot: Client) -> None:
    try:
        with robot:
            raise ZeroDivisionError
    except ZeroDivisionError:
        return


def _require_mute(robot: Client) -> None:
    try:
        robot.device(Base)
    except RobotStoppedError:
        return
    raise BrokenClaimError("it still returns devices after it was stopped")


def _require_rest(bench: Bench) -> None:
    """Check with a second client that the robot does not move."""
    with bench.robot() as robot:
        base = robot.device(Base)
        if base is None or not base.has_odometry:
            return
        before = pose(base)
        robot.clock.sleep(0.5)
        after = pose(base)
    moved = math.dist(before[:2], after[:2])
    require(moved < 10, f"it moved another {moved:.0f} mm after its end")


def stops_twice(bench: Bench) -> str:
    """Check that a second `stop` is harmless."""
    robot = bench.make()
    robot.stop()
    robot.stop()
    return ""


def reconnects(bench: Bench) -> str:
    """Check that clients can connect one after the other."""
    for _ in range(3):
        with bench.robot() as robot, bench.in_time("a reading"):
            for _, device in robot.devices():
                if isinstance(device, Sensor):
                    device.read()
    return "three times"


def answers_second_client(bench: Bench) -> str:
    """Check that a second client is served or rejected within the timeout."""
    with bench.robot():
        try:
            with bench.in_time("a second client"):
                bench.make().stop()
        except RobotConnectionError as refusal:
            return f"a second one is rejected: {refusal}"
    return "a second one is served"
