"""What a page has said and the server has not yet done."""

import asyncio
from collections import deque

from learnblock.server import messages

#: So many messages may wait; then the page has to.
_MOST = 100
#: Of these the newest says it all.
_NEWEST_ONLY = (
    messages.EditBlocks,
    messages.EditText,
    messages.SetSpeed,
    messages.PlaceRobot,
    messages.Drive,
    messages.CheckWorld,
    messages.CheckOwnBlock,
)


class Inbox:
    """Messages in order, but that an edit which follows another of the same view replaces it.

    Someone who types faster than a long program can be translated waits for one translation, not
    for as many as letters were typed.
    """

    def __init__(self) -> None:
        self._messages: deque[messages.Message] = deque()
        self._changed = asyncio.Condition()
        self._closed = False

    async def put(self, message: messages.Message) -> None:
        """Add a message, when there is room for it."""
        async with self._changed:
            if self._messages and _replaces(message, self._messages[-1]):
                self._messages.pop()
            await self._changed.wait_for(lambda: len(self._messages) < _MOST)
            self._messages.append(message)
            self._changed.notify_all()

    async def take(self) -> messages.Message | None:
        """The next message, as soon as there is one; None when there will be none any more."""
        async with self._changed:
            await self._changed.wait_for(lambda: self._messages or self._closed)
            self._changed.notify_all()
            return self._messages.popleft() if self._messages else None

    async def close(self) -> None:
        """Nothing will come any more; what has come is still to be taken."""
        async with self._changed:
            self._closed = True
            self._changed.notify_all()


def _replaces(message: messages.Message, before: messages.Message) -> bool:
    if type(message) is not type(before) or not isinstance(message, _NEWEST_ONLY):
        return False
    if isinstance(message, messages.EditText) and isinstance(before, messages.EditText):
        return message.notation == before.notation
    return True
