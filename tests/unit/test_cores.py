"""A test that needs real time runs beside no more tests than there are cores."""

import pytest
from filelock import Timeout

from cores import Cores

CORES = 2


@pytest.fixture
def workers(tmp_path):
    """Return the cores as each of three workers on two cores sees them."""
    return [Cores(tmp_path, worker=number, cores=CORES) for number in range(CORES + 1)]


def begun(worker, *, real_time):
    """Let a worker begin a test, or raise `Timeout` if it has to wait."""
    return worker.taken(real_time=real_time, seconds=0)


def has_to_wait(worker, *, real_time):
    try:
        with begun(worker, real_time=real_time):
            return False
    except Timeout:
        return True


def test_plain_tests_run_on_all_cores_and_one_more(workers):
    first, second, extra = workers
    with begun(first, real_time=False), begun(second, real_time=False):
        assert not has_to_wait(extra, real_time=False)


def test_no_extra_test_begins_beside_one_that_needs_real_time(workers):
    first, second, extra = workers
    with begun(first, real_time=True), begun(second, real_time=True):
        assert has_to_wait(extra, real_time=False)
    assert not has_to_wait(extra, real_time=False)


def test_one_that_needs_real_time_waits_for_the_end_of_an_extra_one(workers):
    first, _, extra = workers
    with begun(extra, real_time=False):
        assert has_to_wait(first, real_time=True)
    assert not has_to_wait(first, real_time=True)


def test_the_extra_worker_takes_the_core_of_the_first_for_one_that_needs_real_time(workers):
    first, second, extra = workers
    with begun(extra, real_time=True), begun(second, real_time=True):
        assert has_to_wait(first, real_time=False)
