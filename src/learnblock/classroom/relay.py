"""Passes the messages between a page and a pupil's server on, if the page may send them."""

import asyncio
from collections.abc import Awaitable, Callable, Iterable
from contextlib import suppress
from typing import TYPE_CHECKING, get_args

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect
from websockets.asyncio.client import ClientConnection
from websockets.exceptions import ConnectionClosed

from learnblock.classroom import messages as ours
from learnblock.classroom.desk import Desk
from learnblock.classroom.gift import Gift
from learnblock.classroom.limits import WEIGHT
from learnblock.classroom.page_sockets import BACK_SOON, FORBIDDEN, close_socket
from learnblock.classroom.pupil_connection import connected, send_order
from learnblock.classroom.questions import A, ServerQuestions
from learnblock.classroom.quota import Paces
from learnblock.classroom.rights import may
from learnblock.errors import LearnBlockError, phrase_of
from learnblock.i18n import Phrase
from learnblock.server import messages
from learnblock.server.messages.base import Role

if TYPE_CHECKING:
    from learnblock.classroom.servers import ServerAddress

#: Seconds between two checks that it does.
_HEARTBEAT = 2.0


_from_pupil = msgspec.json.Decoder(ours.FromPupil)
_at_seat = msgspec.json.Decoder(messages.AtSeat)
_work_given = msgspec.json.Decoder(messages.WorkGiven)
_renamed = msgspec.json.Decoder(messages.ProjectRenamed)
_lesson_work = msgspec.json.Decoder(messages.LessonWorkRead)
#: Our servers put the kind first.
_AT_SEAT = f'{{"kind":"{messages.AtSeat.__name__}"'
_WORK_GIVEN = f'{{"kind":"{messages.WorkGiven.__name__}"'
_RENAMED = f'{{"kind":"{messages.ProjectRenamed.__name__}"'
_LESSON_WORK = f'{{"kind":"{messages.LessonWorkRead.__name__}"'
_OURS = frozenset(kind.__name__ for kind in get_args(ours.FromPupil))


First = Callable[[], Awaitable[Iterable[messages.Message]]]


