"""All programs of a pupil together have a limit of memory."""

import signal
import subprocess
import sys
from contextlib import contextmanager

import pytest

from learnblock.classroom.memory import end_largest

MEGABYTE = 1024 * 1024
LINUX = sys.platform == "linux"
pytestmark = [pytest.mark.realtime, pytest.mark.skipif(not LINUX, reason="only Linux tells")]

PROGRAM = """
import sys
kept = bytearray({size})
kept[::4096] = b"x" * len(kept[::4096])
print(flush=True)
sys.stdin.read()
"""


@contextmanager
def program(size):
    """A child that keeps so much memory."""
    command = [sys.executable, "-c", PROGRAM.format(size=size)]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        process.stdout.readline()
        yield process


def test_the_largest_program_ends_when_all_have_too_much():
    with program(20 * MEGABYTE) as small, program(80 * MEGABYTE) as large:
        assert end_largest(1000 * MEGABYTE) is None
        assert end_largest(90 * MEGABYTE) == large.pid
        assert large.wait() == -signal.SIGKILL
        assert small.poll() is None
