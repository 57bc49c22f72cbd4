"""The two tiers of the tests: the gate, and everything.

The gate is what ``pytest`` runs without arguments: all unit tests, and of those that need a browser
or the other end of a robot's wire the ones in ``tests/smoke.txt``. With ``--all`` everything runs;
of a file or folder that is named, all tests run too.
"""

from pathlib import Path

import pytest

TESTS = Path(__file__).parents[1]
#: One test for each promise that no unit test can keep.
LIST = TESTS / "smoke.txt"
#: The folders of which the gate runs only the listed tests.
FOLDERS = ("browser", "wire")
IS_GATE = pytest.StashKey[bool]()


def pytest_addoption(parser):
    parser.addoption("--all", action="store_true", help="run everything, not only the gate")


def pytest_configure(config):
    config.stash[IS_GATE] = _is_gate(config)


def _is_gate(config):
    if hasattr(config, "workerinput"):
        return config.workerinput["gate"]
    return config.args_source is config.ArgsSource.TESTPATHS and not config.option.all


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node):
    """Tell a worker, which gets every path as if a user had named it."""
    node.workerinput["gate"] = node.config.stash[IS_GATE]


def pytest_report_header(config):
    if config.stash[IS_GATE]:
        return f"tier: the gate, with {len(listed())} tests of browser and wire (--all: everything)"
    return "tier: everything that was asked for"


def pytest_collection_modifyitems(config, items):
    if not config.stash[IS_GATE]:
        return
    names = listed()
    if missing := names - {name_of(item) for item in items}:
        raise pytest.UsageError(f"{LIST} lists tests that do not exist: {sorted(missing)}")
    left_out = [item for item in items if folder_of(item) in FOLDERS and name_of(item) not in names]
    kept = set(items) - set(left_out)
    items[:] = [item for item in items if item in kept]
    config.hook.pytest_deselected(items=left_out)


def listed():
    """Return the names of the tests that the gate runs of browser and wire."""
    lines = LIST.read_text(encoding="utf-8").splitlines()
    return {line for line in lines if line and not line.startswith("#")}


def name_of(item):
    """Return the name of a test, such as ``browser/test_x.py::test_y[z]``."""
    return item.nodeid.removeprefix("tests/")


def folder_of(item):
    return name_of(item).split("/")[0]
