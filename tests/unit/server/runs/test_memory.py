"""The memory that a run leaves behind."""

import subprocess
import sys
import weakref
from itertools import count

import pytest

from learnblock.server.runs.memory import give_back_memory

#: The programs have processes of their own: otherwise the heaps of earlier tests and their threads
#: decide where memory comes from.
BEGINNING = """
import os
import threading
from pathlib import Path

from learnblock.server.runs.memory import give_back_memory, share_one_heap


def resident():
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


"""
HOLES = f"""{BEGINNING}
# Smaller ones than glibc would map on their own, with a last one that keeps the heap long.
blocks = [bytearray(100_000) for _ in range(500)]
last = blocks.pop()
blocks.clear()
before = resident()
give_back_memory(lambda: True)
print(before, resident(), len(last))
"""
SERVER = f"""{BEGINNING}
def look():
    # Pictures, of which glibc learns that such blocks come and go.
    large = bytearray(25_000_000)
    del large
    pictures = [bytearray(1_000_000) for _ in range(40)]
    pictures.clear()


share_one_heap()
before = resident()
thread = threading.Thread(target=look)
thread.start()
thread.join()
give_back_memory(lambda: True)
print(before, resident())
"""


def printed_by(program):
    """Return the numbers that a program prints in a process of its own."""
    child = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    return tuple(map(int, child.stdout.split()))


on_glibc = pytest.mark.skipif(sys.platform != "linux", reason="only glibc keeps it")


@on_glibc
def test_holes_in_the_heap_are_given_back():
    before, after, length = printed_by(HOLES)
    assert after < before - 20_000_000
    assert length == 100_000


@on_glibc
def test_what_threads_have_used_is_given_back():
    before, after = printed_by(SERVER)
    assert after < before + 10_000_000


class Circle:
    """It refers to itself, as the parts of a run refer to each other."""

    def __init__(self):
        self.itself = self


def test_what_is_used_a_moment_longer_is_given_back_after_that():
    users, looks = [Circle()], count()
    used = weakref.ref(users[0])

    def is_freed():
        if next(looks) == 2:
            users.clear()
        return used() is None

    give_back_memory(is_freed)
    assert used() is None


def test_what_stays_in_use_is_waited_for_no_longer_than_allowed():
    user = Circle()
    used = weakref.ref(user)
    give_back_memory(lambda: used() is None, longest=0.0)
    assert used() is user
