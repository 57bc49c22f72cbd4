"""A test of a wire runs beside no more tests than there are cores; one of a browser may."""

import pytest
from filelock import Timeout

from cores import Cores

CORES = 2


@pytest.fixture
def workers(tmp_path):
    """Return the cores as each of three workers on two cores sees them."""
    return [Cores(tmp_path, worker=number, cores=CORES) for number in range(CORES + 1)]


def begun(worker, folder):
    """Let a worker begin a test, or raise `Timeout` if it has to wait."""
    return worker.taken(folder, seconds=0)


def has_to_wait(worker, folder):
    try:
        with begun(worker, folder):
            return False
    except Timeout:
        return True


@pytest.mark.parametrize("folder", ["unit", "browser"])
def test_tests_of_a_kind_run_on_all_cores_and_one_more(workers, folder):
    first, second, extra = workers
    with begun(first, folder), begun(second, folder):
        assert not has_to_wait(extra, folder)


@pytest.mark.parametrize(
    ("extra_folder", "folder"), [("unit", "wire"), ("browser", "wire"), ("unit", "browser")]
)
def test_no_extra_test_begins_beside_one_that_needs_its_core_more(workers, extra_folder, folder):
    first, second, extra = workers
    with begun(first, folder), begun(second, folder):
        assert has_to_wait(extra, extra_folder)
    assert not has_to_wait(extra, extra_folder)


@pytest.mark.parametrize(
    ("extra_folder", "folder"), [("unit", "wire"), ("browser", "wire"), ("unit", "browser")]
)
def test_one_that_needs_its_core_more_waits_for_the_end_of_an_extra_one(
    workers, extra_folder, folder
):
    first, _, extra = workers
    with begun(extra, extra_folder):
        assert has_to_wait(first, folder)
    assert not has_to_wait(first, folder)


def test_the_extra_worker_takes_the_core_of_the_first_for_a_wire(workers):
    first, second, extra = workers
    with begun(extra, "wire"), begun(second, "wire"):
        assert has_to_wait(first, "unit")
