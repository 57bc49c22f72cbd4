"""HTTP connections that must not wait forever for their browser."""

import asyncio
from collections.abc import Callable, Iterable
from typing import Any

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

from learnblock.server.http.connections import Connections

#: Seconds within which a request, or a TLS handshake, must be complete.
PATIENCE = 10.0
#: The slowest rate of a body that takes longer, in bytes a second.
LEAST_RATE = 10_000

#: The headers of a request.
Headers = Iterable[tuple[bytes, bytes]]
#: Returns the person who sends these headers; "" if they don't identify one.
Identify = Callable[[Headers], str]


class TimedRequests(H11Protocol):
    """One connection; it is closed if a request or an answer takes too long.

    Uvicorn limits how long a connection may be idle, but not how long a request may take, so a
    client that sends half of one would keep its connection forever.

    Args:
        connections: counts the connections that wait; None if none are counted.
        identify: finds out who sent a request.
    """

    #: See `PATIENCE`.
    limit = PATIENCE
    #: See `LEAST_RATE`.
    least_rate = LEAST_RATE
    #: Seconds within which a browser must take some of an answer.
    reading = 60.0

    def __init__(
        self,
        *args: Any,
        connections: Connections | None = None,
        identify: Identify = lambda _: "",
        **others: Any,
    ) -> None:
        super().__init__(*args, **others)
        self._counted = Connections() if connections is None else connections
        self._identify = identify
        self._number = -1
        self._deadline: asyncio.TimerHandle | None = None
        self._arrived = 0

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        self._number = transport.get_extra_info("socket").fileno()
        self._expect_request()

    def connection_lost(self, exc: Exception | None) -> None:
        self._expect_nothing()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        self._arrived += len(data)
        before = self.cycle
        super().data_received(data)
        if self.cycle is not before:
            self._recognise()
        if self._is_whole:
            self._works()

    def pause_writing(self) -> None:
        super().pause_writing()
        self._waits()
        self._expect(self.reading, self.transport.abort)

    def resume_writing(self) -> None:
        super().resume_writing()
        if self._is_whole:
            self._expect_nothing()
            self._works()
        else:
            self._expect_request()

    def on_response_complete(self) -> None:
        super().on_response_complete()
        # A browser may have sent the next request already, or may still have to read this answer.
        if not self._is_whole and not self.flow.write_paused:
            self._expect_request()

    def handle_websocket_upgrade(self, event: h11.Request) -> None:
        # From here on, the websocket protocol handles the connection; without a known owner it
        # waits, since it is about to be closed.
        self._expect_nothing()
        if self._recognise():
            self._works()
        super().handle_websocket_upgrade(event)

    # Waiting for the browser.

    @property
    def _is_whole(self) -> bool:
        """Whether a request has arrived that is not answered yet."""
        is_answering = self.cycle is not None and not self.cycle.response_complete
        return is_answering and self.conn.their_state is not h11.SEND_BODY

    def _expect_request(self) -> None:
        self._waits()
        self._expect_more()

    def _expect_more(self) -> None:
        self._arrived = 0
        self._expect(self.limit, self._give_up)

    def _expect(self, seconds: float, otherwise: Callable[[], object]) -> None:
        self._expect_nothing()
        self._deadline = self.loop.call_later(seconds, otherwise)

    def _expect_nothing(self) -> None:
        if self._deadline:
            self._deadline.cancel()

    def _give_up(self) -> None:
        if self._is_whole:
            return
        if self.flow.read_paused or self._arrived >= self.limit * self.least_rate:
            # The server is slow, or there is much to send.
            self._expect_more()
        elif self.transport.get_write_buffer_size():
            self.transport.abort()
        else:
            self.transport.close()

    # Counting.

    def _recognise(self) -> bool:
        """Find out whose connection this is; return whether that is known."""
        connection = self._counted.find(self._number)
        person = self._identify(self.headers) if connection else ""
        if connection and person:
            self._counted.belongs(connection, person)
            self._counted.waits(connection)
        return bool(person)

    def _waits(self) -> None:
        if connection := self._counted.find(self._number):
            self._counted.waits(connection)

    def _works(self) -> None:
        if connection := self._counted.find(self._number):
            self._counted.works(connection)
