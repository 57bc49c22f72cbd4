"""A connection is closed if its request does not arrive in time."""

import asyncio
import socket
import threading

import pytest
import uvicorn
from starlette.applications import Starlette
from starlette.responses import PlainTextResponse
from starlette.routing import Route, WebSocketRoute

from learnblock.server.http.requests import TimedRequests

LIMIT = 0.2
REQUEST = b"GET / HTTP/1.1\r\nHost: localhost\r\n"
UPGRADE = (
    b"Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
)


class Hasty(TimedRequests):
    limit = LIMIT


async def slow(_):
    await asyncio.sleep(3 * LIMIT)
    return PlainTextResponse("at last")


async def greet(websocket):
    await websocket.accept()
    await asyncio.sleep(3 * LIMIT)
    await websocket.send_text("hello")
    await websocket.close()


@pytest.fixture
def connection():
    """A connection to a server whose requests must arrive in 0.2 s."""
    app = Starlette(routes=[Route("/", slow), WebSocketRoute("/", greet)])
    config = uvicorn.Config(
        app, http=Hasty, ws="websockets-sansio", log_config=None, timeout_keep_alive=60
    )
    server = uvicorn.Server(config)
    listening = socket.create_server(("127.0.0.1", 0))
    thread = threading.Thread(target=server.run, args=([listening],))
    thread.start()
    with socket.create_connection(listening.getsockname(), timeout=10) as opened:
        yield opened
    server.should_exit = True
    thread.join()
    listening.close()


def read_to_the_end(connection):
    return b"".join(iter(lambda: connection.recv(65536), b""))


@pytest.mark.parametrize("sent", [b"", REQUEST])
def test_half_a_request_ends_its_connection(connection, sent):
    connection.sendall(sent)
    assert read_to_the_end(connection) == b""


def test_half_of_a_second_request_ends_its_connection(connection):
    connection.sendall(REQUEST + b"\r\n" + REQUEST)
    answer = read_to_the_end(connection)
    assert answer.count(b"HTTP/1.1") == 1
    assert answer.endswith(b"at last")


def test_a_websocket_stays_open(connection):
    connection.sendall(REQUEST + UPGRADE + b"\r\n")
    received = b""
    while b"hello" not in received:
        more = connection.recv(65536)
        assert more, "the connection was closed"
        received += more
