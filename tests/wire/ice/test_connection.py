"""A connection to a component: many calls at a time, and every way in which it can break."""

import socket
import struct
import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import pytest

from emulated import LONG
from ice_runtime import components
from learnblock.errors import IceLinkError
from learnblock.ice import Adapter, Interface, Operation, Proxy, Servant
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.interface import Mode
from learnblock.ice.messages import HEADER, MessageKind, message
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.ice.types import INT
from learnblock.testing import Fault, Relay
from ports import free_port
from waiting import wait_for

COUNTER = Interface(
    "::Test::Counter",
    (
        Operation("double", takes=(INT,), gives=(INT,)),
        Operation("again", takes=(INT,), gives=(INT,), mode=Mode.IDEMPOTENT),
    ),
)
BASE = interfaces(Layout.TOOL)["differentialrobot"]
#: Seconds for a call that nothing answers.
TIMEOUT = 0.6


class Counter:
    def __init__(self):
        self.asked = []

    def double(self, number):
        self.asked.append(number)
        return 2 * number

    again = double


def proxy_to(port, interface=COUNTER, identity="it", timeout=LONG):
    return Proxy.parse(f"{identity}:tcp -h 127.0.0.1 -p {port}", interface, timeout)


@pytest.fixture
def counter():
    """A servant, and a proxy through a wire that can fail."""
    servant = Counter()
    with Adapter() as adapter:
        port = adapter.serve({"it": Servant(COUNTER, servant)})
        with Relay(("127.0.0.1", port)) as relay, proxy_to(relay.port) as proxy:
            yield servant, relay, proxy


def told(sentence):
    return pytest.raises(IceLinkError, match=sentence)


@contextmanager
def failing(relay, proxy, fault):
    """Let the link fail, and calls wait only shortly."""
    relay.fault, proxy.endpoint.timeout = fault, TIMEOUT
    yield
    relay.fault, proxy.endpoint.timeout = Fault.NONE, LONG


def test_many_threads_get_their_own_replies(counter):
    _, relay, _ = counter
    with proxy_to(relay.port) as proxy, ThreadPoolExecutor(8) as pool:
        assert list(pool.map(lambda n: proxy.call("double", n), range(500))) == [
            2 * number for number in range(500)
        ]


def test_a_call_that_hangs_delays_no_other():
    heard, let_go = threading.Event(), threading.Event()

    def serve(connection):
        connection.sendall(message(MessageKind.VALIDATE))
        first = read(connection)[:4]
        heard.set()
        connection.sendall(reply_to(read(connection)[:4], 2))
        let_go.wait(LONG)
        connection.sendall(reply_to(first, 1))

    with peer(serve) as port, proxy_to(port) as proxy, ThreadPoolExecutor(1) as pool:
        hanging = pool.submit(proxy.call, "double", 1)
        heard.wait(LONG)
        assert proxy.call("double", 2) == 2
        let_go.set()
        assert hanging.result(LONG) == 1


def reply_to(number, value):
    """The message that answers the request with that number."""
    return message(MessageKind.REPLY, number + b"\0" + struct.pack("<iBBi", 10, 1, 1, value))


def read(connection):
    """The body of the next message."""
    header = connection.recv(HEADER.size, socket.MSG_WAITALL)
    return connection.recv(HEADER.unpack(header)[-1] - HEADER.size, socket.MSG_WAITALL)


@contextmanager
def peer(serve):
    """A server with its own way of answering; yields the port."""
    with socket.create_server(("127.0.0.1", 0)) as listener:

        def run():
            connection, _ = listener.accept()
            with connection:
                serve(connection)

        thread = threading.Thread(target=run, daemon=True)
        thread.start()
        yield listener.getsockname()[1]
        thread.join(LONG)
        assert not thread.is_alive()


def test_a_missing_component_is_reported():
    with proxy_to(free_port()) as proxy, told("No component is listening"):
        proxy.ping()


@pytest.mark.parametrize("host", ["no.such.host.invalid", "two words", "x" * 70, "a..b", "\udc80"])
def test_an_address_that_does_not_exist_is_reported(host):
    with (
        Endpoint(host, 5, timeout=5) as endpoint,
        pytest.raises(IceLinkError, match="There is no computer with this name"),
    ):
        Proxy(COUNTER, "it", endpoint).ping()


@pytest.mark.parametrize("fault", [Fault.SILENT, Fault.CUT, Fault.GARBAGE])
def test_a_failing_link_is_reported_and_the_next_call_reconnects(counter, fault):
    servant, relay, proxy = counter
    assert proxy.call("double", 1) == 2
    for number in range(3):
        with failing(relay, proxy, fault), pytest.raises(IceLinkError):
            proxy.call("double", 10 + number)
        assert proxy.call("double", 20 + number) == 2 * (20 + number)
    assert servant.asked[-1] == 22


@pytest.mark.parametrize("fault", [Fault.SILENT, Fault.CUT, Fault.GARBAGE])
def test_a_link_that_fails_from_the_beginning_is_reported(counter, fault):
    _, relay, proxy = counter
    for _ in range(3):
        sentence = "did not answer|closed the connection|was lost|can't be read"
        with failing(relay, proxy, fault), told(sentence):
            proxy.call("double", 1)


