"""The pages with the run of a hand-in: for the teacher, and for the pupil whose hand-in it is."""

import asyncio
from collections.abc import Iterator
from contextlib import AbstractContextManager, nullcontext
from functools import partial

from starlette.requests import HTTPConnection, Request
from starlette.responses import Response
from starlette.routing import BaseRoute
from starlette.websockets import WebSocket

from learnblock.classroom.answers import forbidden, reached
from learnblock.classroom.badges import Visitors
from learnblock.classroom.desk import Desk
from learnblock.classroom.forward import Forwarder
from learnblock.classroom.hand_in_messages import HandInRun
from learnblock.classroom.hand_in_runs import PUPILS_PATH, TEACHERS_PATH, RunServer, beginning
from learnblock.classroom.page_sockets import (
    FORBIDDEN,
    Endpoint,
    accept_socket,
    close_socket,
    served,
    world_routes,
)
from learnblock.classroom.relay import Relay
from learnblock.classroom.room import Room
from learnblock.classroom.roster import Pupil
from learnblock.errors import LearnBlockError


class RunPages:
    """Decides who sees a run, and shows it.

    Args:
        room: the class.
        visitors: recognises who sends a request.
        forwarder: reaches servers.
    """

    def __init__(self, room: Room, visitors: Visitors, forwarder: Forwarder) -> None:
        self._room = room
        self._visitors = visitors
        self._forwarder = forwarder

    def routes(self, page: Endpoint) -> Iterator[BaseRoute]:
        """The addresses of the page, of its websocket, and of pictures of worlds."""
        for path in (TEACHERS_PATH, PUPILS_PATH):
            yield from world_routes(path, partial(self._page, page), self._connect, self._file)

    def _server(self, request: HTTPConnection) -> RunServer | None:
        """The server of who asks; None for those who may not."""
        owner = request.path_params.get("owner")
        if owner is None:
            runs = self._room.hand_in_runs
            return runs.teachers if self._visitors.is_teacher(request) else None
        pupil = self._visitors.pupil(request)
        return self._room.hand_in_runs.of_pupil(owner) if pupil and pupil.id == owner else None

    async def _page(self, page: Endpoint, request: Request) -> Response:
        return await page(request) if self._server(request) else forbidden()

    async def _file(self, request: Request) -> Response:
        """A picture of the world in which a hand-in runs."""
        server = self._server(request)
        return await reached(self._asked(request, server)) if server else forbidden()

    async def _asked(self, request: Request, server: RunServer) -> Response:
        async with server.used() as place:
            return await self._forwarder.ask(request, place)

    async def _connect(self, socket: WebSocket) -> None:
        """Connect the page with the server that runs a hand-in."""
        await accept_socket(socket)
        server, owner = self._server(socket), socket.path_params.get("owner")
        if server is None:
            await close_socket(socket, FORBIDDEN)
            return
        whose = {} if owner is None else {"pupil": owner}
        wanted = self._room.wanted_run
        try:
            pupil, run = await asyncio.to_thread(
                wanted, is_teacher=owner is None, **whose, **socket.query_params
            )
        except (LearnBlockError, TypeError, ValueError):
            await close_socket(socket, FORBIDDEN)
            return
        async with served(socket):
            with self._opening(owner, pupil):
                await self._serve(socket, server, run, pupil, is_pupils=owner is not None)

    def _opening(self, owner: str | None, pupil: Pupil) -> AbstractContextManager[None]:
        return nullcontext() if owner is None else self._room.desk(pupil).opening()

    async def _serve(
        self, socket: WebSocket, server: RunServer, run: HandInRun, pupil: Pupil, *, is_pupils: bool
    ) -> None:
        # A desk of its own, on which the program may be run, but nothing is handed in.
        desk = Desk(pupil, lambda: None, self._room.hand_ins)
        desk.writing = "yes"
        paces = self._room.desk(pupil).paces if is_pupils else None
        relay = Relay(socket, desk, is_teacher=True, paces=paces)
        relay.tell(run)
        async with server.page(relay, run.lesson) as place:
            await relay.serve(place, partial(beginning, run))
