"""A short run of the fuzzer; `tests/helpers/fuzz.py` runs for any time."""

import pytest

from fuzz import fuzz

pytestmark = pytest.mark.slow


def test_hostile_files_give_our_own_errors_and_nothing_else():
    counts, failures = fuzz(seed=1, seconds=float("inf"), most=2500)
    assert failures == []
    assert counts.total() >= 2500
