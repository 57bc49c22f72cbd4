"""The limits of a call, in virtual time."""

import socket
from concurrent.futures import ThreadPoolExecutor

import pytest

from learnblock.errors import IceLinkError
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.messages import MessageKind, message
from learnblock.testing import ManualClock
from waiting import wait_for


@pytest.fixture
def silent():
    """A component that accepts a connection and then says nothing."""
    with socket.create_server(("127.0.0.1", 0)) as server, ThreadPoolExecutor(1) as pool:
        accepted = pool.submit(server.accept)
        yield server.getsockname()[1], accepted
        accepted.result()[0].close()


def test_a_call_that_waits_while_another_one_receives_gives_up_exactly_in_time(silent):
    port, accepted = silent
    clock = ManualClock()
    with Endpoint("127.0.0.1", port, 20, clock) as endpoint, ThreadPoolExecutor(1) as pool:
        first = pool.submit(endpoint.call, b"", b"", again=False)
        accepted.result()[0].sendall(message(MessageKind.VALIDATE))
        wait_for(lambda: endpoint._connection and endpoint._connection._receives, "it receives")
        endpoint.timeout = 2
        with pytest.raises(IceLinkError) as error:
            clock.run(lambda: endpoint.call(b"", b"", again=False))
        assert error.value.phrase.code == "ice-timeout"
        assert clock.now() == pytest.approx(2)
        # A late reply could be taken for another one's, so the connection ends with it.
        with pytest.raises(IceLinkError):
            first.result()
