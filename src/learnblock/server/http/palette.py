"""The palette for the page."""

import hashlib
from functools import lru_cache

import msgspec
from anyio import to_thread
from starlette.requests import Request
from starlette.responses import Response

from learnblock.storage.block_files import Version, version

#: The maximum number of cached languages, because requests may name any number of them.
_MOST_LANGUAGES = 16
_LONGEST_NAME = 20


async def palette(request: Request) -> Response:
    """``palette/es.json``"""
    language = request.path_params["language"][:_LONGEST_NAME]
    content = await to_thread.run_sync(lambda: _encoded(language, version()))
    etag = f'"{hashlib.sha256(content).hexdigest()[:32]}"'
    headers = {"etag": etag, "cache-control": "no-cache"}
    if request.headers.get("if-none-match", "").removeprefix("W/") == etag:
        return Response(status_code=304, headers=headers)
    return Response(content, media_type="application/json", headers=headers)


@lru_cache(_MOST_LANGUAGES)
def _encoded(language: str, blocks: Version) -> bytes:  # noqa: ARG001 - part of the cache key
    from learnblock.blocks.known import all_configurations  # noqa: PLC0415 - the server answers first
    from learnblock.blocks.palette import palette as made  # noqa: PLC0415

    return msgspec.json.encode(made(all_configurations(), language))