def test_a_slow_link_works(counter):
    _, relay, proxy = counter
    proxy.call("double", 1)
    relay.fault, relay.delay = Fault.SLOW, 0.1
    assert proxy.call("double", 2) == 4


@pytest.mark.parametrize(
    ("says", "sentence"),
    [
        (b"HTTP/1.1 400 Bad Request\r\n\r\n", "can't be read"),
        (message(MessageKind.REPLY, b"\1\0\0\0\0"), r"unexpected message \(REPLY\)"),
        (message(MessageKind.VALIDATE) + b"x" * 40, "can't be read"),
        (message(MessageKind.VALIDATE) + message(MessageKind.REPLY, b"\1"), "can't be read"),
        (
            message(MessageKind.VALIDATE) + message(MessageKind.REQUEST, b""),
            r"unexpected message \(REQUEST\)",
        ),
        (message(MessageKind.VALIDATE)[:5], "closed the connection"),
        (b"", "closed the connection"),
    ],
)
def test_a_server_without_ice_is_reported(says, sentence):
    def serve(connection):
        connection.sendall(says)

    with (
        peer(serve) as port,
        proxy_to(port) as proxy,
        told(f"{sentence}|closed the|was lost"),
    ):
        proxy.ping()


def test_keep_alive_messages_and_late_replies_are_skipped():
    def serve(connection):
        connection.sendall(message(MessageKind.VALIDATE) * 3)
        number = read(connection)[:4]
        late = message(MessageKind.REPLY, struct.pack("<i", 99) + b"\0\6\0\0\0\1\1")
        connection.sendall(late + message(MessageKind.VALIDATE) + reply_to(number, 7))
        connection.recv(1)

    with peer(serve) as port, proxy_to(port) as proxy:
        assert proxy.call("double", 3) == 7


def test_a_call_lost_with_its_connection_is_repeated_if_that_is_harmless():
    heard = []

    def serve(listener):
        for _ in range(2):
            connection, _ = listener.accept()
            with connection:
                connection.sendall(message(MessageKind.VALIDATE))
                while body := read_all(connection):
                    heard.append(body)
                    if len(heard) == 2:
                        break
                    connection.sendall(reply_to(body[:4], 7))

    with socket.create_server(("127.0.0.1", 0)) as listener:
        thread = threading.Thread(target=serve, args=(listener,), daemon=True)
        thread.start()
        with proxy_to(listener.getsockname()[1]) as proxy:
            assert [proxy.call("again", 1), proxy.call("again", 2)] == [7, 7]
        thread.join(5)
    assert [body[-4:] for body in heard] == [struct.pack("<i", n) for n in (1, 2, 2)]


def read_all(connection):
    """The body of the next request; empty if the client is gone."""
    header = connection.recv(HEADER.size, socket.MSG_WAITALL)
    if len(header) < HEADER.size or header[8] != MessageKind.REQUEST:
        return b""
    return connection.recv(HEADER.unpack(header)[-1] - HEADER.size, socket.MSG_WAITALL)


def test_a_closed_proxy_makes_no_call_and_can_be_closed_again(counter):
    _, _, proxy = counter
    proxy.ping()
    proxy.close()
    proxy.close()
    with told("The connection to the component is closed"):
        proxy.ping()


def test_closing_wakes_a_call_that_waits(counter):
    _, relay, _ = counter
    patient = proxy_to(relay.port, timeout=1000)
    patient.ping()
    relay.fault = Fault.SILENT
    with ThreadPoolExecutor(1) as pool:
        call = pool.submit(patient.call, "double", 1)
        wait_for(lambda: patient.endpoint._connection._calls, "the call")
        patient.close()
        # Its own limit is longer than that of a test.
        with pytest.raises(IceLinkError):
            call.result()


def test_components_that_come_back_are_found_by_the_next_call(tmp_path):
    with components(tmp_path, "tool", "differentialrobot") as running:
        (port,) = running.ports
        proxy = proxy_to(port, BASE, "differentialrobot")
        proxy.call("setSpeedBase", 1.0, 0.0)
        running.kill()
        with pytest.raises(IceLinkError, match="No component is listening"):
            proxy.call("setSpeedBase", 2.0, 0.0)
    with components(tmp_path, "tool", ("differentialrobot", {"port": port})) as running, proxy:
        proxy.call("setSpeedBase", 3.0, 0.0)
        assert running.told() == ["setSpeedBase", 3.0, 0.0]


def test_a_connection_that_ice_closes_when_idle_is_reopened(tmp_path):
    # Ice closes after at most twice the configured time in seconds.
    idle = ("--Ice.ACM.Server.Timeout=1", "--Ice.ACM.Server.Close=1")
    with (
        components(tmp_path, "tool", "differentialrobot", ice=idle) as running,
        proxy_to(running.ports[0], BASE, "differentialrobot") as proxy,
    ):
        proxy.ping()
        stream = proxy.endpoint._connection._stream
        wait_for(stream.has_news, "the end of the connection")
        proxy.call("setSpeedBase", 1.0, 0.0)
        assert running.told() == ["setSpeedBase", 1.0, 0.0]
        assert proxy.endpoint._connection._stream is not stream
