"""Fixtures and settings of all tests."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from uuid import uuid4

import pytest
from hypothesis import settings

TESTS = Path(__file__).parent

# Modules of helpers that several tests import, such as `runs`.
sys.path.insert(0, str(TESTS / "helpers"))

# The tiers, limits and reruns of the tests, and the report of the time that they took.
pytest_plugins = ("gate", "limits", "reruns", "spent")

# A busy machine takes longer for an example, which is no failure. In CI, Hypothesis would try the
# same examples each time.
settings.register_profile("untimed", deadline=None, derandomize=False)
settings.load_profile("untimed")

# A shell ignores Ctrl-C for background processes, and their children inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


#: Folders whose tests need the other end of a robot's wire, or a browser, and so depend on real
#: time. They run first: those with a wire keep time best in parallel, because they mostly wait, and
#: a browser is started once if its tests follow each other.
MARKED = ("wire", "browser")


#: What the processes that tests start import, and with it nearly all of LearnBlock.
IMPORTED = "hypothesis, learnblock.cli.page, learnblock.cli.programs, learnblock.server.pages.lobby"
IMPORTED += ", learnblock.runtime.child, learnblock.server.serve"


def pytest_configure(config):
    # The tests start more than a thousand processes. Where PYTHONDONTWRITEBYTECODE is set, each
    # would compile everything that it imports, which takes longer than most of these tests.
    if sys.dont_write_bytecode and not hasattr(config, "workerinput"):
        env = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
        subprocess.run([sys.executable, "-c", f"import {IMPORTED}"], env=env, check=True)


def pytest_xdist_auto_num_workers(config):
    """One worker per core; none for a single file or test, which then starts at once."""
    if config.args != config.getini("testpaths"):
        return 0
    # A third worker on two cores saves a tenth of the time, but tests with a wire then lose their
    # real time: a driven Thymio missed the place of its twin in two of three tries.
    return os.cpu_count() or 1


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items):
    items.sort(key=_turn)
    for item in items:
        folder = _folder(item)
        if folder in MARKED:
            item.add_marker(folder)
            item.add_marker("realtime")
        # The tests of a file share fixtures, such as a server, so one worker runs them all.
        if item.get_closest_marker("spread") is None:
            item.add_marker(pytest.mark.xdist_group(str(item.path.relative_to(TESTS))))


def _turn(item):
    folder = _folder(item)
    return MARKED.index(folder) if folder in MARKED else len(MARKED)


def _folder(item):
    return item.path.relative_to(TESTS).parts[0]


@pytest.fixture(autouse=True)
def own_home(tmp_path_factory, monkeypatch):
    """Use an empty home, so that no test sees or changes the files of the user who runs it."""
    # A random name, because numbering thousands of folders gets slower with each one.
    home = tmp_path_factory.mktemp(f"home-{uuid4().hex}", numbered=False)
    monkeypatch.setenv("LEARNBLOCK_HOME", str(home))
    for name in ("WORLD", "SEED", "PACE", "TRACE"):
        monkeypatch.delenv(f"LEARNBLOCK_{name}", raising=False)
    return home
