"""A wire between client and robot that fails on request."""

import select
import socket
import threading
from contextlib import suppress
from time import monotonic

import pytest

from learnblock.testing import Fault, Relay

pytestmark = pytest.mark.realtime


@pytest.fixture
def echo():
    """A robot that echoes what it receives, over TCP."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        threading.Thread(target=_echo_all, args=(server,), daemon=True).start()
        yield server.getsockname()


def _echo_all(server):
    while True:
        try:
            connection, _ = server.accept()
        except OSError:
            return
        threading.Thread(target=_echo, args=(connection,), daemon=True).start()


def _echo(connection):
    # A client may hang up before it has read everything.
    with connection, suppress(ConnectionError):
        while data := connection.recv(1000):
            connection.sendall(data)


@pytest.fixture
def udp_echo():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as robot:
        robot.bind(("127.0.0.1", 0))
        echoing = threading.Thread(target=_echo_datagrams, args=(robot,))
        echoing.start()
        yield robot.getsockname()
        robot.sendto(b"", robot.getsockname())
        echoing.join()


def _echo_datagrams(robot):
    while True:
        data, sender = robot.recvfrom(1000)
        if not data:
            return
        robot.sendto(data, sender)


@pytest.fixture
def relay(echo):
    with Relay(echo) as relay:
        yield relay


@pytest.fixture
def client(relay):
    with socket.create_connection(("127.0.0.1", relay.port), 5) as client:
        yield client


def test_an_intact_link_forwards_everything(relay, client):
    client.sendall(b"hello")
    assert client.recv(10) == b"hello"
    assert relay.passed == 10


def test_a_silent_link_forwards_nothing_and_stays_open(relay, client):
    relay.fault = Fault.SILENT
    client.sendall(b"hello")
    client.settimeout(0.2)
    with pytest.raises(TimeoutError):
        client.recv(10)


def test_garbage_comes_only_from_the_robot(relay, client):
    relay.fault = Fault.GARBAGE
    client.sendall(b"hello")
    assert client.recv(10) != b"hello"
    relay.fault = Fault.NONE
    client.sendall(b"hello")
    assert client.recv(10) == b"hello"


def test_a_slow_link_is_late(relay, client):
    relay.fault, relay.delay = Fault.SLOW, 0.2
    began = monotonic()
    client.sendall(b"hello")
    assert client.recv(10) == b"hello"
    assert monotonic() - began >= 0.4


def test_a_cut_link_closes_connections_and_rejects_new_ones_until_it_is_restored(relay, client):
    relay.fault = Fault.CUT
    assert ended(client)
    with socket.create_connection(("127.0.0.1", relay.port), 5) as another:
        assert ended(another)
    relay.fault = Fault.NONE
    with socket.create_connection(("127.0.0.1", relay.port), 5) as another:
        another.sendall(b"hello")
        assert another.recv(10) == b"hello"


def ended(connection):
    try:
        return connection.recv(10) == b""
    except ConnectionResetError:
        return True


def test_the_share_of_lost_datagrams_is_as_set(udp_echo):
    with Relay(udp_echo, udp=True) as relay, socket.socket(type=socket.SOCK_DGRAM) as client:
        client.connect(("127.0.0.1", relay.port))
        client.settimeout(0)
        relay.loss = 0.3
        came = sum(comes_back(client, relay) for _ in range(500))
    assert came + relay.lost == 500
    # Lost in either direction: 0.7 squared.
    assert 205 < came < 285


def comes_back(client, relay):
    """Whether a datagram comes back; otherwise, the relay has lost it."""
    before = relay.lost
    client.send(b"x")
    while relay.lost == before:
        try:
            return client.recv(10) == b"x"
        except BlockingIOError:
            select.select((client,), (), (), 0.002)
    return False
