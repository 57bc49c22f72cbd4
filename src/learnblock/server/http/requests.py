"""HTTP connections that must not wait forever for the rest of a request."""

import asyncio
from typing import Any

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol


class TimedRequests(H11Protocol):
    """One connection; it is closed if a request does not arrive within a time.

    Uvicorn limits how long a connection may be idle, but not how long the header of a request may
    take, so a client that sends half of one would keep its connection forever.
    """

    #: Seconds within which a request must be complete, from the connection or the last response.
    limit = 10.0

    def __init__(self, *args: Any, **others: Any) -> None:
        super().__init__(*args, **others)
        self._deadline: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        super().connection_made(transport)
        self._expect_request()

    def connection_lost(self, exc: Exception | None) -> None:
        self._expect_nothing()
        super().connection_lost(exc)

    def on_response_complete(self) -> None:
        super().on_response_complete()
        self._expect_request()

    def handle_websocket_upgrade(self, event: h11.Request) -> None:
        # From here on, the websocket protocol handles the connection.
        self._expect_nothing()
        super().handle_websocket_upgrade(event)

    def _expect_request(self) -> None:
        self._expect_nothing()
        self._deadline = self.loop.call_later(self.limit, self._give_up)

    def _expect_nothing(self) -> None:
        if self._deadline:
            self._deadline.cancel()

    def _give_up(self) -> None:
        is_answering = self.cycle is not None and not self.cycle.response_complete
        if not is_answering:
            self.transport.close()
