"""The limits of a connection to a Thymio: no answer, silence, and an answer that is overdue."""

import struct
import threading
from contextlib import contextmanager

import pytest

from learnblock.errors import RobotConnectionError
from learnblock.robots.thymio import aseba
from learnblock.robots.thymio.aseba import OVERDUE, AsebaLink
from learnblock.robots.thymio.frames import encoded
from learnblock.robots.thymio.link import SILENCE
from learnblock.robots.thymio.node import READ
from learnblock.robots.thymio.program import READY
from learnblock.testing import ManualClock
from thymio_wires import description, frame

pytest.importorskip("thymiodirect", reason="pip install 'learnblock[thymio]'")

Message = aseba.Message
TOKEN = 1


class Wire:
    """A robot that says something, and then nothing more."""

    name = "there"

    def __init__(self, clock, data=b""):
        self.sent = []
        self._clock, self._data = clock, data
        self._closed = threading.Event()

    def receive(self):
        data, self._data = self._data, b""
        if not data:
            self._closed.wait(0.01)
        return data

    def send(self, data):
        self.sent.append((round(self._clock.now(), 6), int.from_bytes(data[4:6], "little")))

    def close(self):
        self._closed.set()

    def asked(self):
        """Return the times at which its readings were requested."""
        return [time for time, kind in self.sent if kind == Message.ID_GET_VARIABLES]


@pytest.fixture
def clock():
    return ManualClock()


@contextmanager
def connected(clock, monkeypatch):
    """A robot that answers while it is connected, and then falls silent."""
    monkeypatch.setattr(aseba.secrets, "randbelow", lambda _: TOKEN)
    # It has not all the functions that our program calls.
    monkeypatch.setattr(aseba.AsebaNode, "bytecode", lambda *_: [0])
    readings = encoded(Message.ID_VARIABLES, 0, *range(sum(READ.values())))
    present = frame(Message.ID_NODE_PRESENT, struct.pack("<H", 5))
    wire = Wire(clock, present + description() + encoded(READY.number, TOKEN) + readings)
    link = AsebaLink(wire, 20.0, clock)
    clock.block_until(1)
    try:
        yield link, wire
    finally:
        link.close()


@pytest.mark.parametrize("patience", [0.5, 3.0])
def test_a_robot_that_never_answers_is_given_up_exactly_in_time(clock, patience):
    with pytest.raises(RobotConnectionError) as error:
        clock.run(lambda: AsebaLink(Wire(clock), patience, clock))
    assert error.value.phrase.code == "thymio-no-answer"
    assert clock.now() == pytest.approx(patience)


def test_a_missing_answer_is_requested_again_exactly_when_it_is_overdue(clock, monkeypatch):
    with connected(clock, monkeypatch) as (_, wire):
        clock.advance(4 * OVERDUE + 0.001)
        assert wire.asked() == pytest.approx([OVERDUE * count for count in range(5)])


def test_a_silent_robot_counts_as_lost_only_when_its_silence_is_too_long(clock, monkeypatch):
    with connected(clock, monkeypatch) as (link, _):
        clock.advance(SILENCE)
        link.check()
        clock.advance(0.001)
        with pytest.raises(RobotConnectionError) as error:
            link.check()
    assert error.value.phrase.code == "thymio-silent"
    assert float(error.value.phrase.values["seconds"]) == SILENCE


def test_a_robot_that_counts_as_lost_is_asked_nothing_more(clock, monkeypatch):
    with connected(clock, monkeypatch) as (link, wire):
        clock.advance(SILENCE + 0.001)
        with pytest.raises(RobotConnectionError):
            link.check()
        asked = wire.asked()
        clock.advance(10)
        assert wire.asked() == asked
