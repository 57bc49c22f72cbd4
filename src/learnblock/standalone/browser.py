"""A browser without a window, in which a page makes a file."""

import base64
import binascii
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from learnblock.errors import LearnBlockError

#: The names of the commands; the first has no window at all.
_COMMANDS = (
    "chromium-headless-shell",
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "microsoft-edge",
    "chrome",
    "msedge",
)
#: Where browsers are that no command starts.
_PLACES = {
    "darwin": (
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
        "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
        "/Applications/Chromium.app/Contents/MacOS/Chromium",
    ),
    "win32": (
        r"C:\Program Files\Google\Chrome\Application\chrome.exe",
        r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
        r"C:\Program Files\Microsoft\Edge\Application\msedge.exe",
    ),
}
#: Ms of the page's own time, which passes as fast as the page works, and seconds of ours.
_BUDGET, _PATIENCE = 60_000, 120
_DONE = re.compile(r"<body[^>]* data-done=[^>]*>([A-Za-z0-9+/=]+)</body>")


def file_from(page: str) -> bytes:
    """Open a page, and return the file that it makes: in base64, all of its body.

    Raises:
        LearnBlockError: there is no browser that can, or it failed.
    """
    browser = _browser()
    with tempfile.TemporaryDirectory(prefix="learnblock-") as folder:
        shown = _open(page, browser, folder, "--dump-dom")
    match = _DONE.search(shown.decode(errors="replace"))
    try:
        return base64.b64decode(match[1] if match else "-", validate=True)
    except binascii.Error as error:
        raise LearnBlockError("picture-browser-failed", browser=browser) from error


def printed(page: str) -> bytes:
    """Open a page, and return it as PDF, as it would be printed.

    Raises:
        LearnBlockError: there is no browser that can, or it failed.
    """
    browser = _browser()
    with tempfile.TemporaryDirectory(prefix="learnblock-") as folder:
        file = Path(folder, "page.pdf")
        _open(page, browser, folder, f"--print-to-pdf={file}", "--no-pdf-header-footer")
        if not file.is_file():
            raise LearnBlockError("picture-browser-failed", browser=browser)
        return file.read_bytes()


def _open(page: str, browser: str, folder: str, *wanted: str) -> bytes:
    """Open a page, and return what the browser writes."""
    path = Path(folder, "page.html")
    path.write_text(page, encoding="utf-8")
    command = [browser, *_options(folder), *wanted, path.as_uri()]
    try:
        done = subprocess.run(  # noqa: S603 - a browser, with a page of ours
            command, capture_output=True, timeout=_PATIENCE, check=False
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise LearnBlockError("picture-browser-failed", browser=browser) from error
    return done.stdout


def _browser() -> str:
    for browser in _candidates():
        return browser
    raise LearnBlockError("picture-no-browser")


def _candidates() -> Iterator[str]:
    yield from filter(None, map(shutil.which, _COMMANDS))
    yield from (place for place in _PLACES.get(sys.platform, ()) if Path(place).is_file())


def _options(folder: str) -> list[str]:
    """Nothing of the user's browser is used or changed, and the page has no network."""
    options = [
        "--headless",
        "--disable-gpu",
        "--no-first-run",
        "--disable-extensions",
        "--disable-background-networking",
        f"--user-data-dir={Path(folder, 'profile')}",
        f"--virtual-time-budget={_BUDGET}",
    ]
    # Chromium starts for root only without its own sandbox; the page is ours.
    if sys.platform != "win32" and os.geteuid() == 0:
        options.append("--no-sandbox")
    return options
