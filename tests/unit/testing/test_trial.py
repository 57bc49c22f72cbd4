"""The test of a real robot's devices."""

from learnblock.devices import Accelerometer, Base, Display, JointMotor, RGBLed, Speaker
from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.testing import FakeRobot
from learnblock.testing.trial import try_out


def test_the_robot_drives_last_and_stops_at_the_end():
    robot = FakeRobot(only=[Base, Display, JointMotor, RGBLed, Speaker])
    tried = list(try_out(robot, lambda question: True))
    assert tried[-1].what == "Base:ROBOT"
    assert all(one.works for one in tried)
    assert ("Base.move", 0.0, 0.0) == robot.commands[-1]


def test_a_device_that_fails_does_not_end_the_test():
    robot = FakeRobot(only=[Base, Display, Speaker])

    def fail(emotion):
        raise RobotConnectionError("the cable is out")

    robot.device(Display).functions["show_emotion"] = fail
    tried = {one.what: one for one in try_out(robot, lambda question: True)}
    assert tried["Display:ROBOT"].detail == Phrase("the cable is out")
    assert tried["Display:ROBOT"].works is False
    assert tried["Base:ROBOT"].works is True


def test_the_base_stops_if_its_odometry_fails():
    robot = FakeRobot(only=[Base])
    base = robot.device(Base)
    poses = iter([(0, 0, 0), (50, 0, 0)])

    def read():
        for pose in poses:
            return pose
        raise RobotConnectionError("lost")

    base.functions["read"] = read
    (tried,) = try_out(robot, lambda question: True)
    assert (tried.works, tried.detail) == (False, Phrase("lost"))
    assert ("Base.move", 0.0, 0.0) == robot.commands[-1]


def test_a_person_decides_what_the_robot_does_and_whether_it_works():
    robot = FakeRobot(only=[Accelerometer, Base, RGBLed])
    answers = {"testing-ask-light": False, "testing-ask-room": False}
    tried = list(try_out(robot, lambda question: answers[question.code]))
    assert [(one.what, one.works, one.detail) for one in tried] == [
        ("Accelerometer:ROBOT", True, Phrase("testing-acceleration", x=0.0, y=0.0, z=9.8)),
        ("RGBLed:Up", False, Phrase("testing-not-seen")),
        ("Base:ROBOT", None, Phrase("testing-not-driven")),
    ]
