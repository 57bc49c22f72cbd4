"""What a run is doing, in one word, for those who watch it."""

import threading
from collections.abc import Callable
from enum import StrEnum


class State(StrEnum):
    """What a run is doing; of several that hold at once the first one is told."""

    ENDED = "ended"
    #: The program is held before a line.
    HELD = "held"
    #: The program waits for a line of input.
    INPUT = "input"
    #: The world stands still.
    PAUSED = "paused"
    RUNNING = "running"
    STARTING = "starting"


class Status:
    """The state of one run, told whenever it changes, in order, whichever thread changes it.

    Args:
        tell: is called with the new state; it must not wait for another thread of the run.
    """

    def __init__(self, tell: Callable[[State], object]) -> None:
        self._tell = tell
        self._holding: set[State] = set()
        self._told: State | None = None
        # Reentrant: who is told may pause the run at once.
        self._changing = threading.RLock()

    def enter(self, state: State) -> None:
        """From now on `state` holds."""
        with self._changing:
            self._holding.add(state)
            self._tell_change()

    def leave(self, state: State) -> None:
        """From now on `state` does not hold."""
        with self._changing:
            self._holding.discard(state)
            self._tell_change()

    def _tell_change(self) -> None:
        now = next((state for state in State if state in self._holding), None)
        if now is not None and now is not self._told:
            self._told = now
            self._tell(now)
