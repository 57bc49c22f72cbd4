"""Driving a distance."""

import pytest

from learnblock.devices import Base, Gyroscope
from learnblock.errors import DeviceValueError, StillDrivingError
from learnblock.testing import FakeRobot


@pytest.mark.parametrize("only", [[Base], [Base, Gyroscope]], ids=["wheels", "gyroscope"])
@pytest.mark.parametrize("distance", [300, -120, 0.5, 0])
def test_a_distance_is_driven_by_the_wheels(only, distance):
    with FakeRobot(only=only) as robot:
        robot.drive_distance(distance)

        assert robot.wheels.pose[:2] == pytest.approx((distance, 0), abs=1.5)
        assert robot.commands[-1] == ("Base.move", 0, 0)


def test_it_drives_in_the_direction_that_the_robot_faces():
    with FakeRobot(only=[Base]) as robot:
        robot.wheels.pose = (10, 20, 90)
        robot.drive_distance(100, 50)

        assert robot.wheels.pose == pytest.approx((10, -80, 90), abs=1.5)


def test_a_robot_that_is_pushed_off_its_heading_steers_back():
    with FakeRobot(only=[Base, Gyroscope]) as robot:
        sleep = robot.clock.sleep

        def push(seconds):
            sleep(seconds)
            if robot.clock.time() == pytest.approx(0.2):
                x, y, heading = robot.wheels.pose
                robot.wheels.pose = (x, y, heading + 10)

        robot.clock.sleep = push
        robot.drive_distance(300)

        assert robot.wheels.pose[2] == pytest.approx(0, abs=0.5)


def test_it_drives_no_faster_than_it_is_told():
    with FakeRobot(only=[Base]) as robot:
        robot.drive_distance(200, 50)

        assert max(command[1] for command in robot.commands) == 50


def test_a_stuck_robot_raises_and_stops():
    with FakeRobot(only=[Base]) as robot:
        robot.wheels.stuck = True
        with pytest.raises(StillDrivingError, match="drove only 0 of 100 mm in 3 seconds"):
            robot.drive_distance(100)

        assert robot.commands[-1] == ("Base.move", 0, 0)


@pytest.mark.parametrize("speed", [0, -40])
def test_a_speed_that_is_not_positive_is_refused(speed):
    with FakeRobot(only=[Base]) as robot, pytest.raises(DeviceValueError, match="more than 0"):
        robot.drive_distance(100, speed)
