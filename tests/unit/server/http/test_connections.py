"""The connections that wait for their browser are counted by who has opened them."""

import socket
from contextlib import ExitStack

import pytest

from clocks import Clock
from learnblock.server.http.connections import (
    MOST_KNOWN,
    MOST_UNKNOWN,
    MOST_YOUNG,
    Connections,
    OpenConnection,
    network_of,
)


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def connections(clock):
    return Connections(most=300, now=clock)


@pytest.fixture
def arrive(connections):
    """Connect from an address; return our end and the browser's."""
    with ExitStack() as stack:

        def arrived(address="10.0.0.1"):
            ours, theirs = socket.socketpair()
            theirs.settimeout(5)
            stack.enter_context(theirs)
            return stack.enter_context(OpenConnection(connections, ours, address)), theirs

        yield arrived


def is_cut(theirs):
    theirs.setblocking(False)
    try:
        return theirs.recv(1) == b""
    except BlockingIOError:
        return False


def test_one_too_many_of_an_address_closes_its_oldest(arrive, clock):
    ends = [arrive()[1] for _ in range(MOST_UNKNOWN)]
    other = arrive("10.0.0.2")[1]
    clock.time += 2
    arrive()
    assert [is_cut(end) for end in ends] == [True] + [False] * (MOST_UNKNOWN - 1)
    assert not is_cut(other)


def test_a_connection_that_has_just_come_is_not_closed(arrive):
    ends = [arrive()[1] for _ in range(3 * MOST_UNKNOWN)]
    assert not any(map(is_cut, ends))


def test_of_very_many_at_once_the_oldest_is_closed(arrive):
    ends = [arrive()[1] for _ in range(MOST_YOUNG + 1)]
    assert [is_cut(end) for end in ends] == [True] + [False] * MOST_YOUNG


def test_a_request_that_is_not_read_yet_keeps_its_connection(arrive, clock):
    asking = arrive()[1]
    asking.sendall(b"GET / HTTP/1.1\r\n")
    ends = [arrive()[1] for _ in range(MOST_UNKNOWN - 1)]
    clock.time += 2
    arrive()
    assert not is_cut(asking)
    assert is_cut(ends[0])


def test_what_is_being_answered_is_neither_counted_nor_closed(arrive, connections, clock):
    """A whole class may come from one address."""
    ends = [arrive() for _ in range(3 * MOST_UNKNOWN)]
    for ours, _ in ends:
        connections.works(ours)
    clock.time += 2
    last = arrive()[1]
    assert not any(is_cut(theirs) for _, theirs in ends)
    assert not is_cut(last)


def test_a_known_person_is_counted_wherever_the_connections_come_from(arrive, connections, clock):
    ends = []
    for number in range(MOST_KNOWN):
        ours, theirs = arrive(f"10.0.0.{number}")
        connections.belongs(ours, "ana")
        connections.waits(ours)
        ends.append(theirs)
    clock.time += 2
    assert not any(map(is_cut, ends))
    ours, _ = arrive()
    connections.belongs(ours, "ana")
    connections.waits(ours)
    assert [is_cut(end) for end in ends] == [True] + [False] * (MOST_KNOWN - 1)


def test_a_known_person_does_not_suffer_from_others_at_the_same_address(arrive, connections, clock):
    ours, theirs = arrive()
    connections.belongs(ours, "ana")
    connections.waits(ours)
    for _ in range(3 * MOST_UNKNOWN):
        clock.time += 2
        arrive()
    assert not is_cut(theirs)


def test_when_all_are_taken_the_address_with_the_most_loses_one(arrive, clock):
    few = [arrive(f"10.0.1.{number}")[1] for number in range(150)]
    many = [arrive()[1] for _ in range(151)]
    assert is_cut(many[0])
    assert not any(map(is_cut, [*few, *many[1:]]))


def test_a_closed_connection_is_forgotten(arrive, connections):
    ours, _ = arrive()
    assert len(connections) == 1
    ours.close()
    ours.close()
    assert len(connections) == 0
    assert connections.find(ours.number) is None


@pytest.mark.parametrize(
    ("address", "network"),
    [
        ("10.0.0.1", "10.0.0.1"),
        ("::ffff:10.0.0.1", "10.0.0.1"),
        ("2001:db8::1", "2001:db8::/64"),
        ("2001:db8::ffff:1", "2001:db8::/64"),
        ("fe80::1%eth0", "fe80::/64"),
        ("", ""),
    ],
)
def test_all_addresses_of_one_computer_are_one(address, network):
    assert network_of(address) == network
