"""Ending something that may not want to end: measures, each stronger than the one before.

Every wait for an end has a deadline, and something that is done when it has passed: ask, then kill,
then give up and say so.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Measure:
    """One attempt to end something.

    Args:
        take: takes the measure; returns at once.
        seconds: how long the end may then take.
    """

    take: Callable[[], object]
    seconds: float


@dataclass(frozen=True, slots=True)
class EndTimeouts:
    """How long the end of a run may take, in seconds.

    Args:
        stopped: after it was asked to stop; a program may spend `dismissal.GRACE` of that.
        killed: after its program was killed.
    """

    stopped: float = 1.0
    killed: float = 0.8

    def measures(
        self, stop: Callable[[], object], kill: Callable[[], object]
    ) -> tuple[Measure, ...]:
        """The measures that end a run: stop it, then kill its program."""
        return Measure(stop, self.stopped), Measure(kill, self.killed)


PATIENCE = EndTimeouts()


def escalate(measures: Iterable[Measure], wait: Callable[[float], bool]) -> bool:
    """Take measures until something has ended; return whether it has.

    Args:
        measures: the measures, the weakest first.
        wait: waits at most so many seconds for the end; returns whether it has come.
    """
    for measure in measures:
        measure.take()
        if wait(measure.seconds):
            return True
    return False
