"""Measures a class that is open; the helpers of the tests must be on the path."""

import asyncio
import os
import platform
import sys
import tempfile
from collections.abc import Awaitable, Callable
from pathlib import Path

from classes import Class, Joined, opened

Measure = Callable[[Class, list[Joined], float], Awaitable[None]]


def in_a_class(measure: Measure, pupils: int) -> None:
    """Measure a class with as many pupils, and for as many seconds, as the command line says.

    Args:
        measure: called with the class, its pupils and the seconds.
        pupils: how many there are by default; the seconds are 20.
    """
    count = int(sys.argv[1]) if len(sys.argv) > 1 else pupils
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 20.0
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors, {count} pupils")
    with tempfile.TemporaryDirectory() as home, opened(Path(home, "teacher")) as room:
        joined = [room.pupil(f"Pupil {number}") for number in range(1, count + 1)]
        asyncio.run(measure(room, joined, seconds))
