"""A connected page: handles its messages in order, and sends it the server's messages."""

import asyncio
import inspect
import logging
import secrets
from collections.abc import Awaitable, Callable, Mapping
from contextlib import AbstractAsyncContextManager, nullcontext
from typing import TypeVar

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect

from learnblock.errors import LearnBlockError, phrase_of, shortage
from learnblock.i18n import Phrase, with_languages
from learnblock.project.document.views import LONGEST_TEXT
from learnblock.server import messages
from learnblock.server.catalog.classes import ClassShelf
from learnblock.server.pages.boxes import Inbox, Outbox, OutboxFullError
from learnblock.server.pages.seat import PageSeat
from learnblock.server.runs.player import Player
from learnblock.server.runs.shown import ShownProgram
from learnblock.server.sessions.lesson_trials import LessonTrial
from learnblock.server.sessions.part import Part
from learnblock.server.sessions.quota import new_projects
from learnblock.server.sessions.session import Session
from learnblock.server.sessions.sessions import Sessions

Handler = Callable[..., Awaitable[None]]
H = TypeVar("H", bound=Handler)
#: The limit in bytes, larger than any message of a page.
LARGEST_MESSAGE = 4 * 1024 * 1024
#: What msgspec says about a program that is too long.
_TOO_LONG = f"Expected `str` of length <= {LONGEST_TEXT}"
#: Close code: try again later.
_TOO_SLOW = 1013

_log = logging.getLogger(__name__)
_decoder = msgspec.json.Decoder(messages.FROM_PAGE)


class Handlers(dict[type[messages.FromPage], Handler]):
    """Handlers by kind of message.

    Example:
        HANDLERS = Handlers()

        @HANDLERS.add
        async def _stop(page: Page, message: messages.Stop) -> None: ...
    """

    def add(self, handler: H) -> H:
        """Add a function that handles the kind of its second parameter."""
        _, message = inspect.signature(handler).parameters.values()
        self[message.annotation] = handler
        return handler


_encoder = msgspec.json.Encoder(enc_hook=with_languages)


class MessageError(LearnBlockError, ValueError):
    """A page sent a message that LearnBlock doesn't know."""


