"""How many tests run at once: one per core, and one more where none of them needs real time.

Many tests wait, for a process that starts or a page that answers, so one worker more than there are
cores fills the pauses. A robot's wire and a browser, though, need their core when they ask for it.
"""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from filelock import FileLock, ReadWriteLock

from gate import FOLDERS, folder_of

CORES = pytest.StashKey["Cores"]()


class Cores:
    """The cores as a worker sees them: locks in a folder that all workers share."""

    def __init__(self, folder: Path, *, worker: int, cores: int):
        self._is_extra = worker >= cores
        # The extra worker has no core of its own, and shares the first one's.
        self._core = FileLock(folder / f"core-{worker % cores}.lock", poll_interval=0.01)
        # Read by each test that needs real time; written by the test that runs beside all others.
        self._real_time = ReadWriteLock(folder / "real-time.lock", is_singleton=False)

    @contextlib.contextmanager
    def taken(self, *, real_time: bool, seconds: float = -1) -> Iterator[None]:
        """Wait until a test may run, at most so many seconds, and keep its place while it does."""
        with contextlib.ExitStack() as places:
            if real_time or not self._is_extra:
                places.enter_context(self._core.acquire(timeout=seconds))
            if real_time:
                places.enter_context(self._real_time.read_lock(seconds))
            elif self._is_extra:
                places.enter_context(self._real_time.write_lock(seconds))
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
    with cores.taken(real_time=folder_of(item) in FOLDERS):
        return (yield)
