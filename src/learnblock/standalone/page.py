"""The page in one file, which the build makes of the page's own parts."""

import base64
import gzip
from pathlib import Path
from typing import Any

import msgspec

from learnblock.i18n import with_languages

#: The page without content: see `frontend/vite.standalone.config.ts`.
_PAGE = Path(__file__).parents[1] / "server" / "static" / "standalone.html"
_PLACE = "{content}"
_encoder = msgspec.json.Encoder(enc_hook=with_languages)


def filled(content: dict[str, Any]) -> str:
    """The page with a content: see `frontend/src/features/standalone/content.ts`."""
    packed = gzip.compress(_encoder.encode(content), mtime=0)
    page = _PAGE.read_text(encoding="utf-8")
    return page.replace(_PLACE, base64.b64encode(packed).decode(), 1)
