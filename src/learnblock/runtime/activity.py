"""What a program does between its calls: it computes, or it waits."""

import os
import sys
import time
from collections.abc import Callable
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


class Allowance:
    """Seconds that a process may take, which pass while it computes or waits.

    They do not pass while a busy machine keeps it from a processor, so what becomes of it does not
    depend on the machine. Where the system does not say what it does, all time passes.

    Args:
        seconds: how long it may compute and wait.
        longest: how long it may take by the wall clock, on however busy a machine.
        activity: says what it does.
        clock: returns the time of the wall clock in seconds.
    """

    def __init__(
        self,
        seconds: float,
        longest: float,
        activity: Callable[[], Activity | None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._seconds = seconds
        self._activity = activity
        self._clock = clock
        self._silence = Silence()
        self._silence.begin(activity())
        self._looked = clock()
        self._end = self._looked + longest

    def look(self) -> None:
        """Look again at what it does; to be called several times in `LONGEST_LOOK`."""
        before, self._looked = self._looked, self._clock()
        self._silence.look(self._looked - before, self._activity())

    @property
    def is_spent(self) -> bool:
        """Whether it has taken more than its seconds."""
        return self._silence.computing + self._silence.waiting > self._seconds

    @property
    def is_over(self) -> bool:
        """Whether not to wait for it any longer: it is spent, or the machine is too busy."""
        return self.is_spent or self._looked > self._end


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
