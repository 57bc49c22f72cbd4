"""A page that is connected: what it says is obeyed in order, and what it is told is sent."""

import asyncio
import logging
from collections.abc import Awaitable, Callable, Mapping
from contextlib import AbstractAsyncContextManager, nullcontext
from typing import TYPE_CHECKING, Any

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect

from learnblock.errors import LearnBlockError
from learnblock.server import messages
from learnblock.server.pages.inbox import Inbox
from learnblock.server.pages.outbox import Outbox, OutboxFullError
from learnblock.server.pages.sentences import sentence
from learnblock.server.pages.shown import Shown

if TYPE_CHECKING:
    from learnblock.server.sessions.open_projects import Sessions
    from learnblock.server.sessions.session import Session

#: Bytes: no message of a page is as large.
LARGEST_MESSAGE = 4 * 1024 * 1024
#: Close code: try again later.
_TOO_SLOW = 1013

_log = logging.getLogger(__name__)
_decoder = msgspec.json.Decoder(messages.FromPage)
_encoder = msgspec.json.Encoder()

Handler = Callable[["Page", Any], Awaitable[None]]


class MessageError(LearnBlockError, ValueError):
    """What a page said cannot be understood."""


class Page:
    """A page at the other end of a websocket.

    Args:
        socket: accepted.
        sessions: the projects that are open.
        handlers: what is done about each message.
    """

    def __init__(
        self, socket: WebSocket, sessions: "Sessions", handlers: Mapping[type, Handler]
    ) -> None:
        self.sessions = sessions
        #: The program as this page shows it.
        self.shown = Shown()
        #: Whether it wants camera frames.
        self.watching = False
        self._socket = socket
        self._handlers = handlers
        self._session: Session | None = None
        self._inbox = Inbox()
        self._outbox = Outbox()

    @property
    def session(self) -> "Session":
        """The project it has opened.

        Raises:
            LearnBlockError: none.
        """
        if self._session is None:
            raise LearnBlockError("no project is open: open one first")
        return self._session

    async def serve(self) -> None:
        """Return when the page has gone, and all that it said is done."""
        try:
            async with asyncio.TaskGroup() as tasks:
                sending = tasks.create_task(self._send())
                tasks.create_task(self._receive())
                await self._obey_all()
                sending.cancel()
        finally:
            self.leave()

    def tell(self, message: messages.Message, data: bytes | None = None) -> None:
        """Have a message sent, with `data` behind it."""
        self._outbox.put(message, data)

    def join(self, session: "Session") -> None:
        """Be a page of that project from now on, and of no other."""
        self.leave()
        self.shown = Shown()
        self._session = session
        session.join(self)

    def leave(self) -> None:
        """Be a page of no project."""
        session, self._session = self._session, None
        if session:
            session.leave(self)
            self.sessions.left(session)

    # Receiving.

    async def _receive(self) -> None:
        try:
            while (received := await self._socket.receive())["type"] == "websocket.receive":
                await self._hear(received.get("text") or received.get("bytes") or "")
        finally:
            await self._inbox.close()

    async def _hear(self, said: str | bytes) -> None:
        try:
            message = decode(said)
        except MessageError as error:
            self.tell(messages.Failed(str(error)))
        else:
            await self._inbox.put(message)

    async def _obey_all(self) -> None:
        while (message := await self._inbox.take()) is not None:
            await self._obey(message)

    async def _obey(self, message: messages.Message) -> None:
        kind = type(message).__name__
        try:
            async with self._turn():
                await self._handlers[type(message)](self, message)
        except (LearnBlockError, OSError, ValueError) as error:
            self.tell(messages.Failed(sentence(error), kind))
        except RecursionError:
            self.tell(messages.Failed("this is nested too deeply", kind))
        except Exception as error:  # noqa: BLE001 - see below
            # A mistake of ours must not take the pupil's session with it.
            _log.exception("%s failed", kind)
            told = f"LearnBlock has made a mistake: {type(error).__name__}: {error}"
            self.tell(messages.Failed(told, kind))

    def _turn(self) -> AbstractAsyncContextManager[object]:
        """The pages of a project take turns."""
        return self._session.turn if self._session else nullcontext()

    # Sending.

    async def _send(self) -> None:
        try:
            while True:
                parcel = await self._outbox.take()
                await self._socket.send_text(_encoder.encode(parcel.message).decode())
                if parcel.data is not None:
                    await self._socket.send_bytes(parcel.data)
        except OutboxFullError:
            await self._socket.close(_TOO_SLOW)
        except WebSocketDisconnect:
            # It has gone, which `_receive` hears as well.
            pass


def decode(said: str | bytes) -> messages.Message:
    """What a page has said.

    Raises:
        MessageError: it is no message of a page.
    """
    if len(said) > LARGEST_MESSAGE:
        raise MessageError(f"a message of {len(said)} characters is too long")
    try:
        message: messages.Message = _decoder.decode(said)
    except msgspec.MsgspecError as error:
        raise MessageError(f"this is no message that LearnBlock knows: {error}") from error
    except (RecursionError, UnicodeError) as error:
        raise MessageError("this message is nested too deeply, or is no text") from error
    return message