class Page:
    """A page at the other end of a websocket.

    Args:
        socket: the accepted websocket.
        sessions: the open projects.
        handlers: a handler for each kind of message.
        is_local: whether its user is at the server's computer.
        is_alone: whether all pages of the server belong to this user, on any device.
        has_seat: whether it is sent `AtSeat`, for the wall of a class.
        classes: the teacher's classes; None if the server has none.
    """

    def __init__(
        self,
        socket: WebSocket,
        sessions: Sessions,
        handlers: Mapping[type[messages.FromPage], Handler],
        *,
        is_local: bool = False,
        is_alone: bool = False,
        has_seat: bool = False,
        classes: ClassShelf | None = None,
    ) -> None:
        self.classes = classes
        self.sessions = sessions
        self.is_local = is_local
        self.is_alone = is_alone
        #: The id of its browser, which owns lesson projects; a page that never sends it owns none.
        self.browser = "" if is_local or is_alone else secrets.token_hex(16)
        #: What this page needs to allow its project the network; empty if it can't.
        self.network_key = ""
        self.shown = ShownProgram()
        self.watching = False
        #: All pages of one person share theirs.
        self.new_projects = sessions.new_projects if is_alone else new_projects()
        self._socket = socket
        self._handlers = handlers
        self._session: Session | None = None
        self._inbox = Inbox()
        self._outbox = Outbox()
        self._seat = PageSeat(self._outbox.put) if has_seat else None
        self.lesson_trial = LessonTrial(self.send)

    @property
    def session(self) -> Session:
        """The project that the page has opened.

        Raises:
            LearnBlockError: the page has opened no project.
        """
        if self._session is None:
            raise LearnBlockError("server-no-project")
        return self._session

    @property
    def has_session(self) -> bool:
        """Whether the page has opened a project; the start page has not."""
        return self._session is not None

    @property
    def part(self) -> Part:
        """The program that the page shows, with its robots.

        Raises:
            LearnBlockError: the page has opened no project.
        """
        return self.session.parts.shown_to(self)

    @property
    def player(self) -> Player:
        """The robot that the page shows.

        Raises:
            LearnBlockError: the page has opened no project.
        """
        return self.part.player_of(self)

    def require_teacher(self) -> None:
        """Check that the user is at the server's computer; pupils use other computers.

        Raises:
            LearnBlockError: the user is at another computer.
        """
        if not self.is_local:
            raise LearnBlockError("server-lesson-only-here")

    def require_class(self) -> None:
        """Check that the page is one of a class, and its server the pupil's own.

        Raises:
            LearnBlockError: it is not.
        """
        if self._seat is None or not self.is_alone:
            raise LearnBlockError("server-only-in-class")

    async def serve(self) -> None:
        """Serve the page; return once it has disconnected and all its messages are handled."""
        try:
            async with asyncio.TaskGroup() as tasks:
                sending = [tasks.create_task(self._send())]
                if self._seat:
                    sending.append(tasks.create_task(self._seat.serve()))
                tasks.create_task(self._receive())
                await self._handle_all()
                for task in sending:
                    task.cancel()
        finally:
            self.lesson_trial.stop()
            self.leave()
            self.sessions.connections.left(self)

    def send(self, message: messages.ToPage, data: bytes | None = None) -> None:
        """Queue a message for the page, followed by `data`, if any."""
        self._outbox.put(message, data)
        if self._seat:
            self._seat.see(message)

    def give(self, message: messages.ToClass) -> None:
        """Queue a message for the class.

        Raises:
            LearnBlockError: the page is not in a class.
        """
        if self._seat is None:
            raise LearnBlockError("server-no-class")
        self._outbox.put(message)

    def join(self, session: Session, tab: str = "") -> None:
        """Show a robot of a project, instead of the previous project."""
        self.leave()
        self.shown = ShownProgram()
        self.network_key = ""
        self._session = session
        session.join(self, tab)

    async def move_to(self, session: Session, tab: str = "") -> None:
        """Show a project once the previous one is saved, so that the page need not wait for it."""
        await self._save()
        self.join(session, tab)

    async def move_out(self) -> None:
        """Stop showing a project, once the open one is saved."""
        await self._save()
        self.leave()

    async def _save(self) -> None:
        if self._session:
            await self._session.archive.flush()

    def leave(self) -> None:
        """Stop showing a project."""
        session, self._session = self._session, None
        if session:
            session.leave(self)
            self.sessions.left(session)

    # Receiving.

    async def _receive(self) -> None:
        try:
            while (received := await self._socket.receive())["type"] == "websocket.receive":
                await self._accept(received.get("text") or received.get("bytes") or "")
        finally:
            await self._inbox.close()

    async def _accept(self, text: str | bytes) -> None:
        try:
            message = decode(text)
        except MessageError as error:
            head = messages.head_of(text)
            self.send(messages.Failed(error.phrase, head.kind, head.request))
        else:
            if replaced := await self._inbox.put(message):
                self._done(replaced)

    async def _handle_all(self) -> None:
        while (message := await self._inbox.take()) is not None:
            await self._handle(message)

    async def _handle(self, message: messages.FromPage) -> None:
        if refusal := await self._refusal(message):
            self.send(messages.Failed(refusal, type(message).__name__, message.request))
        else:
            self._done(message)

    def _done(self, message: messages.FromPage) -> None:
        if message.request:
            self.send(messages.Done(message.request))

    async def _refusal(self, message: messages.FromPage) -> Phrase | None:
        """Handle a message; return the reason if that was not possible."""
        try:
            if self.sessions.folder.read_only and not isinstance(message, messages.FromReader):
                raise LearnBlockError("server-read-only")
            async with self._turn():
                await self._handlers[type(message)](self, message)
        except (LearnBlockError, OSError, ValueError) as error:
            return phrase_of(error)
        except RecursionError:
            return Phrase("server-too-deep")
        except Exception as error:  # noqa: BLE001 - see below
            if lack := shortage(error):
                return lack
            # A bug in our code must not end the pupil's session.
            _log.exception("%s failed", type(message).__name__)
            return Phrase("server-mistake", reason=f"{type(error).__name__}: {error}")
        return None

    def _turn(self) -> AbstractAsyncContextManager[object]:
        """Let the pages of a project take turns."""
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
            # The page has disconnected, which `_receive` notices too.
            pass


def decode(text: str | bytes) -> messages.FromPage:
    """Decode a message of a page.

    Raises:
        MessageError: the text is not a message of a page.
    """
    if len(text) > LARGEST_MESSAGE:
        raise MessageError("server-message-too-long", count=len(text))
    try:
        message: messages.FromPage = _decoder.decode(text)
    except msgspec.MsgspecError as error:
        if _TOO_LONG in str(error):
            raise MessageError("server-text-too-long", limit=LONGEST_TEXT) from error
        raise MessageError("server-message-unknown", reason=str(error)) from error
    except (RecursionError, UnicodeError) as error:
        raise MessageError("server-message-broken") from error
    return message
