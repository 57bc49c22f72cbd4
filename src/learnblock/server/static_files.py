"""The built page's files, and what may be kept of them by whom."""

import os
from pathlib import Path

from starlette.datastructures import Headers
from starlette.responses import HTMLResponse, Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

BUILT = Path(__file__).parent / "static"
#: Vite puts a hash of their content into the names of these: another content, another name.
_HASHED = "assets"
_YEAR = "public, max-age=31536000, immutable"

_NOT_BUILT = """<!doctype html><html lang="en"><meta charset="utf-8"><title>LearnBlock</title>
<h1>The page has not been built</h1>
<p>This is LearnBlock's server, from a checkout without the built page. Build it once, with Node.js:
<pre>cd frontend
npm ci --omit=peer
npx vite build</pre>
<p>and reload. An installed LearnBlock brings its page with it.</html>"""

_INCOMPLETE = """<!doctype html><html lang="en"><meta charset="utf-8"><title>LearnBlock</title>
<h1>This address is not complete</h1>
<p>Open the whole address that <code>learnblock</code> printed when it was started: it ends in
<code>?token=</code> and a long word. It is new each time.</html>"""


class PageFiles(StaticFiles):
    """Static files of which the hashed ones are kept for good, and the others asked for again."""

    async def check_config(self) -> None:
        """The folder may come later: the page can be built while the server runs."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """The file; packed, where the build has packed it and the browser says it can unpack it."""
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
    return "br" in (one.partition(";")[0].strip() for one in accepted.split(","))


def index(folder: Path) -> Response:
    """The page itself, or how to build it."""
    file = folder / "index.html"
    if not file.is_file():
        return HTMLResponse(_NOT_BUILT, 503)
    return HTMLResponse(file.read_text("utf-8"), headers={"cache-control": "no-store"})


def no_token() -> Response:
    """What someone sees who comes without the token."""
    return HTMLResponse(_INCOMPLETE, 403)
