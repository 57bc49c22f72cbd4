"""Driving a distance, an arc, to a place, and waiting until the robot stands still."""

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


@pytest.mark.parametrize("only", [[Base], [Base, Gyroscope]], ids=["wheels", "gyroscope"])
@pytest.mark.parametrize(
    ("radius", "angle", "end"),
    [
        (200, 90, (200, -200, 90)),
        (200, -90, (200, 200, -90)),
        (100, 360, (0, 0, 360)),
        (10, 180, (0, -20, 180)),
        (200, 0, (0, 0, 0)),
    ],
)
def test_an_arc_ends_where_its_circle_says(only, radius, angle, end):
    with FakeRobot(only=only) as robot:
        robot.drive_arc(radius, angle)

        assert robot.wheels.pose == pytest.approx(end, abs=2)
        assert robot.commands[-1] == ("Base.move", 0, 0)


def test_an_arc_is_driven_no_faster_than_told_and_a_narrow_one_slower():
    fastest = []
    for radius in (300, 20):
        with FakeRobot(only=[Base]) as robot:
            robot.drive_arc(radius, 90, 50)
            fastest.append(max(command[1] for command in robot.commands))

    assert fastest == [50, pytest.approx(31.4, abs=0.1)]


@pytest.mark.parametrize("radius", [0, -20])
def test_a_radius_that_is_not_positive_is_refused(radius):
    with FakeRobot(only=[Base]) as robot, pytest.raises(DeviceValueError, match="more than 0"):
        robot.drive_arc(radius, 90)


def test_a_stuck_robot_says_how_much_of_an_arc_it_drove():
    with FakeRobot(only=[Base]) as robot:
        robot.wheels.stuck = True
        with pytest.raises(StillDrivingError, match="drove only 0 of 157 mm in 3 seconds"):
            robot.drive_arc(100, -90)


@pytest.mark.parametrize("place", [(300, 0), (100, 200), (-150, -80), (0, -30), (1, 0), (0, 0)])
def test_it_goes_to_a_place_wherever_it_is(place):
    with FakeRobot(only=[Base]) as robot:
        robot.go_to(*place)

        assert robot.wheels.pose[:2] == pytest.approx(place, abs=2)


def test_it_comes_back_to_its_start():
    with FakeRobot(only=[Base, Gyroscope]) as robot:
        robot.drive_arc(200, 130)
        robot.go_to(0, 0, advSpeed=150)

        assert robot.wheels.pose[:2] == pytest.approx((0, 0), abs=2)


def test_it_waits_until_it_no_longer_moves_nor_turns():
    with FakeRobot(only=[Base]) as robot:
        sleep, base = robot.clock.sleep, robot.device(Base)

        def stop_after_a_second(seconds):
            sleep(seconds)
            if robot.clock.time() == pytest.approx(1):
                base.stop()

        robot.clock.sleep = stop_after_a_second
        robot.turn_left()
        robot.wait_until_still()

        assert robot.clock.time() == pytest.approx(1.2, abs=0.05)
