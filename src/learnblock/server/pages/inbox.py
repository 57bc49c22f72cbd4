"""Messages from a page that are waiting to be handled."""

import asyncio
from collections import deque

from learnblock.server import messages

#: The maximum number of waiting messages; after that, the page has to wait.
_MOST = 100
#: Of these kinds, only the newest message is used.
_NEWEST_ONLY = (
    messages.EditBlocks,
    messages.EditText,
    messages.SetSpeed,
    messages.PlaceRobot,
    messages.Drive,
    messages.CheckWorld,
    messages.MakeWorld,
    messages.CheckCustomBlock,
)


class Inbox:
    """Messages in order; an edit replaces the one before it if both are of the same view.

    Fast typing in a long program thus waits for one translation, not for one per letter.
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
            await self._changed.wait_for(lambda: len(self._messages) < _MOST)
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
    if type(message) is not type(before) or not isinstance(message, _NEWEST_ONLY):
        return False
    if isinstance(message, messages.EditText) and isinstance(before, messages.EditText):
        return message.notation == before.notation
    return True
