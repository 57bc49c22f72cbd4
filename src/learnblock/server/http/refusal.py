"""The answer to a request that is refused."""

from http import HTTPStatus

import msgspec
from starlette.responses import Response

from learnblock.i18n import Phrase


def refusal(phrase: Phrase) -> Response:
    """Say why something can't be done; the page says it in its language."""
    return Response(
        msgspec.json.encode(phrase), HTTPStatus.BAD_REQUEST, media_type="application/json"
    )
