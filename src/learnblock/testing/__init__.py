"""For the tests of skills, programs and robots: a robot without hardware, in virtual time."""

from learnblock.testing.clock import VirtualClock
from learnblock.testing.robot import FakeRobot
from learnblock.testing.wheels import Wheels

__all__ = ["FakeRobot", "VirtualClock", "Wheels"]
