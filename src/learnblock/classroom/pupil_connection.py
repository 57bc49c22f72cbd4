"""The connection of the class with a pupil's server, on behalf of a page."""

from contextlib import suppress
from typing import TYPE_CHECKING

import msgspec
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from learnblock.server import messages
from learnblock.server.http.protection import SEAT, SUBPROTOCOL

if TYPE_CHECKING:
    from learnblock.classroom.servers import ServerAddress

#: Bytes; what a pupil's server accepts, and a little more, so that the page gets its answer.
_LARGEST = 8 * 1024 * 1024
#: Seconds within which a pupil's server answers.
_PATIENCE = 10.0


def connected(place: "ServerAddress") -> connect:
    """A connection with a pupil's server, as a context."""
    return connect(
        place.url("ws", f"ws?{SEAT}"),
        subprotocols=list(filter(None, (SUBPROTOCOL, place.token))),  # type: ignore[arg-type] # plain strings
        # As a proxy does, so that the server takes no pupil for a user of its own computer.
        additional_headers={**place.headers, "x-forwarded-for": "class"},
        max_size=_LARGEST,
        compression=None,
        open_timeout=_PATIENCE,
        ping_interval=None,
    )


async def send_order(server: ClientConnection | None, message: messages.Message) -> None:
    """Send a pupil's server a message of the class; nothing happens if the server has gone."""
    if server:
        with suppress(ConnectionClosed):
            await server.send(msgspec.json.encode(message).decode())
