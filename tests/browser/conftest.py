"""A real server, a real browser, and the pupil who sits before it."""

import os
import re
import secrets
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Error, expect, sync_playwright

from browser.pupil import PATIENCE, Pupil

ROOT = Path(__file__).parents[2]
#: Screenshots are kept there, for whoever wants to see what a test saw.
ARTEFACTS = Path(os.environ.get("LEARNBLOCK_ARTEFACTS", ROOT / "build" / "screenshots"))
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "microsoft-edge")
#: WebGL without a graphics card.
SOFTWARE_RENDERING = ["--enable-unsafe-swiftshader"]


def chromium():
    """The browser of this machine; where there is none the tests are skipped, but not in CI."""
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None and not os.environ.get("CI"):
        pytest.skip("no Chromium on this machine: apt install chromium")
    assert found, "CI has no Chromium"
    return found


class Server:
    """``learnblock`` as a user starts it, with a home and a folder of projects of its own.

    Started again it has the same address, as one that a teacher runs for a class.

    Args:
        home: its home.
        options: of the command line.
        errors: the file to which it tells what goes wrong; None for that of the tests.
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
        raise AssertionError("the server ended before it said its address")

    def kill(self):
        """As a crash of the machine would."""
        self.process.kill()
        self._gone()

    def stop(self):
        """As Ctrl-C does."""
        self.process.send_signal(signal.SIGINT)
        return self._gone()

    def _gone(self):
        status = self.process.wait(10)
        self.process.stdout.close()
        return status


@pytest.fixture(scope="package")
def server(tmp_path_factory):
    """One server for all tests that do it no harm."""
    server = Server(tmp_path_factory.mktemp("served-home"))
    yield server
    assert server.stop() == 0


@pytest.fixture
def own_server(tmp_path):
    """A server that may be killed."""
    server = Server(tmp_path)
    yield server
    if server.process.poll() is None:
        server.stop()


@pytest.fixture(scope="package")
def browser():
    """A browser that ends with these tests: its event loop would stand in the way of the others."""
    expect.set_options(timeout=PATIENCE)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium(), args=["--no-sandbox", *SOFTWARE_RENDERING]
        )
        yield browser
        browser.close()


@pytest.fixture
def sit_down(browser: Browser, request):
    """Makes a pupil who opens a server's page; an uncaught error in any page fails the test."""
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
def pupil(sit_down, server):
    """A pupil before the page, in English."""
    return sit_down(server)


def _leave(pupil):
    try:
        pupil.context.close()
    except Error as error:
        pytest.fail(f"the page could not be closed: {error}")
