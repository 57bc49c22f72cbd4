"""When an EV3's agent stops the motors, lets a client go, and dismisses a stranger."""

import json
import socket
import threading
from contextlib import suppress

import pytest

from learnblock.robots.ev3 import agent
from learnblock.testing import ManualClock

STOP = [0, 0]


class Brick:
    """Records when it is told what."""

    def __init__(self, clock):
        self.told = []
        self._clock = clock

    def state(self):
        return {"left": 0, "right": 0}

    def drive(self, speeds):
        self.told.append((round(self._clock.now(), 6), speeds))

    def hush(self):
        """Make no sound."""


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def brick(clock):
    return Brick(clock)


@pytest.fixture
def ends():
    """The times at which the client was let go."""
    return []


@pytest.fixture
def guard(brick, clock, ends):
    guard = agent.Guard(brick, lambda: ends.append(clock.now()), clock)
    clock.block_until(1)
    yield guard
    guard.close()


@pytest.mark.parametrize("last", [0.05, 0.3, 1.0])
def test_the_motors_stop_exactly_when_the_silence_after_the_last_word_is_over(
    guard, brick, clock, last
):
    clock.advance(last)
    guard.answer('{"drive": [100, 100]}')
    clock.advance(agent.SILENCE - 0.001)
    assert brick.told == [(last, [100, 100])]
    clock.advance(0.002)
    assert brick.told == [(last, [100, 100]), (round(last + agent.SILENCE, 6), STOP)]


def test_motors_that_stand_are_not_stopped_again(guard, brick, clock):
    guard.answer('{"drive": [0, 0]}')
    clock.advance(1)
    assert brick.told == [(0, [0.0, 0.0])]


def test_a_client_that_says_anything_in_time_drives_on(guard, brick, clock, ends):
    guard.answer('{"drive": [100, 100]}')
    for _ in range(100):
        clock.advance(agent.SILENCE - 0.01)
        guard.answer("{}")
    assert (brick.told, ends) == ([(0, [100, 100])], [])


def test_a_client_is_let_go_exactly_when_its_absence_is_too_long(guard, clock, ends):
    clock.advance(0.7)
    guard.answer("{}")
    clock.advance(agent.ABSENCE - 0.001)
    assert ends == []
    assert "state" in json.loads(guard.answer("{}"))
    clock.advance(agent.ABSENCE + 1)
    assert ends == pytest.approx([0.7 + agent.ABSENCE - 0.001 + agent.ABSENCE])


def test_a_client_that_returns_too_late_gets_an_error(guard, clock):
    clock.advance(agent.ABSENCE)
    assert json.loads(guard.answer("{}"))["error"] == "ev3-timed-out"


def test_motors_of_a_client_that_left_are_not_started_by_what_it_said(guard, brick, clock):
    guard.answer('{"drive": [100, 100]}')
    clock.advance(10)
    guard.answer('{"drive": [100, 100]}')
    assert [speeds for _, speeds in brick.told] == [[100, 100], STOP, STOP]


# Without a thread.


def test_the_next_look_is_never_later_than_the_silence_after_a_word_that_comes_until_then(
    guard, clock
):
    looks = [guard.look(moment) for moment in (0.0, 0.1, 0.3, 1.3)]
    assert looks == pytest.approx([0.3, 0.2, 0.3, 0.2])


# Clients that connect.


@pytest.fixture
def listener():
    with agent.listen("127.0.0.1", 0) as listener:
        yield listener


@pytest.fixture
def client(listener):
    with socket.create_connection(listener.getsockname(), 20) as client:
        yield client


def test_a_stranger_is_dismissed_exactly_when_its_introduction_is_overdue(listener, client, clock):
    serving = agent.Agent(listener, "secret", clock)
    serving.turn()
    assert b"nonce" in client.recv(4096)
    clock.advance(agent.INTRODUCTION - 0.001)
    assert serving.left(clock.now()) == pytest.approx(0.001)
    assert serving.overdue(clock.now()) == []
    clock.advance(0.001)
    serving.turn()
    assert client.recv(4096) == b""


class Interrupted:
    """A listener that is interrupted by a signal when a second client comes."""

    def __init__(self, listener):
        self.clients = 0
        self._listener = listener

    def fileno(self):
        return self._listener.fileno()

    def accept(self):
        self.clients += 1
        if self.clients == 2:
            raise SystemExit(0)
        return self._listener.accept()


def test_an_agent_that_is_ended_by_a_signal_stops_the_motors_at_once(
    listener, client, brick, clock, monkeypatch
):
    monkeypatch.setattr(
        agent, "serve", lambda line, *_, clock: agent.Guard(brick, lambda: None, clock)
    )
    monkeypatch.setattr(agent.Agent, "_check", lambda *_: None)

    def serve():
        with suppress(SystemExit):
            agent.Agent(Interrupted(listener), "secret", clock).run()

    serving = threading.Thread(target=serve, daemon=True)
    serving.start()
    with client.makefile("rb") as heard:
        heard.readline()
        client.sendall(b'{}\n{"drive": [100, 100]}\n')
        heard.readline(), heard.readline()
        assert brick.told == [(0, [100, 100])]
        socket.create_connection(listener.getsockname(), 20).close()
        serving.join()
    assert brick.told == [(0, [100, 100]), (0, STOP)]
