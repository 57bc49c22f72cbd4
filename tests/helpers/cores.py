"""How many tests run at once: one per core, and one more where none of them drives a robot's wire.

Many tests wait, for a process that starts or a page that answers, so one worker more than there are
cores fills the pauses. A robot's wire, though, needs its core when it asks for it, and a browser
needs at least that nothing computes beside it without a pause.
"""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from filelock import FileLock, ReadWriteLock

from gate import folder_of

CORES = pytest.StashKey["Cores"]()


class Cores:
    """The cores as a worker sees them: locks in a folder that all workers share."""

    def __init__(self, folder: Path, *, worker: int, cores: int):
        self._is_extra = worker >= cores
        # The extra worker has no core of its own, and shares the first one's.
        self._core = FileLock(folder / f"core-{worker % cores}.lock", poll_interval=0.01)
        # Read by each test of a kind; written by a test without a core that may not run beside it.
        self._wires, self._browsers = (
            ReadWriteLock(folder / f"{kind}.lock", is_singleton=False)
            for kind in ("wire", "browser")
        )

    @contextlib.contextmanager
    def taken(self, folder: str, seconds: float = -1) -> Iterator[None]:
        """Wait until a test of a folder may run, at most so many seconds, and keep its place."""
        is_wire, is_browser = folder == "wire", folder == "browser"
        has_core = is_wire or not self._is_extra
        with contextlib.ExitStack() as places:
            if has_core:
                places.enter_context(self._core.acquire(timeout=seconds))
            if is_wire:
                places.enter_context(self._wires.read_lock(seconds))
            if is_browser:
                places.enter_context(self._browsers.read_lock(seconds))
            if not has_core:
                places.enter_context(self._wires.write_lock(seconds))
            if not (has_core or is_browser):
                places.enter_context(self._browsers.write_lock(seconds))
            yield


def pytest_configure(config):
    if worker := os.environ.get("PYTEST_XDIST_WORKER"):
        folder = Path(config.workerinput["cores"])
        number = int(worker.removeprefix("gw"))
        config.stash[CORES] = Cores(folder, worker=number, cores=os.cpu_count() or 1)


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node):
    """Tell a worker where the locks of this run are."""
    # No fixture exists this early.
    node.workerinput["cores"] = str(node.config._tmp_path_factory.getbasetemp())


# Outside the limit of time of a test, which does not begin before it may run.
@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_protocol(item):
    cores = item.config.stash.get(CORES, None)
    if cores is None:
        return (yield)
    with cores.taken(folder_of(item)):
        return (yield)
