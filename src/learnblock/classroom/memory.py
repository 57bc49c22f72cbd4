"""The memory of all programs of a pupil: each has a limit of its own, and all together have one."""

import os
import signal
import threading
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

#: Seconds between two looks.
_PERIOD = 0.5
_PROC = Path("/proc")


def watch_programs(most: int) -> None:
    """End the largest program whenever those of this process have too much memory together.

    Only Linux tells; elsewhere the limit of each program has to do.

    Args:
        most: the memory of all together, in bytes.
    """
    if (_PROC / "self" / "task").is_dir():
        threading.Thread(target=_watch, args=(most,), name="memory", daemon=True).start()


def _watch(most: int) -> None:
    pause = threading.Event()
    while True:
        end_largest(most)
        pause.wait(_PERIOD)


def end_largest(most: int) -> int | None:
    """End the largest child of this process if all have too much memory; return its number."""
    sizes = dict(_sizes())
    if sum(sizes.values()) <= most:
        return None
    largest = max(sizes, key=sizes.__getitem__)
    with suppress(ProcessLookupError):
        os.kill(largest, signal.SIGKILL)
    return largest


def _sizes() -> Iterator[tuple[int, int]]:
    """The children of this process, each with the bytes that it has for itself."""
    for child in _children():
        # It may have ended meanwhile.
        with suppress(OSError, IndexError):
            pages = (_PROC / str(child) / "statm").read_text().split()
            yield child, (int(pages[1]) - int(pages[2])) * os.sysconf("SC_PAGE_SIZE")


def _children() -> Iterator[int]:
    for task in (_PROC / "self" / "task").iterdir():
        with suppress(OSError):
            yield from map(int, (task / "children").read_text().split())
