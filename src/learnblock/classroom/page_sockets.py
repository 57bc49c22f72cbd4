"""The websockets of pages: where they are, how they are accepted, and why they are closed."""

import asyncio
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import asynccontextmanager, suppress

import msgspec
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect
from websockets.exceptions import InvalidHandshake, InvalidMessage

from learnblock.classroom.desk import TooManyPagesError
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server.http.protection import SUBPROTOCOL
from learnblock.server.messages import Failed

Endpoint = Callable[[Request], Awaitable[Response]]
Connect = Callable[[WebSocket], Awaitable[None]]

#: Close codes: this browser may not be here; it has too many pages.
FORBIDDEN, TOO_MANY = 4403, 4429
#: Close codes after which a page connects again by itself: the server will be back; it is not ready
#: yet.
BACK_SOON, TRY_LATER = 1012, 1013


def world_routes(
    path: str, page: Endpoint, connect: Connect, file: Endpoint
) -> Iterator[BaseRoute]:
    """The addresses of a page that shows a world: its own, its websocket's, and its pictures'.

    Args:
        path: of the page, with a slash at its end.
        page: answers with the page.
        connect: serves its websocket.
        file: answers with a picture of the world.
    """
    yield Route(path, page)
    yield WebSocketRoute(f"{path}ws", connect)
    for folder in ("textures", "worlds"):
        yield Route(f"{path}{folder}/{{path:path}}", file)


async def accept_socket(socket: WebSocket) -> None:
    """Accept a page's connection: a browser doesn't tell its page why a handshake failed."""
    await socket.accept(SUBPROTOCOL if socket.scope["subprotocols"] else None)


async def close_socket(socket: WebSocket, code: int, reason: Phrase | None = None) -> None:
    """Close a page's connection, and say why; the page may have gone already."""
    with suppress(RuntimeError, WebSocketDisconnect):
        if reason:
            await socket.send_text(msgspec.json.encode(Failed(reason)).decode())
        await socket.close(code)


@asynccontextmanager
async def served(socket: WebSocket) -> AsyncIterator[None]:
    """Serve a page inside; close its connection with the reason if that fails."""
    try:
        yield
    except TooManyPagesError as error:
        await close_socket(socket, TOO_MANY, error.phrase)
    except (LearnBlockError, OSError, InvalidHandshake, InvalidMessage):
        # Its server has just ended, or is too busy to start: the page tries again by itself.
        await close_socket(socket, TRY_LATER)
    except asyncio.CancelledError:
        # The class closes, and does not wait for a page's remaining messages.
        pass
