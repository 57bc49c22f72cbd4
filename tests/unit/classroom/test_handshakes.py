"""With HTTPS, a connection that never shakes hands is counted, and closed in time."""

import socket
import ssl
import threading

import pytest
import uvicorn
from starlette.applications import Starlette
from starlette.responses import PlainTextResponse
from starlette.routing import Route

from learnblock.classroom.serve import _tls
from learnblock.server.http.connections import Connections, Listening
from learnblock.server.serve import configured
from waiting import wait_for

pytest.importorskip("cryptography")
pytestmark = pytest.mark.realtime


async def hello(_):
    return PlainTextResponse("hello")


@pytest.fixture
def connections():
    return Connections()


@pytest.fixture
def address(tmp_path, connections, monkeypatch):
    """A server whose handshakes must be done in half a second."""
    from learnblock.classroom.certificate import own_certificate

    monkeypatch.setattr("learnblock.server.http.tls_loop.PATIENCE", 0.5)
    app = Starlette(routes=[Route("/", hello)])
    tls = _tls(own_certificate(tmp_path))
    server = uvicorn.Server(configured(app, connections=connections, **tls))
    listening = Listening(socket.create_server(("127.0.0.1", 0)), connections)
    address = listening.getsockname()
    thread = threading.Thread(target=server.run, args=([listening],))
    thread.start()
    yield address
    server.should_exit = True
    thread.join()


def test_connections_without_a_handshake_keep_nobody_out_and_end(address, connections):
    silent = [socket.create_connection(address, 10) for _ in range(200)]
    wait_for(lambda: len(connections) > 0, "the first is accepted")
    context = ssl.create_default_context()
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    with context.wrap_socket(socket.create_connection(address, 10)) as child:
        child.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
        assert child.recv(100).startswith(b"HTTP/1.1 200")
    for one in silent:
        with one:
            assert one.recv(100) == b""
