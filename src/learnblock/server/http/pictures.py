"""Pictures for the world on the page: tags, faces and floors."""

from collections.abc import Callable
from functools import partial

from anyio import to_thread
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase

#: Tags and faces never change.
_WEEK = "private, max-age=604800"


async def tag(request: Request) -> Response:
    """``textures/tag/7.png``"""
    return await _answer(partial(_tag, request.path_params["number"]), _WEEK)


async def face(request: Request) -> Response:
    """``textures/face/joy.png``"""
    return await _answer(partial(_face, request.path_params["name"]), _WEEK)


async def floor(request: Request) -> Response:
    """``worlds/line/floor.png``; not cached, because the user may be editing it."""
    return await _answer(partial(_floor, request.path_params["name"]), "no-cache")


async def _answer(draw: Callable[[], bytes | None], keep: str) -> Response:
    try:
        png = await to_thread.run_sync(draw)
    except (LearnBlockError, OSError) as error:
        return PlainTextResponse(f"{error}\n", 404)
    if png is None:
        return PlainTextResponse(f"{Phrase('server-no-floor-picture')}\n", 404)
    return Response(png, media_type="image/png", headers={"cache-control": keep})


# The simulator is slow to import, and the server answers before that.


def _tag(number: int) -> bytes:
    from learnblock.monitor.worlds import tag_picture  # noqa: PLC0415

    return tag_picture(number)


def _face(name: str) -> bytes:
    from learnblock.monitor.worlds import face_picture  # noqa: PLC0415

    return face_picture(name)


def _floor(name: str) -> bytes | None:
    from learnblock.monitor.worlds import floor_picture  # noqa: PLC0415
    from learnblock.server import catalog  # noqa: PLC0415

    catalog.check_world_name(name)
    return floor_picture(name)
