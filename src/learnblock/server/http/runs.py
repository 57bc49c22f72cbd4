"""The files of kept runs: downloaded, and opened from another computer."""

import asyncio
from collections.abc import Callable
from pathlib import Path
from urllib.parse import quote

import msgspec
from anyio import CapacityLimiter, to_thread
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server.http.bodies import LongBodyError, body
from learnblock.server.http.refusal import refusal

#: The largest file in bytes, and the seconds within which it must arrive.
LARGEST, PATIENCE = 40 * 1024 * 1024, 120.0
#: The files that may arrive at the same time; each is in memory as a whole.
MOST_UPLOADS = 4
_LOG = "application/octet-stream"


class RunFiles:
    """The endpoints of the files of kept runs.

    Args:
        folder: the projects folder.
        read_only: whether nothing may be written.
    """

    def __init__(self, folder: Path, *, read_only: bool) -> None:
        self._folder = folder
        self._read_only = read_only
        # Checking a large file takes much memory.
        self._limiter = CapacityLimiter(1)
        self._uploads = 0

    async def download(self, request: Request) -> Response:
        """``projects/My%20square/runs/1732380000000-1.why``"""
        name, run = request.path_params["name"], request.path_params["run"]
        return await self._answer(lambda: self._file(name, run))

    async def upload(self, request: Request) -> Response:
        """``projects/My%20square/runs?filename=far%20away.why``, with the file as the body.

        The reply is the id of the run, or the phrase of what is wrong with the file.
        """
        if self._uploads >= MOST_UPLOADS:
            return refusal(Phrase("kept-upload-busy"))
        self._uploads += 1
        try:
            return await self._upload(request)
        finally:
            self._uploads -= 1

    async def _upload(self, request: Request) -> Response:
        name, filename = request.path_params["name"], request.query_params.get("filename", "")
        try:
            async with asyncio.timeout(PATIENCE):
                data = await body(request, LARGEST)
        except (TimeoutError, ClientDisconnect):
            return refusal(Phrase("kept-upload-slow"))
        except LongBodyError:
            return refusal(Phrase("log-file-too-large", most=LARGEST // 2**20))
        return await self._answer(lambda: self._take_in(name, filename, data))

    async def _answer(self, action: Callable[[], Response]) -> Response:
        try:
            return await to_thread.run_sync(action, limiter=self._limiter)
        except LearnBlockError as error:
            return refusal(error.phrase)
        except OSError as error:
            return refusal(Phrase(error.strerror or str(error)))

    # The server answers before these imports.

    def _file(self, name: str, run: str) -> Response:
        from learnblock.project.files.folder import ProjectFolder  # noqa: PLC0415

        runs = ProjectFolder(self._folder).kept_runs(name)
        title = quote(f"{runs.find(run).name or name}.why")
        disposition = f"attachment; filename*=UTF-8''{title}"
        return Response(
            runs.read(run), media_type=_LOG, headers={"content-disposition": disposition}
        )

    def _take_in(self, name: str, filename: str, data: bytes) -> Response:
        from learnblock.project.files.folder import ProjectFolder  # noqa: PLC0415
        from learnblock.why.verification import verified  # noqa: PLC0415

        projects = ProjectFolder(self._folder, read_only=self._read_only)
        if not projects.file(name).is_file():
            raise LearnBlockError("kept-no-project", name=name[:100])
        blocks = verified(data).blocks
        title = filename.replace("\\", "/").rpartition("/")[2].removesuffix(".why")
        run = projects.kept_runs(name).add(
            projects.now(), blocks, name=title or "run", foreign=True
        )
        return Response(msgspec.json.encode(run), media_type="application/json")
