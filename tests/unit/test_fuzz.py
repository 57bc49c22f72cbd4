"""A short run of the fuzzer; `tests/helpers/fuzz.py` runs for any time."""

import pytest

from fuzz import fuzz
from gate import examples

pytestmark = pytest.mark.slow


def test_hostile_files_give_our_own_errors_and_nothing_else():
    most = examples(2500, gate=1000)
    counts, failures = fuzz(seed=1, seconds=float("inf"), most=most)
    assert failures == []
    assert counts.total() >= most
