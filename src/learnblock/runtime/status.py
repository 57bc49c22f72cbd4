"""The state of a run."""

import threading
from collections.abc import Callable
from enum import StrEnum


class State(StrEnum):
    """The state of a run; if several apply, the first one is used."""

    ENDED = "ended"
    #: The program has paused before a line.
    HELD = "held"
    #: The program is waiting for a line of input.
    INPUT = "input"
    #: The world is paused.
    PAUSED = "paused"
    RUNNING = "running"
    STARTING = "starting"


class Status:
    """The state of one run; every change is reported, in order, from any thread.

    Args:
        report: called with the new state; it must not wait for another thread of the run.
    """

    def __init__(self, report: Callable[[State], object]) -> None:
        self._report = report
        self._holding: set[State] = set()
        self._reported: State | None = None
        # Reentrant: the receiver of a report may pause the run at once.
        self._changing = threading.RLock()

    def enter(self, state: State) -> None:
        """Add a state."""
        with self._changing:
            self._holding.add(state)
            self._report_change()

    def leave(self, state: State) -> None:
        """Remove a state."""
        with self._changing:
            self._holding.discard(state)
            self._report_change()

    def _report_change(self) -> None:
        now = next((state for state in State if state in self._holding), None)
        if now is not None and now is not self._reported:
            self._reported = now
            self._report(now)
