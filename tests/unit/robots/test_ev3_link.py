"""The times of the connection to an EV3: its pulse, its repetitions, and its limits."""

import threading
from collections import deque

import pytest

from learnblock.errors import RobotBusyError, RobotConnectionError
from learnblock.robots.ev3.brick import Drive, Look, State
from learnblock.robots.ev3.link import FRESH, PULSE, BrickLink
from learnblock.robots.ev3.ways import PAUSE, TIMEOUT, when_free
from learnblock.robots.ev3.wires import LONGEST_WRITE, DeviceFile, Stream
from learnblock.testing import ManualClock


class Wire(BrickLink):
    """Records what it says, and when."""

    def __init__(self, clock):
        super().__init__("there", lambda state: None, clock)
        self.said = []
        self.error = None
        self._time = clock.now

    def exchange(self, word):
        self.said.append((round(self._time(), 6), word))
        if self.error:
            raise self.error
        return State(0, 0)

    def hang_up(self):
        """Do nothing: there is no wire."""

    def times(self, kind):
        return [time for time, word in self.said if isinstance(word, kind)]


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def link(clock):
    link = Wire(clock)
    link.begin()
    clock.block_until(1)
    yield link
    link.close()


def test_an_idle_program_says_something_with_each_pulse(link, clock):
    clock.advance(0.55)
    assert link.times(Look) == pytest.approx([PULSE * count for count in range(6)])


def test_the_last_drive_command_is_repeated_with_each_pulse(link, clock):
    clock.advance(0.05)
    link.say(Drive(10, 10))
    clock.advance(0.5)
    assert link.times(Drive) == pytest.approx([0.05 + PULSE * count for count in range(6)])


def test_it_is_repeated_as_often_while_the_program_reads_sensors(link, clock):
    link.say(Drive(10, 10))
    for _ in range(50):
        clock.advance(0.02)
        link.latest()
    assert link.times(Drive) == pytest.approx([PULSE * count for count in range(11)])


def test_a_stop_is_not_repeated(link, clock):
    link.say(Drive(10, 10))
    link.say(Drive(0, 0))
    clock.advance(1)
    assert len(link.times(Drive)) == 2


def test_a_state_serves_other_sensors_for_a_hundredth_of_a_second(link, clock):
    clock.advance(FRESH - 0.001)
    link.latest()
    assert link.times(Look) == [0]
    clock.advance(0.001)
    link.latest()
    assert link.times(Look) == [0, FRESH]


def test_a_brick_that_reports_an_error_is_asked_no_more_often(link, clock):
    link.error = RobotConnectionError("ev3-motor-lost")
    clock.advance(0.5)
    assert link.times(Look) == pytest.approx([PULSE * count for count in range(6)])


def test_a_broken_link_says_nothing_more(link, clock):
    link.error = TimeoutError()
    clock.advance(1)
    assert link.times(Look) == [0, PULSE]
    with pytest.raises(RobotConnectionError):
        link.check()


# A brick that serves another program.


@pytest.mark.parametrize("frees", [0.0, 1.0, 1.8])
def test_a_busy_brick_is_tried_again_until_it_is_free(clock, frees):
    tried = []

    def attempt():
        tried.append(clock.now())
        if clock.now() < frees:
            raise RobotBusyError("ev3-taken", place="there")
        return "a link"

    assert clock.run(lambda: when_free(attempt, clock)) == "a link"
    assert clock.now() == pytest.approx(frees)
    assert tried == pytest.approx([PAUSE * count for count in range(len(tried))])


def test_a_brick_that_stays_busy_is_given_up_in_time(clock):
    def attempt():
        raise RobotBusyError("ev3-taken", place="there")

    with pytest.raises(RobotBusyError):
        clock.run(lambda: when_free(attempt, clock))
    assert clock.now() == pytest.approx(TIMEOUT)


# Messages that arrive slowly.


class Slow(Stream):
    """Bytes that arrive one by one, and then nothing more."""

    def __init__(self, clock, data, *, every):
        super().__init__(clock)
        self.asked = []
        self._data, self._every = deque(data), every

    def read(self, most, timeout):
        del most
        self.asked.append(round(timeout, 6))
        if not self._data or self._every > timeout + 1e-9:
            self._clock.advance(timeout)
            raise TimeoutError
        self._clock.advance(self._every)
        return bytes((self._data.popleft(),))


def test_a_message_has_one_limit_of_time_however_many_pieces_it_comes_in(clock):
    stream = Slow(clock, b"\x05\0abcde", every=0.25)
    with pytest.raises(TimeoutError):
        stream.receive(1.1)
    assert stream.asked == [1.1, 0.85, 0.6, 0.35, 0.1]
    assert clock.now() == pytest.approx(1.1)


def test_a_message_that_arrives_just_in_time_is_received(clock):
    assert Slow(clock, b"\x03\0abc", every=0.2).receive(1.0) == b"abc"


class FullDevice(DeviceFile):
    """A device that takes nothing."""

    def __init__(self, clock):
        Stream.__init__(self, clock)
        self._closed, self._lock = False, threading.Lock()

    def _write(self, data, seconds):
        del data
        self._clock.advance(seconds)


def test_a_device_that_takes_nothing_is_given_up_in_time(clock):
    with pytest.raises(TimeoutError):
        FullDevice(clock).write(b"abc")
    assert clock.now() == pytest.approx(LONGEST_WRITE)
