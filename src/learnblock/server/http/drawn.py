"""The blocks of a program in Block-Text, which the page draws beside the examples of the docs."""

import msgspec
from anyio import to_thread
from starlette.requests import Request
from starlette.responses import Response


async def drawn(request: Request) -> Response:
    """``drawn.json?text=main:…``; 404 for a text that has mistakes or is too long."""
    content = await to_thread.run_sync(_blocks, request.query_params.get("text", ""))
    if content is None:
        return Response(status_code=404)
    return Response(content, media_type="application/json", headers={"cache-control": "no-cache"})


def _blocks(text: str) -> bytes | None:
    from learnblock.lessons.drawing import drawn_part  # noqa: PLC0415 - it loads much

    workspace = drawn_part(text)
    return msgspec.json.encode(workspace) if workspace else None
