"""The files of the teacher's classes: downloaded, and opened on another computer."""

import tempfile
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from http import HTTPStatus
from pathlib import Path
from urllib.parse import quote

import msgspec
from anyio import CapacityLimiter, to_thread
from starlette.background import BackgroundTask
from starlette.requests import ClientDisconnect, HTTPConnection, Request
from starlette.responses import FileResponse, Response

from learnblock.errors import LearnBlockError, phrase_of
from learnblock.server.catalog.classes import ClassShelf
from learnblock.server.http.refusal import refusal

#: The largest file in bytes.
LARGEST = 1024**3


class ClassFiles:
    """The endpoints of the files of classes, for pages on this computer.

    Args:
        is_local: whether a request comes from this computer.
        classes: gives the teacher's classes; None if there can't be any.
    """

    def __init__(
        self,
        is_local: Callable[[HTTPConnection], bool],
        classes: Callable[[], Awaitable[ClassShelf | None]],
    ) -> None:
        self._is_local = is_local
        self._classes = classes
        # A class is large; one at a time is enough for one teacher.
        self._limiter = CapacityLimiter(1)

    async def download(self, request: Request) -> Response:
        """``classes/7b.lbclass``"""
        title = request.path_params["title"]
        folder = tempfile.TemporaryDirectory()
        target = Path(folder.name) / "class"
        try:
            shelf = await self._shelf(request)
            await to_thread.run_sync(shelf.pack, title, target, limiter=self._limiter)
        except (LearnBlockError, OSError) as error:
            folder.cleanup()
            return refusal(phrase_of(error))
        disposition = f"attachment; filename*=UTF-8''{quote(title)}.lbclass"
        return FileResponse(
            target,
            headers={"content-disposition": disposition},
            media_type="application/zip",
            background=BackgroundTask(folder.cleanup),
        )

    async def upload(self, request: Request) -> Response:
        """``classes``, with the file as the body.

        The reply is the name of the class, or the phrase of what is wrong with the file.
        """
        try:
            shelf = await self._shelf(request)
            async with _received(request) as file:
                title = await to_thread.run_sync(shelf.unpack, file, limiter=self._limiter)
        except ClientDisconnect:
            return Response(status_code=HTTPStatus.BAD_REQUEST)
        except (LearnBlockError, OSError) as error:
            return refusal(phrase_of(error))
        return Response(msgspec.json.encode(title), media_type="application/json")

    async def _shelf(self, request: Request) -> ClassShelf:
        classes = await self._classes() if self._is_local(request) else None
        if classes is None:
            raise LearnBlockError("server-classes-only-here")
        return classes


@asynccontextmanager
async def _received(request: Request) -> AsyncIterator[Path]:
    """The body of a request as a file, which is deleted afterwards.

    Raises:
        LearnBlockError: it is too large.
    """
    with tempfile.TemporaryDirectory() as folder:
        path, size = Path(folder) / "class.lbclass", 0
        with path.open("wb") as file:
            async for part in request.stream():
                size += len(part)
                if size > LARGEST:
                    raise LearnBlockError("class-file-too-large", most=LARGEST // 1024**3)
                file.write(part)
        yield path
