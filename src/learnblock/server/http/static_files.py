"""The files of the built page, and how browsers may cache them."""

import html
import os
from pathlib import Path

from starlette.datastructures import Headers
from starlette.responses import HTMLResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

from learnblock.i18n import Phrase

BUILT = Path(__file__).parents[1] / "static"
#: The folder of files whose names contain a hash of their content.
_HASHED = "assets"
_YEAR = "public, max-age=31536000, immutable"

_BUILD = """<pre>cd frontend
npm ci --omit=peer
npm run build</pre>
"""


class PageFiles(StaticFiles):
    """Static files; browsers keep the hashed ones for a year, and check the others every time."""

    async def check_config(self) -> None:
        """Accept a missing folder, because the page can be built while the server runs."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Send a file, compressed if the build has compressed it and the browser accepts that."""
        packed = f"{path}.br"
        if not _takes_brotli(scope) or self.lookup_path(packed)[1] is None:
            return await super().get_response(path, scope)
        response = await super().get_response(packed, scope)
        response.headers["content-encoding"] = "br"
        response.headers.add_vary_header("accept-encoding")
        return response

    def file_response(
        self,
        full_path: str | os.PathLike[str],
        stat_result: os.stat_result,
        scope: Scope,
        status_code: int = 200,
    ) -> Response:
        response = super().file_response(full_path, stat_result, scope, status_code)
        hashed = Path(full_path).parent.name == _HASHED
        response.headers["cache-control"] = _YEAR if hashed else "no-cache"
        return response


def _takes_brotli(scope: Scope) -> bool:
    accepted = Headers(scope=scope).get("accept-encoding", "")
    return "br" in (coding.partition(";")[0].strip() for coding in accepted.split(","))


def index(folder: Path) -> Response:
    """The page, or instructions to build it."""
    file = folder / "index.html"
    if not file.is_file():
        return _page(503, Phrase("server-not-built-title"), Phrase("server-not-built"), _BUILD)
    return HTMLResponse(file.read_text("utf-8"), headers={"cache-control": "no-store"})


def no_token() -> Response:
    """The page for a request without the token."""
    title = Phrase("server-incomplete-address-title")
    return _page(403, title, Phrase("server-incomplete-address"))


def _page(status: int, title: Phrase, text: Phrase, more: str = "") -> Response:
    heading, paragraph = html.escape(str(title)), html.escape(str(text))
    content = (
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>LearnBlock</title>\n'
        f"<h1>{heading}</h1>\n<p>{paragraph}</p>\n{more}</html>"
    )
    return HTMLResponse(content, status)
