import pytest

from learnblock.devices import Base
from learnblock.testing import FakeRobot


def test_the_pose_follows_the_drive(robot):
    robot.move_straight(100)
    robot.sleep(2)
    robot.turn_right(90)
    robot.sleep(1)

    assert (200, 0, 90) == pytest.approx(robot.get_pose())


def test_without_odometry_the_pose_is_reckoned_from_the_commands():
    with FakeRobot(only=[]) as robot:
        robot.add(Base(move=lambda adv, rot: None))
        robot.set_move(100, 0)
        robot.sleep(2)
        robot.set_move(0, 45)
        robot.sleep(2)

        assert robot.get_pose() == pytest.approx((200, 0, 90))
        assert robot.near_to_target(200, 0) is True


@pytest.mark.parametrize(("x", "near"), [(100, True), (150, True), (151, False)])
def test_near_is_within_fifty_millimetres_by_default(robot, x, near):
    robot.wheels.pose = (100, 0, 0)

    assert near is robot.near_to_target(x, 0)
    assert robot.near_to_target(x, 0, nearDist=60) is True


@pytest.mark.parametrize(
    ("heading", "ahead", "left", "right"),
    [
        # Clockwise from x: a heading of 90 faces along -y.
        (0, (500, 0), (0, 300), (0, -300)),
        (90, (0, -500), (300, 0), (-300, 0)),
        (180, (-500, 0), (0, -300), (0, 300)),
        (-90, (0, 500), (-300, 0), (300, 0)),
    ],
)
def test_a_position_is_ahead_to_the_left_or_to_the_right(robot, heading, ahead, left, right):
    robot.wheels.pose = (0, 0, heading)

    assert [True, False, False] == [robot.target_at_front(*at) for at in (ahead, left, right)]
    assert robot.target_at_left(*left)
    assert not robot.target_at_left(*right)
    assert robot.target_at_right(*right)
    assert not robot.target_at_right(*left)


@pytest.mark.parametrize(("y", "ahead"), [(20, True), (-20, True), (21, False)])
def test_ahead_is_within_twenty_millimetres_to_either_side(robot, y, ahead):
    assert ahead is robot.target_at_front(500, y)


def test_a_position_behind_is_not_ahead(robot):
    assert not robot.target_at_front(-500, 0)
