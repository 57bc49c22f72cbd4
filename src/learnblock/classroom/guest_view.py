"""A guest's page with the host's world: only what shows the world reaches it, at a steady rate.

It is a page of the host's server, which a pupil may control. The guest sends keys, nothing else.
"""

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect
from websockets.asyncio.client import ClientConnection
from websockets.exceptions import ConnectionClosed

from learnblock.classroom.limits import GUEST_KILOBYTES, GUEST_PICTURES
from learnblock.classroom.page_sockets import BACK_SOON, FORBIDDEN, TOO_MANY, close_socket
from learnblock.classroom.pupil_connection import connected, send_order
from learnblock.classroom.questions import A, ServerQuestions
from learnblock.classroom.quota import Bucket, Paces
from learnblock.classroom.rights import FROM_GUEST, TO_GUEST
from learnblock.classroom.servers import ServerAddress
from learnblock.i18n import Phrase
from learnblock.server import messages

#: Bytes of the largest message that a guest gets.
_LARGEST = 2_000_000
#: The limit of a message of a guest in characters.
_LONGEST = 2_000
#: Our servers put the kind first.
_KIND = '{"kind":"'
_failed = msgspec.json.Decoder(messages.Failed)
_MOVED = messages.Telemetry.__name__


class GuestView:
    """A page on which a guest sees a world.

    Args:
        page: its websocket, accepted.
        paces: how often the guest may do something.
        lost: called when the project can't be opened.
    """

    def __init__(
        self,
        page: WebSocket,
        paces: Paces,
        lost: Callable[[], Awaitable[None]],
    ) -> None:
        self._page = page
        self._paces = paces
        self._lost = lost
        self._server: ClientConnection | None = None
        self._questions = ServerQuestions(self._order)
        self._budget = Bucket(GUEST_KILOBYTES)
        self._sending = asyncio.Lock()
        #: The newest picture of what moves, until it is sent.
        self._picture = ""
        self._moved = asyncio.Event()

    async def ask(self, question: messages.Message, answer: type[A]) -> A | None:
        """Ask the host's server on behalf of the page; None without an answer."""
        return await self._questions.ask(question, answer)

    async def send_away(self) -> None:
        """Close the page's connection for good."""
        await close_socket(self._page, FORBIDDEN)

    async def replace(self) -> None:
        """Close the page's connection, since another page of the guest shows the world."""
        await close_socket(self._page, TOO_MANY)

    async def serve(self, place: ServerAddress, project: str, robot: str) -> None:
        """Show a robot of a project until the page or the host's server is gone.

        Args:
            place: the host's server.
            project: the name of the project.
            robot: the name of the robot.
        """
        async with connected(place) as server:
            self._server = server
            await self._order(messages.Open(name=project, tab=robot))
            # A guest may come back in the middle of a run.
            await self._order(messages.KeepKeysApart())
            parts = (self._hear(server), self._show(server), self._show_moves())
            tasks = [asyncio.create_task(part) for part in parts]
            try:
                await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
            finally:
                self._server = None
                for task in tasks:
                    task.cancel()
                await asyncio.gather(*tasks, return_exceptions=True)

    async def _order(self, message: messages.Message) -> None:
        await send_order(self._server, message)

    async def _hear(self, server: ClientConnection) -> None:
        """Pass the guest's keys on."""
        with suppress(ConnectionClosed):
            while (received := await self._page.receive())["type"] == "websocket.receive":
                text = received.get("text") or ""
                await asyncio.sleep(self._paces.take(1 + len(text) // _LONGEST))
                head = messages.head_of(text)
                if head.kind in FROM_GUEST and len(text) <= _LONGEST:
                    await server.send(text)
                elif head.request:
                    phrase = Phrase("class-pair-only-keys")
                    await self._send(_written(messages.Failed(phrase, head.kind, head.request)))

    async def _show(self, server: ClientConnection) -> None:
        """Pass on what shows the world."""
        with suppress(WebSocketDisconnect, RuntimeError):
            async for received in server:
                if isinstance(received, str) and not self._questions.takes(received):
                    await self._see(received)
            await self._page.close(BACK_SOON)

    async def _see(self, text: str) -> None:
        kind = text[len(_KIND) :].partition('"')[0] if text.startswith(_KIND) else ""
        if kind == _MOVED:
            # Only the newest picture counts.
            self._picture = text
            self._moved.set()
        elif kind == messages.Failed.__name__:
            with suppress(msgspec.MsgspecError):
                if _failed.decode(text).refused == messages.Open.__name__:
                    await self._lost()
        elif kind == messages.Welcome.__name__:
            await self._send(_greeting(text))
        elif kind in TO_GUEST and len(text) <= _LARGEST:
            await self._send_picture()
            await self._send(text)

    async def _show_moves(self) -> None:
        with suppress(WebSocketDisconnect, RuntimeError):
            while True:
                await self._moved.wait()
                await self._send_picture()
                await asyncio.sleep(1 / GUEST_PICTURES)

    async def _send_picture(self) -> None:
        self._moved.clear()
        text, self._picture = self._picture, ""
        if text and len(text) <= _LARGEST:
            await self._send(text)

    async def _send(self, text: str) -> None:
        async with self._sending:
            await asyncio.sleep(self._budget.take(1 + len(text) // 1000))
            await self._page.send_text(text)


def _written(message: msgspec.Struct) -> str:
    return msgspec.json.encode(message).decode()


def _greeting(text: str) -> str:
    """The greeting of the host's server without what the host has made."""
    try:
        welcome = msgspec.json.decode(text, type=dict[str, object])
    except msgspec.MsgspecError:
        welcome = {"kind": messages.Welcome.__name__, "version": "", "robots": []}
    known = {key: welcome.get(key) for key in ("kind", "version", "robots")}
    return msgspec.json.encode({**known, "worlds": [], "examples": [], "folder": ""}).decode()
