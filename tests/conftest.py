"""Fixtures and settings of all tests."""

import gc
import os
import signal
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from uuid import uuid4

import pytest
from hypothesis import settings

TESTS = Path(__file__).parent

# Modules of helpers that several tests import, such as `runs`.
sys.path.insert(0, str(TESTS / "helpers"))

# The tiers, cores, limits and reruns of the tests, the runs that they share, and the time that they
# took.
pytest_plugins = ("gate", "cores", "limits", "made_runs", "reruns", "spent")

# A busy machine takes longer for an example, which is no failure. The examples are new each time
# also where `CI` is set, which Hypothesis takes as a wish for the same ones.
settings.register_profile("untimed", deadline=None, derandomize=False)
settings.load_profile("untimed")

# To rewrite the assertions of all tests takes half of the time of collecting them, so the result is
# kept, also where PYTHONDONTWRITEBYTECODE is set.
sys.dont_write_bytecode = False

# A shell ignores Ctrl-C for background processes, and their children inherit that.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


#: Folders whose tests need the other end of a robot's wire, or a browser, and so depend on real
#: time. They run first: those with a wire keep time best in parallel, because they mostly wait, and
#: a browser is started once if its tests follow each other.
MARKED = ("wire", "browser")


#: The packages that the processes of tests load: ours, the server's, the cluster's and pytest.
LOADED = (
    "learnblock", "_pytest", "click", "dask", "distributed", "fluent", "hypothesis", "msgspec",
    "PIL", "pymunk", "starlette", "tornado", "uvicorn", "websockets",
)  # fmt: skip


def pytest_configure(config):
    # The tests start more than a thousand processes. Where PYTHONDONTWRITEBYTECODE is set, each
    # would compile everything that it imports, which takes longer than most of these tests.
    if os.environ.get("PYTHONDONTWRITEBYTECODE") and not hasattr(config, "workerinput"):
        found = [spec for name in LOADED if (spec := find_spec(name))]
        folders = [folder for spec in found for folder in spec.submodule_search_locations]
        # Some packages bring files of another version of Python, which can't be compiled.
        command = [sys.executable, "-m", "compileall", "-q", "-q", "-j", "0", *folders]
        subprocess.run(command, check=False)


def pytest_xdist_auto_num_workers(config):
    """One worker per core and one more; none for a single file or test, which starts at once.

    The module ``cores`` says when the one more runs.
    """
    if config.args != config.getini("testpaths"):
        return 0
    return (os.cpu_count() or 1) + 1


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


#: Letters or bytes of a value in the name of a test.
LONGEST_NAME = 60


def pytest_make_parametrize_id(val, argname):
    """Name a long value by its parameter: a name is sent for each test, and a zip has its time."""
    return argname if isinstance(val, str | bytes) and len(val) > LONGEST_NAME else None


def pytest_collection_finish():
    # As a server does too: otherwise each collection of garbage, as after a run, looks at all tests
    # that there are, which takes a third of a second and holds up every thread.
    gc.freeze()


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
