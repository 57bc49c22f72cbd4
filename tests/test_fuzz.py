"""A short run of the fuzzer; `tests/fuzz.py` runs for as long as one likes."""

from fuzz import fuzz


def test_hostile_files_give_our_own_errors_and_nothing_else():
    counts, failures = fuzz(seed=1, seconds=60, most=2500)
    assert failures == []
    assert counts.total() >= 2500
