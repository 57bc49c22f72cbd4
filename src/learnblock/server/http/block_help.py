"""The moving picture in the help of a block, for the page."""

from anyio import to_thread
from starlette.requests import Request
from starlette.responses import Response


async def block_help(request: Request) -> Response:
    """``help/controls_if.json``; 404 for a block without an example, such as a custom block."""
    content = await to_thread.run_sync(_picture, request.path_params["block"])
    if content is None:
        return Response(status_code=404)
    return Response(content, media_type="application/json", headers={"cache-control": "no-cache"})


def _picture(block: str) -> bytes | None:
    from learnblock.project.help.moving_picture import moving_picture  # noqa: PLC0415 - it loads much

    return moving_picture(block)
