"""Answers to requests that all pages of a class have in common."""

from collections.abc import Awaitable
from http import HTTPStatus

import httpx
import msgspec
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server.http import static_files
from learnblock.server.http.bodies import body
from learnblock.server.http.connections import network_of

#: The maximum number of bytes of a request to join.
LONGEST_BODY = 2000


async def reached(answer: Awaitable[Response]) -> Response:
    """The answer of another server, or the reason why there is none."""
    try:
        return await answer
    except httpx.InvalidURL:
        return Response(status_code=HTTPStatus.NOT_FOUND)
    except (LearnBlockError, httpx.HTTPError) as error:
        return PlainTextResponse(f"{error}\n", HTTPStatus.SERVICE_UNAVAILABLE)


def json_answer(message: msgspec.Struct | Phrase, status: int = HTTPStatus.OK) -> Response:
    """A message that browsers do not cache."""
    headers = {"cache-control": "no-store"}
    return Response(msgspec.json.encode(message), status, headers, "application/json")


def address_of(request: Request) -> str:
    """The network from which a request comes; its failed tries are counted together."""
    return network_of(request.client.host) if request.client else ""


def came_by_https(request: Request) -> bool:
    """Whether the first of the proxies on the way says that the browser used HTTPS.

    A forged header does no harm: cookies are then not sent over HTTP.
    """
    first, _, _ = request.headers.get("x-forwarded-proto", "").partition(",")
    return first.strip().lower() == "https"


def forbidden() -> Response:
    """The answer to a browser that may not see this."""
    return static_files.no_token()


async def short_body(request: Request) -> bytes:
    """The body of a request to join.

    Raises:
        LongBodyError: it is too long.
    """
    return await body(request, LONGEST_BODY)
