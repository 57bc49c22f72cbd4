"""Pages that talk to a server without a browser, many in one event loop."""

import json
from typing import TYPE_CHECKING

from websockets.asyncio.client import ClientConnection, connect

if TYPE_CHECKING:
    from classes import Class


class Page:
    """A page of a project.

    Args:
        socket: its connection.
    """

    def __init__(self, socket: ClientConnection) -> None:
        self._socket = socket

    async def say(self, kind: str, **values: object) -> None:
        """Send a message."""
        await self._socket.send(json.dumps({"kind": kind, **values}))

    async def hear(self, kind: str, **values: object) -> None:
        """Wait for a message with these values.

        Raises:
            RuntimeError: the server has refused something.
        """
        async for message in self._socket:
            if isinstance(message, bytes):
                continue
            heard = json.loads(message)
            if heard["kind"] == "Failed":
                raise RuntimeError(heard["message"])
            if heard["kind"] == kind and values.items() <= heard.items():
                return


def visit(room: "Class", path: str, cookie: str) -> connect:
    """Connect to a class, as the browser with this cookie."""
    return connect(
        f"ws://127.0.0.1:{room.port}{path}",
        subprotocols=["learnblock"],
        additional_headers={"Cookie": cookie},
        max_size=None,
        open_timeout=60,
    )
