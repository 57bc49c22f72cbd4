"""The two tiers of the tests: the gate, and everything.

The gate is what ``pytest`` runs without arguments: all unit tests, and of those that need a browser
or the other end of a robot's wire the ones in ``tests/smoke.txt``. Of a test with the marker
``sample(n)`` it runs n of the cases, evenly spread, one with the marker ``exhaustive`` it leaves to
``--all``, and Hypothesis tries the same examples each time, so that a red gate is the fault of the
change. With ``--all`` everything runs, with new examples; of a file or folder that is named, all
tests run too.
"""

from collections import defaultdict
from functools import cache
from pathlib import Path

import pytest
from hypothesis import settings

TESTS = Path(__file__).parents[1]
#: One test for each promise that no unit test can keep.
LIST = TESTS / "smoke.txt"
#: The folders of which the gate runs only the listed tests.
FOLDERS = ("browser", "wire")
IS_GATE = pytest.StashKey[bool]()


def examples(everything, gate):
    """Return how many examples Hypothesis tries of a test, with ``--all`` and in the gate.

    The gate's are the same each time: those that found nothing yesterday find nothing today.
    """
    return gate if in_gate() else everything


def in_gate():
    """Return whether the gate runs."""
    return settings.default.derandomize


def pytest_addoption(parser):
    parser.addoption("--all", action="store_true", help="run everything, not only the gate")


def pytest_configure(config):
    config.stash[IS_GATE] = _is_gate(config)
    if config.stash[IS_GATE]:
        settings.register_profile("gate", deadline=None, derandomize=True)
        settings.load_profile("gate")


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


def pytest_ignore_collect(collection_path, config):
    """Leave out the files of browser and wire of which the gate runs no test."""
    is_test = collection_path.match("test_*.py") and collection_path.is_relative_to(TESTS)
    if not (config.stash[IS_GATE] and is_test):
        return None
    path = collection_path.relative_to(TESTS)
    is_left_out = path.parts[0] in FOLDERS and path.as_posix() not in _listed_files()
    return True if is_left_out else None


@cache
def _listed_files():
    return {name.partition("::")[0] for name in listed()}


# First: pytest-xdist adds the group of a test to its name.
@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    if not config.stash[IS_GATE]:
        return
    if missing := _listed_in(config.args) - {name_of(item) for item in items}:
        _report(f"{LIST} lists tests that do not exist: {sorted(missing)}", config)
    selection = set(_smoke(items)) & set(_samples(items)) - set(_exhaustive(items))
    config.hook.pytest_deselected(items=[item for item in items if item not in selection])
    items[:] = [item for item in items if item in selection]


def _listed_in(folders):
    """Return the names of the listed tests in these folders: `testpaths` may be changed."""
    paths = [Path(folder).absolute() for folder in folders]
    return {
        name
        for name in listed()
        if any((TESTS / name.partition("::")[0]).is_relative_to(folder) for folder in paths)
    }


def _report(error, config):
    """Report an error as one of collecting: a worker that raised it would end without a word."""
    config.hook.pytest_collectreport(
        report=pytest.CollectReport(str(LIST), "failed", longrepr=error, result=[])
    )


def _smoke(items):
    """Return the unit tests and the listed ones of the other folders."""
    names = listed()
    return [item for item in items if folder_of(item) not in FOLDERS or name_of(item) in names]


def _exhaustive(items):
    return [item for item in items if item.get_closest_marker("exhaustive")]


def _samples(items):
    """Return the items without those that are left out of a sample."""
    cases = defaultdict(list)
    for item in items:
        cases[name_of(item).partition("[")[0]].append(item)
    return [item for of_one in cases.values() for item in _sample(of_one)]


def _sample(cases):
    """Return as many cases of a test as its marker says, from the first to the last."""
    marker = cases[0].get_closest_marker("sample")
    most = marker.args[0] if marker else len(cases)
    step = max(1, len(cases) / most)
    return [cases[int(number * step)] for number in range(min(most, len(cases)))]


def listed():
    """Return the names of the tests that the gate runs of browser and wire."""
    lines = LIST.read_text(encoding="utf-8").splitlines()
    return {line for line in lines if line and not line.startswith("#")}


def name_of(item):
    """Return the name of a test, such as ``browser/test_x.py::test_y[z]``."""
    return item.nodeid.removeprefix("tests/")


def folder_of(item):
    return name_of(item).split("/")[0]
