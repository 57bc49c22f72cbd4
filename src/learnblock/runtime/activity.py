"""What a program does between its calls: it computes, or it waits."""

import os
import sys
import time
from typing import NamedTuple

_TICKS = os.sysconf("SC_CLK_TCK") if sys.platform == "linux" else 1
#: Seconds that count at most between two looks: the host itself may have been kept from looking.
LONGEST_LOOK = 0.1


class Activity(NamedTuple):
    """What a program has done so far.

    Args:
        processor: seconds of processor time that it has used.
        waits: whether it waits now, for something other than a processor or its own memory.
    """

    processor: float
    waits: bool


class Silence:
    """The time since a program's last call, as it spent it.

    A busy machine lets a program wait for a processor: that counts as neither.
    """

    def __init__(self) -> None:
        #: Seconds of processor time since the last call.
        self.computing = 0.0
        #: Seconds that it has waited for anything but its robot.
        self.waiting = 0.0
        self._before: Activity | None = None

    def begin(self, activity: Activity | None) -> None:
        """The program has made a call."""
        self.computing = self.waiting = 0.0
        self._before = activity

    def look(self, seconds: float, activity: Activity | None, handling: float = 0.0) -> None:
        """Look again after some seconds of the wall clock, without a call in between.

        Args:
            seconds: since the last look.
            activity: what the program does; None on a system that does not say, where all time
                counts as computing.
            handling: seconds of processor time that its host has spent on its messages, which
                count as if the program had computed: it may send more than it computes.
        """
        passed = min(seconds, LONGEST_LOOK)
        if activity is None or self._before is None:
            self.computing += passed if activity is None else 0.0
        else:
            self.computing += handling
            if activity.processor > self._before.processor:
                self.computing += activity.processor - self._before.processor
            elif activity.waits:
                self.waiting += passed
        self._before = activity


def of_process(process: int) -> Activity | None:
    """What a process has done; None if the system does not say, or if it has ended."""
    try:
        with open(f"/proc/{process}/stat", "rb") as file:  # noqa: PTH123 - as fast as can be
            # The name before it, in brackets, may contain anything.
            state, *numbers = file.read().rpartition(b")")[2].split()
    except OSError:
        return None
    return Activity((int(numbers[10]) + int(numbers[11])) / _TICKS, state not in (b"R", b"D"))


def of_thread(thread: int) -> Activity | None:
    """What a thread of this process has done; None if the system does not say.

    Whether it waits is not known: only its processor time counts.
    """
    if not hasattr(time, "pthread_getcpuclockid"):
        return None
    return Activity(time.clock_gettime(time.pthread_getcpuclockid(thread)), waits=False)
