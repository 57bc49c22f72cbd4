"""Questions of the class to a pupil's server, and their answers.

A pupil may control the server, which may then not answer, or answer a question that was not asked.
"""

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress
from typing import TypeVar

import msgspec

from learnblock.server import messages

A = TypeVar("A", messages.GuestRobot, messages.ProgramGiven, messages.GuestTaken)
#: Seconds within which a server answers; a pupil waits for the start of a run so long.
PATIENCE = 3.0
#: Our servers put the kind first.
_ANSWERS: dict[str, type] = {
    f'{{"kind":"{kind.__name__}"': kind
    for kind in (messages.GuestRobot, messages.ProgramGiven, messages.GuestTaken)
}


class ServerQuestions:
    """Those on one connection, one of a kind at a time.

    Args:
        send: sends the server a message.
        patience: seconds within which it has to answer.
    """

    def __init__(
        self, send: Callable[[messages.Message], Awaitable[None]], patience: float = PATIENCE
    ) -> None:
        self._send = send
        self._patience = patience
        self._waiting: dict[type, asyncio.Future[object]] = {}

    async def ask(self, question: messages.Message, answer: type[A]) -> A | None:
        """Ask the server; None without an answer."""
        waiting = asyncio.get_running_loop().create_future()
        self._waiting[answer] = waiting
        await self._send(question)
        with suppress(TimeoutError):
            async with asyncio.timeout(self._patience):
                received: A = await waiting
                return received
        return None

    def takes(self, text: str) -> bool:
        """Whether a message of the server is an answer, and not for the page."""
        kind = next((kind for head, kind in _ANSWERS.items() if text.startswith(head)), None)
        if kind is None:
            return False
        waiting = self._waiting.pop(kind, None)
        if waiting and not waiting.done():
            with suppress(msgspec.MsgspecError):
                waiting.set_result(msgspec.json.decode(text, type=kind))
        return True
