"""Fixtures: a real server, a real browser, and a pupil who uses them."""

import os
import re
import secrets
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from urllib.parse import urlencode, urlsplit

import pytest
from playwright.sync_api import Browser, Error, expect, sync_playwright

from browser.pupil import FLAT, TIMEOUT, Pupil
from gate import in_gate
from learnblock.project.files.folder import ProjectFolder
from learnblock.server.messages import New
from learnblock.server.pages import projecting
from places import ROOT

#: The folder for a screenshot of a failure.
FAILURES = Path(os.environ.get("LEARNBLOCK_ARTEFACTS", ROOT / "build" / "screenshots"))
#: The folder for the screenshots of the tests; nobody looks at those of the gate.
ARTEFACTS = None if in_gate() else FAILURES
#: The first has no window, which saves a tenth of the time.
BROWSERS = (
    "chromium-headless-shell",
    "chromium",
    "chromium-browser",
    "google-chrome",
    "microsoft-edge",
)
#: WebGL without a graphics card.
SOFTWARE_RENDERING = ["--enable-unsafe-swiftshader"]


def chromium():
    """Return the path of the browser; without one, skip the tests except in CI."""
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None and not os.environ.get("CI"):
        pytest.skip("no Chromium on this machine: apt install chromium")
    assert found, "CI has no Chromium"
    return found


class Server:
    """The command ``learnblock``, with its own home and folder of projects.

    A restarted server keeps its address, like one that a teacher runs for a class.

    Args:
        home: its folder LEARNBLOCK_HOME.
        options: options of the command line.
        errors: the file for its error output; None for that of the tests.
    """

    def __init__(self, home, *options, errors=None):
        self.home = home
        self.options = options
        self.errors = errors
        self.token = secrets.token_urlsafe()
        self.port = 0
        self.start()

    def start(self):
        self.process = subprocess.Popen(
            [
                sys.executable,
                "-m",
                "learnblock",
                "--no-browser",
                f"--port={self.port}",
                *self.options,
            ],
            stdout=subprocess.PIPE,
            stderr=self.errors,
            text=True,
            env={
                **os.environ,
                "LEARNBLOCK_HOME": str(self.home),
                "LEARNBLOCK_TOKEN": self.token,
            },
        )
        assert self.process.stdout
        for line in self.process.stdout:
            if found := re.search(r"http://\S+", line):
                self.address = found[0]
                self.port = urlsplit(self.address).port
                return
        raise AssertionError("the server ended before it printed its address")

    def address_of_new_project(self):
        """Put an empty project into the folder; return the address of its page.

        That loads the page once, while a pupil who begins one has to open another project first.
        """
        projects = ProjectFolder(self.home / "projects")
        name = projects.free_name("program")
        projects.write(projecting.new_project(New(name)))
        return self.address_of(name)

    def address_of_last_project(self):
        """Return the address of the project that was changed last; at first, that of a square."""
        projects = ProjectFolder(self.home / "projects")
        if not projects.entries():
            projects.write(projecting.new_project(New("square", "square")))
        return self.address_of(projects.entries()[0].name)

    def address_of(self, project):
        """Return the address of a project's page."""
        return f"{self.address}#{urlencode({'project': project})}"

    def kill(self):
        """Kill the process, as a crash of the computer would."""
        self.process.kill()
        self._gone()

    def stop(self):
        """Stop the server as Ctrl-C does; return its exit status."""
        self.process.send_signal(signal.SIGINT)
        return self._gone()

    def _gone(self):
        status = self.process.wait(10)
        self.process.stdout.close()
        return status


@pytest.fixture(scope="package")
def server(tmp_path_factory):
    """A server shared by all tests that do not damage it."""
    server = Server(tmp_path_factory.mktemp("served-home"))
    yield server
    assert server.stop() == 0


@pytest.fixture
def own_server(tmp_path):
    """A server for one test, which may kill it."""
    server = Server(tmp_path)
    yield server
    if server.process.poll() is None:
        server.stop()


@pytest.fixture(scope="package")
def browser():
    """A browser that closes after these tests: its event loop would disturb the others."""
    expect.set_options(timeout=TIMEOUT)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium(), args=["--no-sandbox", *SOFTWARE_RENDERING]
        )
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def axe():
    """The code of axe, which only contributors install."""
    code = ROOT / "frontend" / "node_modules" / "axe-core" / "axe.min.js"
    if not code.exists():
        pytest.skip("no axe-core: npm ci in frontend")
    return code.read_text()


@pytest.fixture
def sit_down(browser: Browser, request):
    """A function that opens a page as a pupil; an uncaught error in a page fails the test."""
    pupils = []

    def make(server, **options):
        pupils.append(Pupil(browser, server, ARTEFACTS, request.node.name, **options))
        return pupils[-1]

    yield make
    errors = [error for pupil in pupils for error in pupil.errors]
    for pupil in pupils:
        _leave(pupil)
    assert errors == []


@pytest.fixture
def desk(browser):
    """A function that opens a page in a browser of its own; an uncaught error fails the test."""
    contexts, errors = [], []

    def sit_down(address, width=1366, height=768, *, flat=True, **options):
        viewport = {"width": width, "height": height}
        context = browser.new_context(viewport=viewport, locale="en", **options)
        context.set_default_timeout(20_000)
        # Most of these tests don't look at worlds: drawing one takes half of the time of a page.
        if flat:
            context.add_init_script(FLAT)
        context.add_init_script(
            "localStorage['learnblock.preferences'] ??= JSON.stringify("
            "{tourDone: true, sound: false, theme: 'light'})"
        )
        contexts.append(context)
        page = context.new_page()
        page.on("pageerror", lambda error: errors.append(error.stack or str(error)))
        page.goto(address)
        return page

    yield sit_down
    for context in contexts:
        context.close()
    assert errors == []


@pytest.fixture
def pupil(sit_down, server):
    """A pupil who has opened the page in English."""
    return sit_down(server)


def _leave(pupil):
    try:
        pupil.context.close()
    except Error as error:
        pytest.fail(f"the page could not be closed: {error}")
