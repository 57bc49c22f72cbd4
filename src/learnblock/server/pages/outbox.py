"""Messages that are waiting to be sent to a page."""

import asyncio
from collections import deque
from dataclasses import dataclass

from learnblock.server import messages

#: A page that is this many messages behind will not catch up.
FULL = 5000
#: Of these kinds, a slow page receives only the newest message.
_NEWEST_ONLY = (
    messages.CameraFrame,
    messages.RobotLink,
    messages.RunningLine,
    messages.Telemetry,
    messages.Variables,
)


class OutboxFullError(Exception):
    """The page does not receive its messages fast enough."""


@dataclass
class Parcel:
    """A message, and the bytes that follow it."""

    message: messages.ToPage
    data: bytes | None = None


class Outbox:
    """Messages in order; newer telemetry and frames replace older ones."""

    def __init__(self) -> None:
        self._parcels: deque[Parcel] = deque()
        self._replaceable: dict[type, Parcel] = {}
        self._filled = asyncio.Event()

    def put(self, message: messages.ToPage, data: bytes | None = None) -> None:
        """Queue a message; drop it once the page is too far behind."""
        waiting = self._replaceable.get(type(message))
        if waiting:
            waiting.message, waiting.data = message, data
        elif len(self._parcels) <= FULL:
            self._append(Parcel(message, data))

    async def take(self) -> Parcel:
        """Return the next message as soon as there is one.

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
