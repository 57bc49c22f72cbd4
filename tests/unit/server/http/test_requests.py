"""A connection is closed if its request does not arrive in time."""

import asyncio
import select
import socket
import threading
from contextlib import suppress

import pytest
import uvicorn
from starlette.applications import Starlette
from starlette.requests import ClientDisconnect
from starlette.responses import PlainTextResponse
from starlette.routing import Route, WebSocketRoute

from learnblock.server.http.requests import TimedRequests

LIMIT = 0.2
REQUEST = b"GET / HTTP/1.1\r\nHost: localhost\r\n"
UPGRADE = (
    b"Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
)


POST = b"POST /body HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100\r\n\r\n"
LONG_POST = POST.replace(b"100", b"100000")


class Hasty(TimedRequests):
    limit = reading = LIMIT
    least_rate = 1000


async def slow(_):
    await asyncio.sleep(3 * LIMIT)
    return PlainTextResponse("at last")


async def size(request):
    """The size of a request's body; what happened if it is not whole."""
    try:
        return PlainTextResponse(str(len(await request.body())))
    except ClientDisconnect:
        DISCONNECTED.set()
        return PlainTextResponse("gone")


DISCONNECTED = threading.Event()


async def large(_):
    """More than the buffers of both ends hold."""
    return PlainTextResponse("x" * 50_000_000)


async def greet(websocket):
    await websocket.accept()
    await asyncio.sleep(3 * LIMIT)
    await websocket.send_text("hello")
    await websocket.close()


@pytest.fixture
def connection():
    """A connection to a server whose requests must arrive in 0.2 s."""
    app = Starlette(
        routes=[
            Route("/", slow),
            Route("/body", size, methods=["POST"]),
            WebSocketRoute("/", greet),
        ]
    )
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


@pytest.mark.parametrize("sent", [b"", REQUEST, POST, POST + b"half", LONG_POST + bytes(100)])
def test_half_a_request_ends_its_connection(connection, sent):
    connection.sendall(sent)
    assert read_to_the_end(connection) == b""


def test_an_answer_that_nobody_reads_ends_its_connection(connection):
    connection.sendall(REQUEST.replace(b"/ ", b"/large ", 1) + b"\r\n")
    # Readable as soon as the answer begins; then nothing is read until it must have ended.
    assert select.select([connection], [], [], 10)[0]
    assert select.select([], [], [connection], 3 * LIMIT)[2] == []
    received = 0
    with suppress(ConnectionResetError):
        while part := connection.recv(65536):
            received += len(part)
    assert received < 50_000_000


def test_half_a_body_tells_the_application(connection):
    DISCONNECTED.clear()
    connection.sendall(POST + b"half")
    assert read_to_the_end(connection) == b""
    assert DISCONNECTED.wait(10)


def test_a_long_body_may_take_longer_while_it_arrives(connection):
    connection.sendall(LONG_POST)
    for _ in range(19):
        # Each part is more than the slowest rate, and all together take longer than the limit.
        connection.sendall(bytes(5000))
        assert select.select([connection], [], [], LIMIT / 4)[0] == []
    connection.sendall(bytes(5000))
    answer = connection.recv(65536)
    while not answer.endswith(b"100000"):
        more = connection.recv(65536)
        assert more, "the connection was closed"
        answer += more


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
