"""Pictures for the page: tags, faces and floors of worlds, and projects."""

from collections.abc import Callable
from functools import partial
from pathlib import Path, PurePath

from anyio import to_thread
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.lesson_pictures import PICTURE_TYPES

#: What a picture of a lesson may fetch or run.
_NOTHING = "default-src 'none'; style-src 'unsafe-inline'; sandbox"
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


async def project(folder: Path, request: Request) -> Response:
    """``projects/My%20square/picture.jpg``; a later picture has another address."""
    name = request.path_params["name"]
    return await _answer(partial(_project, folder, name), _WEEK, "image/jpeg")


async def lesson(request: Request) -> Response:
    """``lessons/1-first-drive/pictures/start.png``; nothing in an SVG is run or fetched."""
    name, file = request.path_params["name"], request.path_params["file"]
    media_type = PICTURE_TYPES.get(PurePath(file).suffix.lower())
    if media_type is None:
        return PlainTextResponse(f"{Phrase('server-no-picture')}\n", 404)
    answer = await _answer(partial(_lesson, name, file), "no-cache", media_type)
    answer.headers["content-security-policy"] = _NOTHING
    answer.headers["x-content-type-options"] = "nosniff"
    return answer


async def _answer(
    draw: Callable[[], bytes | None], keep: str, media_type: str = "image/png"
) -> Response:
    try:
        picture = await to_thread.run_sync(draw)
    except (LearnBlockError, OSError) as error:
        return PlainTextResponse(f"{error}\n", 404)
    if picture is None:
        return PlainTextResponse(f"{Phrase('server-no-picture')}\n", 404)
    return Response(picture, media_type=media_type, headers={"cache-control": keep})


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


def _lesson(name: str, file: str) -> bytes | None:
    from learnblock.server import catalog  # noqa: PLC0415

    return catalog.find_lesson(name).files.get(f"pictures/{file}")


def _project(folder: Path, name: str) -> bytes | None:
    from learnblock.project.files.folder import ProjectFolder  # noqa: PLC0415

    return ProjectFolder(folder).picture(name)
