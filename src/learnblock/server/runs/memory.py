"""Returns the memory of runs that have ended to the system."""

import ctypes
import gc
import sys
import threading
from collections.abc import Callable
from time import monotonic

#: Seconds before the first attempt to free a run, and the longest that attempts continue: the event
#: loop and those who look at its world usually let go of it within 0.2 s.
_LETTING_GO, _LONGEST = 0.2, 10.0
#: The parameter of glibc's `mallopt` that limits the number of heaps.
_ARENA_MAX = -8


def share_one_heap() -> None:
    """Have all threads use one heap; called at the start of a server, before it has threads.

    By default glibc makes up to eight for each processor, and can't return the unused end of any
    but the first. With a camera's pictures that is some 40 MB.
    """
    if mallopt := _glibc("mallopt"):
        mallopt(_ARENA_MAX, 1)


def give_back_memory(is_freed: Callable[[], bool], longest: float = _LONGEST) -> None:
    """Return the memory of a run to the system once nothing uses it any more.

    Robot, world, recorder and host of a run refer to each other, and are some 30 MB with a camera.
    They are few objects, so that Python would not look for such garbage before the end of a lesson.
    The threads of a run also leave holes in the heap, which glibc keeps.

    Args:
        is_freed: whether the run is gone.
        longest: the longest that others may keep using it, in s; then it stays.
    """
    pause, seconds, ends = threading.Event(), _LETTING_GO, monotonic() + longest
    while not is_freed() and monotonic() < ends:
        pause.wait(seconds)
        gc.collect()
        # An attempt holds up the other threads, so a run that hangs gets few attempts.
        seconds *= 2
    # The run may be gone already, but not the world that it has replaced.
    gc.collect()
    if malloc_trim := _glibc("malloc_trim"):
        malloc_trim(0)


def _glibc(name: str) -> Callable[..., int] | None:
    """A function of glibc; another C library, such as musl, returns memory by itself."""
    return getattr(ctypes.CDLL(None), name, None) if sys.platform == "linux" else None
