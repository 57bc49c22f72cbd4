"""The bodies of requests."""

from starlette.requests import Request

from learnblock.errors import LearnBlockError


class LongBodyError(LearnBlockError):
    """The body of a request is too long."""


async def body(request: Request, most: int) -> bytes:
    """The body of a request.

    Raises:
        LongBodyError: it has more bytes than `most`.
    """
    received = bytearray()
    async for chunk in request.stream():
        received += chunk
        if len(received) > most:
            raise LongBodyError("server-message-too-long", count=len(received))
    return bytes(received)
