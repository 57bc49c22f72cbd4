"""Passes the requests of a pupil's page on to the pupil's server."""

from collections.abc import Iterable

import httpx
from starlette.background import BackgroundTask
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response, StreamingResponse

from learnblock.classroom.servers import Place

#: The limit of a request's body in bytes: a kept run that is brought along.
LARGEST_BODY = 40_000_000
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
        self._client = httpx.AsyncClient(timeout=_PATIENCE, trust_env=False)

    async def close(self) -> None:
        """Close all connections."""
        await self._client.aclose()

    async def forward(self, request: Request, place: Place) -> Response:
        """Pass a request on, and return the answer."""
        asked = self._client.build_request(
            request.method,
            f"http://{place.host}{request.url.path}",
            params=request.query_params,
            headers={**_chosen(request.headers.items(), _ASKED), "x-forwarded-for": "class"},
            cookies={"learnblock_token": place.token},
            content=await _body(request) if request.method == "POST" else None,
        )
        answer = await self._client.send(asked, stream=True)
        return StreamingResponse(
            answer.aiter_raw(),
            answer.status_code,
            _chosen(answer.headers.items(), _ANSWERED),
            background=BackgroundTask(answer.aclose),
        )


async def _body(request: Request) -> bytes:
    body = bytearray()
    async for chunk in request.stream():
        body += chunk
        if len(body) > LARGEST_BODY:
            raise HTTPException(413)
    return bytes(body)


def _chosen(headers: Iterable[tuple[str, str]], names: Iterable[str]) -> dict[str, str]:
    wanted = set(names)
    return {name: value for name, value in headers if name.lower() in wanted}
