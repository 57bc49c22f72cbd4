"""What the benchmarks of the page share: a server, a browser, and the processor time of both."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import perf_counter
from typing import Any

from playwright.sync_api import Browser, Page, sync_playwright

from learnblock.project.files.folder import ProjectFolder
from learnblock.server.messages import New
from learnblock.server.pages import projecting

#: The project that every server has, and its example.
STARTED = "square"
#: The time in which the largest program appears on a slow machine, in ms.
TIMEOUT = 120_000
#: The first that is installed; it has no window, as in the tests.
BROWSERS = ("chromium-headless-shell", "chromium", "google-chrome")
#: There is no graphics card.
ARGUMENTS = ("--no-sandbox", "--enable-unsafe-swiftshader")
#: The size for which the page is designed.
SIZE = {"width": 1366, "height": 768}
#: Blocks and Block-Text side by side, with the output open.
SPLIT = {"split": True, "views": ["blocks", "blocktext"], "panel": True}
WIDE = {"width": 1800, "height": 900}


@contextmanager
def serving(*, started: bool = True) -> Iterator[str]:
    """Return the address of a server whose home folder has one project, or none."""
    with tempfile.TemporaryDirectory() as home:
        if started:
            project = projecting.new_project(New(STARTED, STARTED))
            ProjectFolder(Path(home, "projects")).write(project)
        command = [sys.executable, "-m", "learnblock", "--no-browser", "--port", "0"]
        environment = {**os.environ, "LEARNBLOCK_HOME": home}
        server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
        try:
            assert server.stdout  # noqa: S101
            found = re.search(r"http://\S+", server.stdout.readline())
            assert found  # noqa: S101
            yield found[0]
        finally:
            server.terminate()
            server.wait()


@contextmanager
def visitor(
    browser: Browser,
    script: Path,
    size: dict[str, int] = WIDE,
    layout: dict[str, Any] | None = SPLIT,
    *,
    tour: bool = False,
) -> Iterator[Page]:
    """Open a page that has already shown the tour, as a newcomer sees it if `layout` is None.

    With `tour` it still offers it.
    """
    likes: dict[str, Any] = {"tourDone": not tour, "language": "en", "sound": False}
    if layout is not None:
        likes |= {"stage": "explorer", "layout": layout}
    context = browser.new_context(viewport={**SIZE, **size}, locale="en")
    context.set_default_timeout(TIMEOUT)
    context.add_init_script(
        f"localStorage['learnblock.preferences'] ??= {json.dumps(json.dumps(likes))}"
    )
    context.add_init_script(path=script)
    try:
        yield context.new_page()
    finally:
        context.close()


@contextmanager
def chromium() -> Iterator[Browser]:
    found = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, BROWSERS)), None)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=found, args=ARGUMENTS)
        yield browser
        browser.close()


class Processors:
    """The processor time of the browser's and of the server's processes since this was made."""

    def __init__(self) -> None:
        self._began = perf_counter()
        self._before = spent()

    def cores(self, name: str) -> float:
        """Return the processors in use, on average, by the processes with this in their command."""
        return self._cores(process for process, (command, _) in spent().items() if name in command)

    def of(self, process: int) -> float:
        """Return the processors in use by one process."""
        return self._cores([process])

    def _cores(self, processes: Iterable[int]) -> float:
        took = spent()
        ticks = sum(
            took[process][1] - self._before.get(process, ("", 0))[1]
            for process in processes
            if process in took
        )
        return ticks / os.sysconf("SC_CLK_TCK") / (perf_counter() - self._began)


def spent() -> dict[int, tuple[str, int]]:
    """Return the commands and the clock ticks of all processes that this one has started."""
    found = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            command = folder.joinpath("cmdline").read_text(errors="replace").replace("\0", " ")
            fields = folder.joinpath("stat").read_text().rpartition(")")[2].split()
        except (FileNotFoundError, ProcessLookupError):
            continue  # It has ended.
        found[int(folder.name)] = (int(fields[1]), command, int(fields[11]) + int(fields[12]))
    own = {os.getpid()}
    while more := {process for process, (parent, *_) in found.items() if parent in own} - own:
        own |= more
    return {process: found[process][1:] for process in own - {os.getpid()}}
