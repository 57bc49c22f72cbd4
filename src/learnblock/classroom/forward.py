"""Passes the requests of a pupil's page on to the pupil's server."""

import asyncio
from collections.abc import AsyncIterator, Iterable

import httpx
from starlette.background import BackgroundTask
from starlette.requests import Request
from starlette.responses import Response, StreamingResponse

from learnblock.classroom.limits import LARGEST_UPLOAD, UPLOAD_PATIENCE
from learnblock.classroom.servers import ServerAddress
from learnblock.errors import LearnBlockError

#: Seconds within which a pupil's server answers.
_PATIENCE = 20.0
#: The headers that matter to the server, and to the page.
_ASKED = ("accept", "accept-encoding", "content-type", "if-modified-since", "if-none-match")
_ANSWERED = (
    "cache-control", "content-disposition", "content-encoding", "content-length", "content-type",
    "etag", "last-modified", "vary",
)  # fmt: skip


class Forwarder:
    """The connections to pupils' servers."""

    def __init__(self) -> None:
        # As many as browsers have: with fewer, some that read slowly would keep all others waiting.
        limits = httpx.Limits(max_connections=None, max_keepalive_connections=20)
        self._client = httpx.AsyncClient(timeout=_PATIENCE, limits=limits, trust_env=False)

    async def close(self) -> None:
        """Close all connections."""
        await self._client.aclose()

    async def ask(self, request: Request, place: ServerAddress) -> Response:
        """Pass a request without a body on, and return the answer.

        Raises:
            httpx.HTTPError: the server does not answer.
            httpx.InvalidURL: there can be no such address.
        """
        return await self._send(request, place, None)

    async def upload(self, request: Request, place: ServerAddress) -> Response:
        """Pass a request on while its body arrives, and return the answer.

        Raises:
            LearnBlockError: the body is too large, or takes too long.
            ClientDisconnect: the browser has gone.
            httpx.HTTPError: the server does not answer.
            httpx.InvalidURL: there can be no such address.
        """
        try:
            async with asyncio.timeout(UPLOAD_PATIENCE):
                return await self._send(request, place, _body(request))
        except TimeoutError:
            raise LearnBlockError("kept-upload-slow") from None

    async def _send(
        self, request: Request, place: ServerAddress, body: AsyncIterator[bytes] | None
    ) -> Response:
        path = request.path_params["path"]
        # At a hub, it would lead to the servers of others.
        if ".." in path.split("/"):
            raise httpx.InvalidURL(path)
        forwarded = self._client.build_request(
            request.method,
            place.url("http", path),
            params=request.query_params,
            headers={
                **_chosen(request.headers.items(), _ASKED),
                **place.headers,
                "x-forwarded-for": "class",
            },
            cookies={"learnblock_token": place.token} if place.token else None,
            content=body,
        )
        answer = await self._client.send(forwarded, stream=True)
        return StreamingResponse(
            answer.aiter_raw(),
            answer.status_code,
            _chosen(answer.headers.items(), _ANSWERED),
            background=BackgroundTask(answer.aclose),
        )


async def _body(request: Request) -> AsyncIterator[bytes]:
    """The body as it arrives, so that no more than a part of it is kept here."""
    size = 0
    async for chunk in request.stream():
        size += len(chunk)
        if size > LARGEST_UPLOAD:
            raise LearnBlockError("log-file-too-large", most=LARGEST_UPLOAD // 1_000_000)
        yield chunk


def _chosen(headers: Iterable[tuple[str, str]], names: Iterable[str]) -> dict[str, str]:
    wanted = set(names)
    return {name: value for name, value in headers if name.lower() in wanted}
