"""A limit of time for every test, and what a test that exceeds it leaves to read.

pytest-timeout ends a test after ``timeout`` seconds (pyproject.toml, or its marker). This adds the
stacks of all threads to its report, and the names of the processes that the test started, which are
ended. Each try of a test and each clean-up has the whole time. A worker that hangs where no signal
reaches it ends ``GRACE`` seconds after the time of both, again with the stacks of all threads.
"""

import contextlib
import faulthandler
import os
import subprocess
import sys
import time
import traceback
from threading import enumerate as threads

import psutil
import pytest

from gate import folder_of

#: Seconds for a test, by folder: there a single wait may take a minute on a busy machine.
LIMITS = {"browser": 150, "wire": 120}
#: Seconds after the limit for what no signal reaches, such as a call of a library that hangs.
GRACE = 30

#: The limit of a test as pytest-timeout knows it, and when its set-up began.
LIMIT = pytest.StashKey()
BEGUN = pytest.StashKey[float]()
#: The error output of the process, which a test's own goes past.
ERRORS = pytest.StashKey[int]()


def pytest_configure(config):
    config.stash[ERRORS] = os.dup(sys.__stderr__.fileno())


def pytest_collection_modifyitems(items):
    for item in items:
        folder = folder_of(item)
        if folder in LIMITS and item.get_closest_marker("timeout") is None:
            item.add_marker(pytest.mark.timeout(LIMITS[folder]))


@pytest.hookimpl(tryfirst=True)
def pytest_timeout_set_timer(item, settings):
    """Note the limit; the plugin's own timer, which comes next, does the work."""
    item.stash[LIMIT] = settings


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    _restart(item)
    if settings := item.stash.get(LIMIT, None):
        # Once for a try and its clean-up: each call starts a thread, which thousands of tests feel.
        seconds = 2 * settings.timeout + GRACE
        errors = item.config.stash[ERRORS]
        faulthandler.dump_traceback_later(seconds, exit=True, file=errors)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_teardown(item):
    # The plugin stops its timer where a test fails, and a clean-up may hang then too.
    _restart(item)


def pytest_runtest_logfinish():
    faulthandler.cancel_dump_traceback_later()


def _restart(item):
    if settings := item.stash.get(LIMIT, None):
        item.config.hook.pytest_timeout_cancel_timer(item=item)
        item.config.hook.pytest_timeout_set_timer(item=item, settings=settings)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item, call):
    report = yield
    if call.when == "setup":
        item.stash[BEGUN] = call.start
    if call.excinfo and "from pytest-timeout" in str(call.excinfo.value):
        # A server or a browser that other tests use too began with the set-up of one of them.
        since = call.start if call.when == "call" else item.stash[BEGUN]
        report.sections.append(("Threads when the time was over", _stacks()))
        report.sections.append(("Processes that it had started, now ended", _end_children(since)))
    return report


def _stacks():
    frames = sys._current_frames()
    return "\n".join(
        f"{thread.name}:\n{''.join(traceback.format_stack(frames[thread.ident]))}"
        for thread in threads()
        if thread.ident in frames
    )


def _end_children(since):
    """End the processes started since a time; return a line for each."""
    since += _clock_error()
    ended = []
    for child in psutil.Process().children(recursive=True):
        with contextlib.suppress(psutil.NoSuchProcess):
            if child.create_time() >= since:
                ended.append(f"{child.pid} {' '.join(child.cmdline())[:200]}")
                child.kill()
    return "\n".join(ended) or "none"


def _clock_error():
    """Measure by how much the system's time of a start is early, as a number of at most 0.

    Linux counts from the second in which the computer started, in hundredths of a second.
    """
    now = time.time()
    with subprocess.Popen([sys.executable, "-c", ""]) as process:
        return min(0, psutil.Process(process.pid).create_time() - now - 0.02)