class Relay:
    """A page that shows a pupil's program.

    Args:
        page: its websocket, accepted.
        desk: the pupil's.
        is_teacher: whether it is the teacher's page, or has the rights of one.
        paces: how often it may do something; None for those of the desk, or the teacher's own.
    """

    def __init__(
        self, page: WebSocket, desk: Desk, *, is_teacher: bool, paces: Paces | None = None
    ) -> None:
        self.is_teacher = is_teacher
        self._page = page
        self._desk = desk
        # All pages of a pupil share theirs.
        self._paces = paces or (Paces() if is_teacher else desk.paces)
        self._outbox: asyncio.Queue[str] = asyncio.Queue(maxsize=100)
        self._server: ClientConnection | None = None
        self._gift = Gift(desk.lesson_refused)
        self._questions = ServerQuestions(self.order)
        #: The pupil's count of successes when the work in lessons was last asked for.
        self._successes = -1

    @property
    def role(self) -> Role:
        """What the page is to the program now."""
        if not self.is_teacher:
            return Role.PUPIL
        return Role.HELPER if self._desk.writing == "yes" else Role.WATCHER

    def tell(self, message: msgspec.Struct) -> None:
        """Send the page a message of the classroom; one that is too slow misses it."""
        with suppress(asyncio.QueueFull):
            self._outbox.put_nowait(msgspec.json.encode(message).decode())

    async def order(self, message: messages.Message) -> None:
        """Send the pupil's server a message on behalf of this page."""
        self._gift.note(message)
        await send_order(self._server, message)

    async def ask(self, question: messages.Message, answer: type[A]) -> A | None:
        """Ask the pupil's server on behalf of this page; None without an answer."""
        return await self._questions.ask(question, answer)

    async def send_away(self) -> None:
        """Close the page's connection, since it may not be here any more."""
        await close_socket(self._page, FORBIDDEN)

    async def restart(self) -> None:
        """Close the page's connection, since its server ends; the page connects again."""
        await close_socket(self._page, BACK_SOON)

    async def serve(self, place: "ServerAddress", first: First) -> None:
        """Pass messages on until the page or the pupil's server is gone.

        Args:
            place: the pupil's server.
            first: returns what the server gets first on behalf of the page. It is asked once the
                page is at the desk, so that nothing is lost that is handed out meanwhile.
        """
        async with connected(place) as server:
            self._server = server
            self._desk.progress.answered()
            self._desk.joined(self)
            for message in await first():
                await self.order(message)
            listening = asyncio.create_task(self._listen(server))
            try:
                await self._pass_on(server)
            finally:
                listening.cancel()
                self._desk.left(self)
                self._server = None

    async def _listen(self, server: ClientConnection) -> None:
        """Record that the pupil's server answers, for as long as it does."""
        with suppress(ConnectionClosed):
            while True:
                await (await server.ping())
                self._desk.progress.answered()
                await asyncio.sleep(_HEARTBEAT)

    async def _pass_on(self, server: ClientConnection) -> None:
        tasks = [
            asyncio.create_task(work)
            for work in (self._to_server(server), self._to_page(server), self._to_page_ours())
        ]
        done, pending = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        for task in pending:
            task.cancel()
        await asyncio.gather(*pending, return_exceptions=True)
        for task in done:
            task.result()

    async def _to_server(self, server: ClientConnection) -> None:
        with suppress(ConnectionClosed):
            while (received := await self._page.receive())["type"] == "websocket.receive":
                text = received.get("text") or ""
                await asyncio.sleep(self._paces.take(1 + len(text) // WEIGHT))
                head = messages.head_of(text)
                if refusal := self._refusal(head.kind) or await self._no_guest(head.kind):
                    self.tell(messages.Failed(refusal, head.kind, head.request))
                elif head.kind in _OURS:
                    await self._hear(text, head.kind)
                else:
                    if not self.is_teacher:
                        self._desk.progress.acted(head.kind)
                    await server.send(text)

    async def _hear(self, text: str, kind: str) -> None:
        try:
            await self._desk.heard(self, _from_pupil.decode(text))
        except msgspec.MsgspecError as error:
            phrase = Phrase("server-message-unknown", reason=str(error))
            self.tell(messages.Failed(phrase, kind))
        except (LearnBlockError, OSError) as error:
            self.tell(messages.Failed(phrase_of(error), kind))

    async def _hand_in(self, text: str) -> None:
        """Keep what the pupil's server gives, which a pupil might have taken over."""
        try:
            await self._desk.hand_in(_work_given.decode(text).work)
        except (LearnBlockError, OSError, ValueError) as error:
            self.tell(messages.Failed(phrase_of(error), messages.HandIn.__name__))

    async def _see(self, now: messages.AtSeat) -> None:
        """Note what the page works on; at a hub, ask for the work in lessons when it has grown."""
        self._desk.see(self, now)
        if self._desk.lesson_works and not self.is_teacher and now.successes != self._successes:
            self._successes = now.successes
            await self.order(messages.ReadLessonWork())

    async def _keep_lesson_work(self, text: str) -> None:
        """Keep what the pupil's server reports; the pupil may control that server."""
        if self._desk.lesson_works:
            with suppress(OSError, ValueError):
                works = _lesson_work.decode(text).works
                await asyncio.to_thread(self._desk.lesson_works.keep, works)

    def _refusal(self, kind: str) -> Phrase | None:
        if not may(self.role, kind):
            code = "class-only-look" if self.is_teacher else "class-not-yours"
            return Phrase(code)
        return Phrase("class-too-fast") if self._paces.wait_for(kind) else None

    def _follow_name(self, received: str) -> None:
        """Note the new name of a project in which a guest plays, or that is shown."""
        if received.startswith(_RENAMED):
            with suppress(msgspec.MsgspecError):
                self._desk.renamed(self, _renamed.decode(received).name)

    async def _no_guest(self, kind: str) -> Phrase | None:
        """Why a run can't begin with the guest's program; None if it can, or needs none."""
        if kind != messages.Run.__name__ or not self._desk.sharing:
            return None
        try:
            await self._desk.sharing.before_run(self._desk, self)
        except LearnBlockError as error:
            return error.phrase
        return None

    async def _to_page(self, server: ClientConnection) -> None:
        with suppress(WebSocketDisconnect, RuntimeError):
            async for received in server:
                if isinstance(received, bytes):
                    await self._page.send_bytes(received)
                    continue
                self._follow_name(received)
                if received.startswith(_AT_SEAT):
                    await self._see(_at_seat.decode(received))
                elif received.startswith(_WORK_GIVEN):
                    await self._hand_in(received)
                elif received.startswith(_LESSON_WORK):
                    await self._keep_lesson_work(received)
                elif not self._gift.takes(received) and not self._questions.takes(received):
                    await self._page.send_text(received)
            await self._page.close(BACK_SOON)

    async def _to_page_ours(self) -> None:
        with suppress(WebSocketDisconnect, RuntimeError):
            while True:
                await self._page.send_text(await self._outbox.get())


async def no_messages() -> Iterable[messages.Message]:
    """What a server gets first of which nothing is wanted."""
    return ()
