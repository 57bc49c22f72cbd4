"""The memory that a run leaves behind."""

import ctypes
import sys


def give_back() -> None:
    """Return unused memory to the system.

    The threads of a run leave holes in the heap, which glibc keeps: some 20 kB more after each run.
    """
    if sys.platform != "linux":
        return
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    # Another C library, such as musl, returns it by itself.
    if trim is not None:
        trim(0)
