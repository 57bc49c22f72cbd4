"""The application: the page's files, its pictures, and its websocket."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable, Iterable
from contextlib import asynccontextmanager, suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from anyio import to_thread
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import Request
from starlette.responses import RedirectResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.websockets import WebSocket

from learnblock.i18n import Phrase
from learnblock.server.catalog.classes import ClassShelf
from learnblock.server.http import static_files
from learnblock.server.http.address import own_address
from learnblock.server.http.block_help import block_help
from learnblock.server.http.classes import ClassFiles
from learnblock.server.http.drawn import drawn
from learnblock.server.http.palette import palette
from learnblock.server.http.pictures import face, floor, lesson, project, tag
from learnblock.server.http.protection import (
    COOKIE,
    SEAT,
    SUBPROTOCOL,
    Guard,
    Protection,
    offered_token,
)
from learnblock.server.http.runs import RunFiles
from learnblock.server.sessions.periods import Periods

if TYPE_CHECKING:
    from learnblock.server.pages.lobby import Lobby

#: A close code that tells the page not to reconnect, because the token is wrong.
FORBIDDEN = 4403
_PERIODS = Periods()
_GZIP = Middleware(GZipMiddleware, minimum_size=1000, compresslevel=5)

Endpoint = Callable[[Request], Awaitable[Response]]


def create_app(
    folder: Path,
    *,
    token: str,
    hosts: Iterable[str] = (),
    origins: Iterable[str] = (),
    proxy_sends_token: bool = False,
    base_url: str = "/",
    static: Path = static_files.BUILT,
    periods: Periods = _PERIODS,
    read_only: Phrase | None = None,
    for_others: bool = False,
    for_one: bool = False,
    classes: Callable[[], ClassShelf] | None = None,
) -> Starlette:
    """Create the server as an ASGI application.

    Args:
        folder: the projects folder, which may not exist yet.
        token: the secret that gives access to the server.
        hosts: allowed names of the server besides those of the computer itself; ``*`` is any
            numeric address.
        origins: hosts of other pages that may use the server.
        proxy_sends_token: whether a proxy sends the token for users that it has logged in.
        base_url: the path of the page.
        static: the folder of the built page.
        periods: how long an open project waits to be saved, and to be closed.
        read_only: why nothing may be written; None if it may.
        for_others: whether other computers can connect.
        for_one: whether all pages belong to one person, on any device.
        classes: gives the teacher's classes; None if there can't be any.
    """
    protection = Protection.of(token, hosts, origins, proxy_sends_token=proxy_sends_token)
    lobby = _LateLobby(folder, periods, read_only, classes, for_others=for_others, for_one=for_one)
    routes = _routes(protection, static, folder, lobby, read_only=read_only is not None)
    base = "/" + base_url.strip("/")
    if base != "/":
        # Relative addresses of the page need the slash at the end.
        routes = [Route(base, _to_folder), Mount(base, routes=routes)]
    app = Starlette(
        routes=routes,
        middleware=[Middleware(Guard, protection=protection)],
        lifespan=lobby.lifespan,
    )
    # For a server whose event loop hangs, see `LastResort`.
    app.state.save = lobby.save
    return app


def _routes(
    protection: Protection, static: Path, folder: Path, lobby: "_LateLobby", *, read_only: bool
) -> list[BaseRoute]:
    private = partial(_private, protection)
    runs = RunFiles(folder, read_only=read_only)
    classes = ClassFiles(protection.is_local, lobby.classes)
    return [
        Route("/", private(partial(_index, static, protection))),
        Route("/palette/{language}.json", private(palette), middleware=[_GZIP]),
        Route("/help/{block}.json", private(block_help), middleware=[_GZIP]),
        Route("/drawn.json", private(drawn), middleware=[_GZIP]),
        Route("/textures/tag/{number:int}.png", private(tag)),
        Route("/textures/face/{name}.png", private(face)),
        Route("/worlds/{name}/floor.png", private(floor)),
        Route("/lessons/{name}/pictures/{file}", private(lesson)),
        Route("/projects/{name}/picture.jpg", private(partial(project, folder))),
        Route("/projects/{name}/runs/{run}.why", private(runs.download)),
        Route("/projects/{name}/runs", private(runs.upload), methods=["POST"]),
        Route("/classes", private(classes.upload), methods=["POST"]),
        Route("/classes/{title}.lbclass", private(classes.download)),
        WebSocketRoute("/ws", partial(_websocket, protection, lobby)),
        Mount("/", static_files.PageFiles(directory=static, check_dir=False), middleware=[_GZIP]),
    ]


def _private(protection: Protection, endpoint: Endpoint) -> Endpoint:
    """Require the token for an endpoint."""

    async def answer(request: Request) -> Response:
        return await endpoint(request) if protection.trusts(request) else static_files.no_token()

    return answer


async def _index(static: Path, protection: Protection, request: Request) -> Response:
    response = static_files.index(static)
    if protection.proxy_sends_token:
        return response
    # One name per port, because cookies don't distinguish between servers on the same computer.
    name = f"{COOKIE}_{request.url.port or 'page'}"
    path = request.url.path
    response.set_cookie(name, protection.token, path=path, httponly=True, samesite="strict")
    return response


async def _to_folder(request: Request) -> Response:
    return RedirectResponse(request.url.replace(path=request.url.path + "/"))


async def _websocket(protection: Protection, lobby: "_LateLobby", socket: WebSocket) -> None:
    # The guard has checked the token that a proxy sends.
    trusted = protection.proxy_sends_token or protection.knows(
        offered_token(socket.scope["subprotocols"])
    )
    # Always accept, because a browser doesn't tell its page why a handshake failed.
    await socket.accept(SUBPROTOCOL if socket.scope["subprotocols"] else None)
    if trusted:
        # When the server stops, it doesn't wait for a page's remaining messages.
        with suppress(asyncio.CancelledError):
            is_local, has_seat = protection.is_local(socket), SEAT in socket.query_params
            await (await lobby.get()).serve(socket, is_local=is_local, has_seat=has_seat)
    else:
        await socket.close(FORBIDDEN, "the token is wrong")


class _LateLobby:
    """The lobby; its imports start once the server is responding."""

    def __init__(
        self,
        folder: Path,
        periods: Periods,
        read_only: Phrase | None,
        classes: Callable[[], ClassShelf] | None,
        *,
        for_others: bool,
        for_one: bool,
    ) -> None:
        self._classes = classes
        self._for_others = for_others
        self._for_one = for_one
        self._folder = folder
        self._periods = periods
        self._read_only = read_only
        self._making: asyncio.Task[Lobby] | None = None
        self._loop: asyncio.AbstractEventLoop | None = None

    @asynccontextmanager
    async def lifespan(self, _: Starlette) -> AsyncIterator[None]:
        """Create the lobby at the start, and close it at the end."""
        self._loop = asyncio.get_running_loop()
        self._making = asyncio.create_task(to_thread.run_sync(self._made))
        yield
        await (await self._making).close()

    async def get(self) -> "Lobby":
        """Return the lobby once it is ready."""
        assert self._making is not None  # noqa: S101 - the server starts up before it serves
        return await asyncio.shield(self._making)

    async def classes(self) -> ClassShelf | None:
        """The teacher's classes, if there can be any."""
        return (await self.get()).classes

    def save(self, seconds: float) -> Iterable[Phrase]:
        """Save all projects from another thread: see `Sessions.save_from_outside`."""
        if self._loop is None or self._making is None or not self._making.done():
            return ()
        return self._making.result().save_from_outside(self._loop, seconds)

    def _made(self) -> "Lobby":
        from learnblock.server.pages.lobby import Lobby  # noqa: PLC0415

        address = own_address() if self._for_others else None
        return Lobby(
            self._folder,
            self._periods,
            self._read_only,
            for_others=self._for_others,
            for_one=self._for_one,
            address=address,
            classes=self._classes() if self._classes else None,
        )
