"""A real robot's clock for its driver's threads."""

from learnblock.robots.real import RealRobot
from learnblock.robots.settings import RobotSettings
from learnblock.testing import ManualClock
from learnblock.timing import MONOTONIC


class Robot(RealRobot[RobotSettings]):
    """A robot as its author writes it, who knows nothing of clocks."""

    settings_type = RobotSettings

    def connect(self):
        self.seen = self.steady_clock


def test_its_driver_has_the_computers_clock():
    with Robot() as robot:
        assert robot.seen is MONOTONIC


def test_a_test_gives_its_driver_another_one():
    clock = ManualClock()
    with Robot(steady_clock=clock) as robot:
        assert robot.seen is clock
