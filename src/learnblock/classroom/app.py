"""The application of a class: joining, pupils' pages, the teacher's wall, the projector."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable, Iterable, Iterator
from contextlib import asynccontextmanager, nullcontext
from functools import partial
from http import HTTPStatus
from pathlib import Path

import httpx
import msgspec
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import HTTPConnection, Request
from starlette.responses import HTMLResponse, RedirectResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.websockets import WebSocket

from learnblock.classroom import messages as ours
from learnblock.classroom.answers import (
    address_of,
    came_by_https,
    forbidden,
    json_answer,
    reached,
    short_body,
)
from learnblock.classroom.archive import export
from learnblock.classroom.badges import Visitors
from learnblock.classroom.desk import Desk
from learnblock.classroom.entrance import Entrance
from learnblock.classroom.forward import Forwarder
from learnblock.classroom.guest_pages import GuestPages
from learnblock.classroom.hub_class import HubLogin
from learnblock.classroom.lesson_uploads import LessonUploads
from learnblock.classroom.page_sockets import FORBIDDEN, accept_socket, close_socket, served
from learnblock.classroom.programs import class_programs
from learnblock.classroom.record import record_of
from learnblock.classroom.relay import Relay, no_messages
from learnblock.classroom.room import Room
from learnblock.classroom.roster import AsksTeacherError, Pupil, checked_name
from learnblock.classroom.run_pages import RunPages
from learnblock.classroom.servers import ServerAddress
from learnblock.classroom.tables import Tables
from learnblock.classroom.wall import Board, MarkingView, ProjectorView, View, WallView
from learnblock.errors import LearnBlockError, phrase_of
from learnblock.server.http import static_files
from learnblock.server.http.palette import palette
from learnblock.server.http.pictures import lesson as lesson_picture
from learnblock.server.http.protection import Guard, Protection

#: Seconds for which a browser keeps a badge: a school year.
_YEAR = 365 * 24 * 3600
#: Goes on without what is in the address: the teacher's key, or the hub's code.
_ONWARD = '<!doctype html><title>LearnBlock</title><meta http-equiv="refresh" content="0;url={}">'
_GZIP = Middleware(GZipMiddleware, minimum_size=1000, compresslevel=5)
_join = msgspec.json.Decoder(ours.Join)
_word = msgspec.json.Decoder(ours.TryWord)

Endpoint = Callable[[Request], Awaitable[Response]]


def create_app(
    room: Room,
    visitors: Visitors,
    *,
    hosts: Iterable[str] = (),
    tls: bool = False,
    static: Path = static_files.BUILT,
    hub: HubLogin | None = None,
) -> Starlette:
    """Create the application.

    Args:
        room: the class.
        visitors: recognises who sends a request.
        hosts: allowed names of this computer, in addition to its own.
        tls: whether browsers come by HTTPS only.
        static: the folder of the built page.
        hub: the login of the hub that lets pupils in; None if they join with the word of the class.
    """
    door = _Door(room, visitors, tls=tls, base=hub.service.prefix if hub else "/")
    # The page's own guard, against pages of other servers; badges take the token's place.
    protection = Protection.of("", ("*", *hosts))
    files = static_files.PageFiles(directory=static, check_dir=False)
    page = partial(_built_page, "class.html", static)
    routes = [
        *(_hub(door, hub) if hub else _by_word(door, page)),
        Route("/projector", page),
        WebSocketRoute("/projected", partial(door.board, ProjectorView)),
        *_teachers(door, page),
        *_tables(Tables(room, visitors)),
        *_lessons(LessonUploads(room, visitors)),
        *RunPages(room, visitors, door.forwarder).routes(
            partial(_built_page, "hand-in-run.html", static)
        ),
        *GuestPages(room, visitors, door.forwarder).routes(
            partial(_built_page, "guest.html", static)
        ),
        *_pupils(door, page, static),
        # Files of the page are everybody's.
        Mount("/", files, middleware=[_GZIP]),
    ]
    if hub:
        routes = [Mount(hub.service.prefix.rstrip("/"), routes=routes)]
    return Starlette(
        routes=routes,
        middleware=[Middleware(Guard, protection=protection)],
        lifespan=door.lifespan,
    )


def _by_word(door: "_Door", page: Endpoint) -> Iterator[BaseRoute]:
    yield Route("/", page)
    yield Route("/about.json", door.about)
    yield Route("/word", door.word, methods=["POST"])
    yield Route("/join", door.join, methods=["POST"])
    yield Route("/leave", door.leave, methods=["POST"])


def _hub(door: "_Door", hub: HubLogin) -> Iterator[BaseRoute]:
    yield Route("/", partial(door.enter, hub))
    yield Route("/oauth_callback", partial(door.entered, hub))


def _teachers(door: "_Door", page: Endpoint) -> Iterator[BaseRoute]:
    yield Route("/teacher", door.teacher(page))
    yield Route("/hand-ins", door.teacher(page))
    yield Route("/lessons/{name}/pictures/{file}", door.teacher(lesson_picture))
    yield Route("/palette/{language}.json", door.teacher(palette), middleware=[_GZIP])
    yield Route("/export.zip", door.export)
    yield Route("/programs.json", door.programs)
    yield WebSocketRoute("/wall", partial(door.board, WallView))
    yield WebSocketRoute("/marking", partial(door.board, MarkingView))


def _tables(tables: Tables) -> Iterator[BaseRoute]:
    yield Route("/results.csv", tables.results)
    yield Route("/results.html", tables.page)
    yield Route("/marks.csv", tables.marks)


def _lessons(lessons: LessonUploads) -> Iterator[BaseRoute]:
    yield Route("/lessons", lessons.add, methods=["POST"])
    yield Route("/lessons", lessons.delete, methods=["DELETE"])


def _pupils(door: "_Door", page: Endpoint, static: Path) -> Iterator[BaseRoute]:
    yield WebSocketRoute("/p/{pupil}/ws", door.websocket)
    yield Route("/p/{pupil}/record", door.pupils(page))
    yield Route("/p/{pupil}/record.json", door.record)
    # Files of the page are everybody's.
    yield Mount("/p/{pupil}/assets", _folder(static / "assets"), middleware=[_GZIP])
    yield Mount("/p/{pupil}/media", _folder(static / "media"), middleware=[_GZIP])
    yield Route("/p/{pupil}/{path:path}", door.forward, methods=["GET", "POST"])


def _folder(folder: Path) -> static_files.PageFiles:
    return static_files.PageFiles(directory=folder, check_dir=False)


async def _built_page(name: str, static: Path, _: Request) -> Response:
    file = static / name
    if not file.is_file():
        return static_files.index(static)
    return HTMLResponse(file.read_text("utf-8"), headers={"cache-control": "no-store"})


class _Door:
    """Decides who is asking, and answers.

    Args:
        room: the class.
        visitors: recognises who sends a request.
        tls: whether browsers come by HTTPS only.
    """

    def __init__(self, room: Room, visitors: Visitors, *, tls: bool, base: str = "/") -> None:
        self._base = base
        self._room = room
        self._visitors = visitors
        self._badges = visitors.badges
        self._entrance = Entrance(room.roster)
        self.forwarder = Forwarder()
        self._tls = tls

    @asynccontextmanager
    async def lifespan(self, _: Starlette) -> AsyncIterator[None]:
        """Start and stop pupils' servers with the application."""
        await self._room.open()
        yield
        await self._room.close()
        await self.forwarder.close()

    # Who is asking.

    def _shown(self, request: HTTPConnection) -> tuple[Pupil, bool] | None:
        """The pupil of an address, and whether the teacher asks; None for everybody else."""
        pupil = self._room.roster.find(request.path_params["pupil"])
        if pupil is None:
            return None
        if self._visitors.pupil(request) == pupil:
            return pupil, False
        return (pupil, True) if self._visitors.is_teacher(request) else None

    def _is_secure(self, request: Request) -> bool:
        return self._tls or (self._room.is_hubs and came_by_https(request))

    def _give(self, request: Request, response: Response, name: str, badge: str) -> None:
        response.set_cookie(
            name,
            badge,
            path=self._base,
            max_age=_YEAR,
            httponly=True,
            samesite="strict",
            secure=self._is_secure(request),
        )

    # Joining.

    def teacher(self, page: Endpoint) -> Endpoint:
        """The wall's page; with the key in its address, the browser is the teacher's."""

        async def answer(request: Request) -> Response:
            key = request.query_params.get("key")
            if key is None:
                return await page(request) if self._visitors.is_teacher(request) else forbidden()
            if not self._badges.is_key(key):
                return forbidden()
            # Browsers keep a strict cookie back from where a link on another page redirects to.
            response = HTMLResponse(
                _ONWARD.format("teacher"), headers={"cache-control": "no-store"}
            )
            self._give(request, response, self._visitors.teachers_cookie, self._badges.of_teacher())
            return response

        return answer

    async def about(self, request: Request) -> Response:
        """What the class's page shows before anybody has joined."""
        roster, pupil = self._room.roster, self._visitors.pupil(request)
        return json_answer(
            ours.AboutClass(
                roster.title,
                roster.is_open,
                self._visitors.is_teacher(request),
                pupil.name if pupil else "",
                f"p/{pupil.id}/" if pupil else "",
            )
        )

    async def word(self, request: Request) -> Response:
        """Whether the join word is right, before the rest is typed."""
        try:
            message = _word.decode(await short_body(request))
            self._entrance.require_word(message.word, address_of(request))
        except (LearnBlockError, ValueError) as error:
            return json_answer(ours.NotJoined(phrase_of(error)), HTTPStatus.FORBIDDEN)
        return Response(status_code=HTTPStatus.NO_CONTENT)

    async def join(self, request: Request) -> Response:
        """Let a pupil in."""
        try:
            message = _join.decode(await short_body(request))
            pupil, pictures = await self._entrance.join(message, address_of(request))
        except AsksTeacherError as error:
            self._room.knock(checked_name(message.name))
            return json_answer(ours.NotJoined(error.phrase), HTTPStatus.FORBIDDEN)
        except (LearnBlockError, OSError, ValueError) as error:
            return json_answer(ours.NotJoined(phrase_of(error)), HTTPStatus.FORBIDDEN)
        self._room.desk(pupil)
        self._room.changed()
        response = json_answer(ours.Joined(f"p/{pupil.id}/", pictures))
        self._give(request, response, self._visitors.cookie, self._badges.of_pupil(pupil))
        return response

    async def enter(self, hub: HubLogin, request: Request) -> Response:
        """Lead to the wall, to the pupil's page, or to the hub's login."""
        if self._visitors.is_teacher(request):
            return RedirectResponse(f"{self._base}teacher")
        if pupil := self._visitors.pupil(request):
            return RedirectResponse(f"{self._base}p/{pupil.id}/")
        address, state = hub.begin()
        response = RedirectResponse(address)
        response.set_cookie(
            hub.cookie,
            state,
            path=self._base,
            httponly=True,
            samesite="lax",
            secure=self._is_secure(request),
        )
        return response

    async def entered(self, hub: HubLogin, request: Request) -> Response:
        """Give a badge to who has logged in."""
        try:
            user = await hub.user(request)
        except (LearnBlockError, httpx.HTTPError, KeyError):
            return forbidden()
        if user is None:
            return forbidden()
        response = HTMLResponse(_ONWARD.format("./"), headers={"cache-control": "no-store"})
        response.delete_cookie(hub.cookie, path=self._base)
        if user.is_teacher:
            self._give(request, response, self._visitors.teachers_cookie, self._badges.of_teacher())
            return response
        pupil = await asyncio.to_thread(self._room.roster.admit, user.id, user.name)
        self._room.desk(pupil)
        self._room.changed()
        self._give(request, response, self._visitors.cookie, self._badges.of_pupil(pupil))
        return response

    async def leave(self, _: Request) -> Response:
        """Forget the pupil in this browser, so that another one can join."""
        response = Response(status_code=HTTPStatus.NO_CONTENT)
        response.delete_cookie(self._visitors.cookie)
        return response

    # Pages of pupils and of the teacher.

    async def forward(self, request: Request) -> Response:
        """Pass a request of a pupil's page on."""
        shown = self._shown(request)
        if shown is None:
            return forbidden() if request.path_params["path"] else RedirectResponse(self._base)
        pupil, is_teacher = shown
        if request.method == "POST" and is_teacher:
            return forbidden()
        return await reached(self._forwarded(request, pupil))

    async def _forwarded(self, request: Request, pupil: Pupil) -> Response:
        place = await self._room.place(pupil)
        if request.method == "POST":
            return await self._upload(request, self._room.desk(pupil), place)
        return await self.forwarder.ask(request, place)

    def pupils(self, page: Endpoint) -> Endpoint:
        """A page about a pupil, for the pupil and the teacher."""

        async def answer(request: Request) -> Response:
            return forbidden() if self._shown(request) is None else await page(request)

        return answer

    async def record(self, request: Request) -> Response:
        """What a pupil has done in all sessions."""
        shown = self._shown(request)
        if shown is None:
            return forbidden()
        pupil, is_teacher = shown
        room = self._room
        kept = room.desk(pupil).lesson_works
        record = partial(record_of, room.roster, room.hand_ins, pupil, kept=kept)
        return json_answer(await asyncio.to_thread(record, teaches=is_teacher))

    async def _upload(self, request: Request, desk: Desk, place: ServerAddress) -> Response:
        try:
            with desk.uploading():
                return await self.forwarder.upload(request, place)
        except LearnBlockError as error:
            return json_answer(error.phrase, HTTPStatus.BAD_REQUEST)

    async def websocket(self, socket: WebSocket) -> None:
        """Connect a page with a pupil's server."""
        shown = self._shown(socket)
        await accept_socket(socket)
        if shown is None:
            await close_socket(socket, FORBIDDEN)
            return
        pupil, is_teacher = shown
        desk = self._room.desk(pupil)
        try:
            async with served(socket):
                with nullcontext() if is_teacher else desk.opening():
                    place = await self._room.place(pupil)
                    first = no_messages if is_teacher else partial(self._room.first_lesson, pupil)
                    await Relay(socket, desk, is_teacher=is_teacher).serve(place, first)
        finally:
            self._room.left(pupil)

    async def board(self, view: type[View], socket: WebSocket) -> None:
        """Show the class to the teacher."""
        await socket.accept()
        if not self._visitors.is_teacher(socket):
            await close_socket(socket, FORBIDDEN)
            return
        await Board(socket, self._room, view()).serve()

    async def programs(self, request: Request) -> Response:
        """The newest program of each pupil, to be printed."""
        if not self._visitors.is_teacher(request):
            return forbidden()
        return json_answer(await asyncio.to_thread(class_programs, self._room.roster))

    async def export(self, request: Request) -> Response:
        """Everything that is kept about a pupil, or about all of them."""
        if not self._visitors.is_teacher(request):
            return forbidden()
        roster = self._room.roster
        pupil_id = request.query_params.get("pupil")
        pupils = [pupil for pupil in roster.pupils if pupil_id in (None, pupil.id)]
        content = await asyncio.to_thread(export, roster, pupils)
        disposition = 'attachment; filename="class.zip"'
        return Response(
            content, media_type="application/zip", headers={"content-disposition": disposition}
        )
