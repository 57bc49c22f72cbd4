"""The pages of guests, on which they see the world of the pupil who has invited them."""

import asyncio
from collections.abc import Awaitable, Callable, Iterator
from functools import partial

from starlette.requests import HTTPConnection, Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route, WebSocketRoute
from starlette.websockets import WebSocket
from websockets.exceptions import InvalidHandshake, InvalidMessage

from learnblock.classroom.answers import close_socket, forbidden, reached
from learnblock.classroom.badges import Visitors
from learnblock.classroom.desk import TooManyPagesError
from learnblock.classroom.forward import Forwarder
from learnblock.classroom.guest_view import GuestView
from learnblock.classroom.pairs import PupilPair
from learnblock.classroom.room import Room
from learnblock.errors import LearnBlockError
from learnblock.server.http.protection import SUBPROTOCOL

Endpoint = Callable[[Request], Awaitable[Response]]

#: The path of a guest's page; no pupil's id has such a form.
PATH = "/p/guest-{owner}/"
#: Close codes, as the pages of pupils have them.
_FORBIDDEN, _TOO_MANY, _TRY_LATER = 4403, 4429, 1013


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
        yield Route(PATH, partial(self._page, page))
        yield WebSocketRoute(f"{PATH}ws", self._connect)
        for folder in ("textures", "worlds"):
            yield Route(f"{PATH}{folder}/{{path:path}}", self._file)

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
        await socket.accept(SUBPROTOCOL if socket.scope["subprotocols"] else None)
        pair = self._pair(socket)
        if pair is None:
            await close_socket(socket, _FORBIDDEN)
            return
        try:
            with pair.guest.opening():
                await self._serve(socket, pair)
        except TooManyPagesError as error:
            await close_socket(socket, _TOO_MANY, error.phrase)
        except (LearnBlockError, OSError, InvalidHandshake, InvalidMessage):
            await close_socket(socket, _TRY_LATER)
        except asyncio.CancelledError:
            # The class closes, and does not wait for a page's remaining messages.
            pass
        finally:
            if self._room.roster.find(pair.host.pupil.id):
                self._room.left(pair.host.pupil)

    async def _serve(self, socket: WebSocket, pair: PupilPair) -> None:
        # No server is started for a guest alone.
        if not pair.host.own_pages:
            await close_socket(socket, _TRY_LATER)
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
