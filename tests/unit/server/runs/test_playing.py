"""The memory that a run leaves behind."""

import os
import sys
from pathlib import Path

import pytest

from learnblock.server.runs.playing import give_back_memory


def resident():
    """Bytes of this process that are in memory."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(sys.platform != "linux", reason="only glibc keeps it")
def test_holes_in_the_heap_are_given_back():
    # Smaller ones than glibc would map on their own, with a last one that keeps the heap long.
    blocks = [bytearray(100_000) for _ in range(500)]
    last = blocks.pop()
    blocks.clear()
    before = resident()
    give_back_memory()
    assert resident() < before - 20_000_000
    assert len(last) == 100_000
