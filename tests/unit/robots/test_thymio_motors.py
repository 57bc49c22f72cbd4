"""A Thymio's motors: when their command is repeated, and the way that is counted."""

from itertools import pairwise

import pytest

from learnblock.errors import RobotConnectionError
from learnblock.robots.thymio.motors import REPEATING, STANDING, Motors
from learnblock.robots.thymio.program import DRIVE
from learnblock.testing import ManualClock

SPEED = 100


class Link:
    """A robot whose wheels turn at the last speeds that it was told."""

    def __init__(self, clock):
        self.told = []
        self.is_lost = False
        self.always_drives = False
        self._clock = clock
        self._speeds = 0, 0

    def check(self):
        if self.is_lost:
            raise RobotConnectionError("thymio-no-answer", place="there")

    def tell(self, event, *numbers):
        self.check()
        assert event == DRIVE
        self.told.append((round(self._clock.now(), 6), numbers))
        self._speeds = numbers

    def read(self, variable):
        self.check()
        return (self._speeds["right" in variable],)

    def wait(self, condition, seconds):
        while not condition() and seconds > 0:
            self._clock.sleep(0.01)
            seconds -= 0.01
        return condition()


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def link(clock):
    return Link(clock)


@pytest.fixture
def motors(link, clock):
    motors = Motors(link, 100.0, 0.5, clock)
    clock.block_until(1)
    yield motors
    motors.drive(0, 0)
    motors.close()


def test_a_drive_command_is_repeated_with_exactly_its_period(motors, link, clock):
    motors.drive(SPEED, SPEED)
    clock.advance(1.05)
    assert [time for time, _ in link.told] == pytest.approx(
        [REPEATING * count for count in range(11)]
    )


def test_the_robot_is_never_without_a_command_for_longer(motors, link, clock):
    clock.advance(0.07)
    motors.drive(SPEED, SPEED)
    clock.advance(0.5)
    times = [time for time, _ in link.told]
    assert all(later - sooner <= REPEATING + 1e-6 for sooner, later in pairwise(times))


def test_a_robot_that_stands_is_told_nothing(motors, link, clock):
    motors.drive(0, 0)
    clock.advance(1)
    assert link.told == []


def test_a_stop_is_not_overtaken_by_a_repetition(motors, link, clock):
    motors.drive(SPEED, SPEED)
    clock.advance(0.25)
    motors.drive(0, 0)
    clock.advance(1)
    assert link.told[-1] == (0.25, (0, 0))


def test_the_same_command_again_is_not_sent_at_once(motors, link):
    for _ in range(1000):
        motors.drive(SPEED, SPEED)
    assert link.told == [(0, (SPEED, SPEED))]


def test_the_way_is_counted_by_the_time_that_has_passed(motors, clock):
    motors.drive(SPEED, SPEED)
    clock.advance(2)
    # In the first hundredth of a second on average: the mean of two looks.
    assert motors.pose() == pytest.approx((0.5 * SPEED * (2 - 0.01), 0, 0))


def test_a_robot_that_is_lost_is_told_nothing_more(motors, link, clock):
    motors.drive(SPEED, SPEED)
    link.is_lost = True
    clock.advance(1)
    assert link.told == [(0, (SPEED, SPEED))]
    link.is_lost = False


def test_closing_waits_for_the_robot_to_stand_and_not_longer_than_its_limit(link, clock):
    motors = Motors(link, 100.0, 0.5, clock)
    clock.block_until(1)
    link.read = lambda _: (SPEED,)
    clock.run(motors.close)
    assert clock.now() == pytest.approx(STANDING, abs=0.011)
    assert link.told == []
