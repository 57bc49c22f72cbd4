"""The times of the connection to a Cozmo: what is sent again, and when it is given up."""

import socket

import pytest

from learnblock.robots.cozmo.halt import RETRY as HALT_RETRY
from learnblock.robots.cozmo.halt import insist
from learnblock.testing import ManualClock

packets = pytest.importorskip("pycozmo", reason="pip install 'learnblock[cozmo]'").protocol_encoder
link = pytest.importorskip("learnblock.robots.cozmo.link")


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def silent():
    """A robot that never answers."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as silent:
        silent.bind(("127.0.0.1", 0))
        silent.setblocking(False)
        yield silent


@pytest.fixture
def connection(silent, clock):
    connection = link.CozmoLink(silent.getsockname(), clock)
    yield connection
    connection.sock.close()


def count(silent):
    """Return the number of datagrams that have arrived."""
    number = 0
    try:
        while silent.recv(4096):
            number += 1
    except BlockingIOError:
        return number


@pytest.mark.parametrize(("patience", "requests"), [(0.1, 1), (1.0, 4), (3.0, 10)])
def test_a_robot_that_never_answers_is_given_up_exactly_in_time(
    connection, silent, clock, patience, requests
):
    assert not clock.run(lambda: connection.establish(patience))
    assert clock.now() == pytest.approx(patience)
    assert count(silent) == requests


def test_packets_are_sent_again_exactly_when_their_acknowledgement_is_due(connection, clock):
    sender = connection.send_thread
    sender.last_ack_time = clock.now()
    sender.window.put(packets.StopAllMotors())
    overdue = []
    for _ in range(120):
        if sender.overdue():
            overdue.append(clock.now())
        clock.advance(0.001)
    assert overdue == pytest.approx([link.RESEND, 2 * link.RESEND])


def test_packets_that_are_acknowledged_are_not_sent_again(connection, clock):
    sender = connection.send_thread
    sender.ack(sender.window.put(packets.StopAllMotors()), 1)
    clock.advance(1)
    assert sender.overdue() == []


def test_its_silence_is_the_time_since_its_last_frame(connection, clock):
    clock.advance(2.5)
    assert connection.silence == 2.5


# Without pycozmo, as the guardian does.


def test_a_frame_is_sent_again_until_its_time_is_over(clock):
    sent, asked = [], []

    def hear(seconds):
        asked.append(seconds)
        clock.advance(seconds)
        return False

    assert not insist(lambda: sent.append(clock.now()), hear, 0.22, clock)
    assert sent == pytest.approx([HALT_RETRY * number for number in range(5)])
    assert asked == pytest.approx([HALT_RETRY] * 4 + [0.02])
    assert clock.now() == pytest.approx(0.22)


def test_other_datagrams_do_not_bring_the_next_frame_forward_nor_delay_it(clock):
    sent = []

    def hear(_):
        clock.advance(0.02)
        return clock.now() > 0.13

    assert insist(lambda: sent.append(clock.now()), hear, 3.0, clock)
    assert sent == pytest.approx([0, 0.06, 0.12])
