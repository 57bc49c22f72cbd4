"""A person has a robot do something without a program, and can halt it."""

import math
import threading

import pytest

from learnblock.client import Client
from learnblock.devices import Base, Display, RGBLed, Speaker
from learnblock.errors import RobotConnectionError
from learnblock.robots.calibration import Calibration
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import RobotSettings
from learnblock.running.hands import ACTIONS, Hands, InterruptedActionError, possible
from learnblock.testing import VirtualClock, Wheels


class Rover(RealRobot[RobotSettings]):
    """Wheels, a face, a lamp and a speaker."""

    settings_type = RobotSettings
    calibration = Calibration("radius", "track")

    def connect(self):
        self.shown = []
        self.wheels = Wheels(self.clock)
        self.add(Base(self.wheels.move, lambda: self.wheels.pose))
        self.add(Display(self.shown.append))
        self.add(RGBLed(lambda *colour: self.shown.append(colour)))
        self.add(Speaker(tone=lambda hertz, milliseconds: self.shown.append("beep")))


@pytest.fixture
def rover(own_home):
    with Rover(clock=VirtualClock()) as rover:
        yield rover


def act(robot, action):
    ACTIONS[action](Hands(robot, threading.Event()))


def test_the_test_of_the_wheels_drives_50_mm_forward_and_back(rover):
    reached = []
    move = rover.wheels.move

    def noted(adv, rot):
        reached.append(rover.wheels.pose[0])
        move(adv, rot)

    rover.device(Base).functions["move"] = noted
    act(rover, "wheels")
    assert reached == pytest.approx([0, 50, 0], abs=1)
    assert rover.device(Base).speed == (0, 0)


@pytest.mark.parametrize(
    ("action", "shown"), [("face", "joy"), ("lamps", (255, 160, 0)), ("beep", "beep")]
)
def test_faces_lamps_and_speakers_are_tried(rover, action, shown):
    act(rover, action)
    assert rover.shown[0] == shown


def test_it_drives_500_mm_by_its_own_measure(rover):
    act(rover, "distance")
    x, y, _ = rover.wheels.pose
    assert math.hypot(x, y) == pytest.approx(500, abs=5)


def test_it_turns_once_by_its_own_measure(rover):
    act(rover, "angle")
    assert rover.wheels.pose[2] % 360 == pytest.approx(0, abs=3)
    assert rover.clock.time() == pytest.approx(6, abs=0.2)


def test_a_robot_that_cannot_get_there_is_said(rover):
    rover.device(Base).functions["read"] = lambda: (0.0, 0.0, 0.0)
    with pytest.raises(RobotConnectionError, match="did not get"):
        act(rover, "distance")


@pytest.mark.parametrize("action", ACTIONS)
def test_everything_can_be_halted(rover, action):
    halting = threading.Event()
    halting.set()
    with pytest.raises(InterruptedActionError):
        ACTIONS[action](Hands(rover, halting))


def test_a_broken_link_ends_what_is_under_way(rover):
    def broken():
        raise RobotConnectionError("cozmo-silent", place="there", seconds=3)

    rover.check_link = broken
    with pytest.raises(RobotConnectionError):
        act(rover, "wheels")


def test_only_what_a_robot_has_is_offered(rover):
    assert possible(rover) == ("wheels", "face", "beep", "distance", "angle")
    assert possible(Client(clock=VirtualClock())) == ()


def test_lamps_are_offered_where_there_is_no_face(own_home):
    class Lamp(Client):
        def connect(self):
            self.add(RGBLed(lambda *colour: None))

    assert possible(Lamp(clock=VirtualClock())) == ("lamps",)
