"""What a person is told of a robot that is tried out."""

from learnblock.devices import Base, Display, JointMotor, RGBLed, Speaker
from learnblock.errors import RobotConnectionError
from learnblock.testing import FakeRobot
from learnblock.testing.trial import try_out


def test_what_moves_is_tried_last_and_stands_still_in_the_end():
    robot = FakeRobot(only=[Base, Display, JointMotor, RGBLed, Speaker])
    tried = list(try_out(robot, lambda question: True))
    assert tried[-1].what == "Base:ROBOT"
    assert all(one.works for one in tried)
    assert ("Base.move", 0.0, 0.0) == robot.commands[-1]


def test_a_device_that_fails_does_not_end_the_trial():
    robot = FakeRobot(only=[Base, Display, Speaker])

    def fail(emotion):
        raise RobotConnectionError("the cable is out")

    robot.device(Display).functions["show_emotion"] = fail
    tried = {one.what: one for one in try_out(robot, lambda question: True)}
    assert tried["Display:ROBOT"].detail == "the cable is out"
    assert tried["Display:ROBOT"].works is False
    assert tried["Base:ROBOT"].works is True


def test_the_base_stops_where_the_drive_fails():
    robot = FakeRobot(only=[Base])
    base = robot.device(Base)
    poses = iter([(0, 0, 0), (50, 0, 0)])

    def read():
        for pose in poses:
            return pose
        raise RobotConnectionError("lost")

    base.functions["read"] = read
    (tried,) = try_out(robot, lambda question: True)
    assert (tried.works, tried.detail) == (False, "lost")
    assert ("Base.move", 0.0, 0.0) == robot.commands[-1]
