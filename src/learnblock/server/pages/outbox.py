"""What waits to be sent to a page."""

import asyncio
from collections import deque
from dataclasses import dataclass

from learnblock.server import messages

#: A page that is so many messages behind will not catch up.
FULL = 5000
#: Of these a slow page gets the newest alone.
_NEWEST_ONLY = (messages.Telemetry, messages.CameraFrame, messages.Variables)


class OutboxFullError(Exception):
    """The page does not take what is sent to it."""


@dataclass
class Parcel:
    """A message, with the bytes that follow it."""

    message: messages.Message
    data: bytes | None = None


class Outbox:
    """Messages in order, but that newer telemetry and frames take the place of older ones."""

    def __init__(self) -> None:
        self._parcels: deque[Parcel] = deque()
        self._replaceable: dict[type, Parcel] = {}
        self._filled = asyncio.Event()

    def put(self, message: messages.Message, data: bytes | None = None) -> None:
        """Have a message sent; once the page is too far behind nothing is kept any more."""
        waiting = self._replaceable.get(type(message))
        if waiting:
            waiting.message, waiting.data = message, data
        elif len(self._parcels) <= FULL:
            self._append(Parcel(message, data))

    async def take(self) -> Parcel:
        """The next message, as soon as there is one.

        Raises:
            OutboxFullError: the page is too far behind.
        """
        await self._filled.wait()
        if len(self._parcels) > FULL:
            raise OutboxFullError
        parcel = self._parcels.popleft()
        self._replaceable.pop(type(parcel.message), None)
        if not self._parcels:
            self._filled.clear()
        return parcel

    def _append(self, parcel: Parcel) -> None:
        self._parcels.append(parcel)
        if isinstance(parcel.message, _NEWEST_ONLY):
            self._replaceable[type(parcel.message)] = parcel
        self._filled.set()
