"""The pages of guests, on which they see the world of the pupil who has invited them."""

from collections.abc import Iterator
from functools import partial

from starlette.requests import HTTPConnection, Request
from starlette.responses import Response
from starlette.routing import BaseRoute
from starlette.websockets import WebSocket

from learnblock.classroom.answers import forbidden, reached
from learnblock.classroom.badges import Visitors
from learnblock.classroom.forward import Forwarder
from learnblock.classroom.guest_view import GuestView
from learnblock.classroom.page_sockets import (
    FORBIDDEN,
    TRY_LATER,
    Endpoint,
    accept_socket,
    close_socket,
    served,
    world_routes,
)
from learnblock.classroom.pairs import PupilPair
from learnblock.classroom.room import Room

#: The path of a guest's page; no pupil's id has such a form.
PATH = "/p/guest-{owner}/"


class GuestPages:
    """Decides who is a guest, and shows the host's world.

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
        return world_routes(PATH, partial(self._page, page), self._connect, self._file)

    def _pair(self, request: HTTPConnection) -> PupilPair | None:
        """The pair of the guest who asks; None for everybody else."""
        owner, pupil = request.path_params["owner"], self._visitors.pupil(request)
        return self._room.pairs.as_guest(owner) if pupil and pupil.id == owner else None

    async def _page(self, page: Endpoint, request: Request) -> Response:
        return await page(request) if self._pair(request) else forbidden()

    async def _file(self, request: Request) -> Response:
        pair = self._pair(request)
        if pair is None or not pair.host.own_pages:
            return forbidden()
        place = await self._room.place(pair.host.pupil)
        return await reached(self._forwarder.ask(request, place))

    async def _connect(self, socket: WebSocket) -> None:
        """Connect a guest's page with the host's server."""
        await accept_socket(socket)
        pair = self._pair(socket)
        if pair is None:
            await close_socket(socket, FORBIDDEN)
            return
        try:
            async with served(socket):
                with pair.guest.opening():
                    await self._serve(socket, pair)
        finally:
            if self._room.roster.find(pair.host.pupil.id):
                self._room.left(pair.host.pupil)

    async def _serve(self, socket: WebSocket, pair: PupilPair) -> None:
        # No server is started for a guest alone.
        if not pair.host.own_pages:
            await close_socket(socket, TRY_LATER)
            return
        pairs = self._room.pairs
        view = GuestView(socket, pair.guest.paces, partial(pairs.lose, pair))
        place = await self._room.place(pair.host.pupil)
        before = pair.view
        pairs.show(pair, view)
        if before:
            await before.replace()
        try:
            await view.serve(place, pair.project, pair.robot)
        finally:
            if pair.view is view:
                pairs.show(pair, None)
