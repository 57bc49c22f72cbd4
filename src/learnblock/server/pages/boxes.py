"""Messages that wait in order: from a page to be handled, and to a page to be sent."""

import asyncio
from collections import deque
from dataclasses import dataclass

from learnblock.server import messages

#: The maximum number of waiting messages; after that, the page has to wait.
_MOST_WAITING = 100
#: Of these kinds from a page, only the newest message is used.
_NEWEST_EDITS = (
    messages.EditBlocks,
    messages.EditText,
    messages.SetSpeed,
    messages.PlaceRobot,
    messages.Drive,
    messages.CheckWorld,
    messages.MakeWorld,
    messages.CheckCustomBlock,
)
#: A page that is this many messages behind will not catch up.
FULL = 5000
#: Of these kinds, a slow page receives only the newest message.
_NEWEST_STATES = (
    messages.CameraFrame,
    messages.RobotLink,
    messages.RunningLine,
    messages.Telemetry,
    messages.Variables,
)


class Inbox:
    """Messages in order; an edit replaces the one before it if both are of the same view.

    So fast typing in a long program waits for one translation, not for one per letter.
    """

    def __init__(self) -> None:
        self._messages: deque[messages.FromPage] = deque()
        self._changed = asyncio.Condition()
        self._closed = False

    async def put(self, message: messages.FromPage) -> messages.FromPage | None:
        """Add a message once there is room for it; return the one that it replaces."""
        async with self._changed:
            is_newer = self._messages and _replaces(message, self._messages[-1])
            replaced = self._messages.pop() if is_newer else None
            await self._changed.wait_for(lambda: len(self._messages) < _MOST_WAITING)
            self._messages.append(message)
            self._changed.notify_all()
            return replaced

    async def take(self) -> messages.FromPage | None:
        """Return the next message as soon as there is one; None after the last."""
        async with self._changed:
            await self._changed.wait_for(lambda: self._messages or self._closed)
            self._changed.notify_all()
            return self._messages.popleft() if self._messages else None

    async def close(self) -> None:
        """Accept no more messages; waiting messages can still be taken."""
        async with self._changed:
            self._closed = True
            self._changed.notify_all()


def _replaces(message: messages.FromPage, before: messages.FromPage) -> bool:
    if type(message) is not type(before) or not isinstance(message, _NEWEST_EDITS):
        return False
    if isinstance(message, messages.EditText) and isinstance(before, messages.EditText):
        return message.notation == before.notation
    return True


class OutboxFullError(Exception):
    """The page does not receive its messages fast enough."""


@dataclass
class Parcel:
    """A message, and the bytes that follow it."""

    message: messages.ToPage | messages.ToClass
    data: bytes | None = None


class Outbox:
    """Messages in order; newer telemetry and frames replace older ones."""

    def __init__(self) -> None:
        self._parcels: deque[Parcel] = deque()
        self._replaceable: dict[type, Parcel] = {}
        self._filled = asyncio.Event()

    def put(self, message: messages.ToPage | messages.ToClass, data: bytes | None = None) -> None:
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
        if isinstance(parcel.message, _NEWEST_STATES):
            self._replaceable[type(parcel.message)] = parcel
        self._filled.set()
