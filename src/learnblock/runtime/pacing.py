"""The speed of a simulated world relative to the wall clock, controlled from outside the world."""

import threading
import time
from collections.abc import Callable

#: Seconds of the wall clock that a world may lag before it stops catching up.
SLIP = 0.1
#: Shorter waits cost more than they save.
SHORTEST_WAIT = 0.001


# Why: docs/decisions.md, "Pacing is one object outside the world"
class Pacing:
    """Free, real time at a factor, paused, or step by step; it can be changed while the world runs.

    A world that cannot keep up runs slower than requested and never skips a step.

    Args:
        factor: a multiple of real time; None is as fast as possible.
        clock: returns the time of the wall clock in seconds.
    """

    def __init__(
        self, factor: float | None = None, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self.factor = factor
        self._clock = clock
        self._changed = threading.Condition()
        self._paused = False
        self._allowed_steps = 0
        self._ended = False
        self._anchor: tuple[float, float] | None = None
        self._slipped = False

    def wait(self, world_time: float, given_up: threading.Event | None = None) -> None:
        """Return when the world may take the step that begins at `world_time` seconds.

        Args:
            world_time: the world's time.
            given_up: ends the waiting early once it is set and `wake` is called.
        """
        if not self.is_free:
            with self._changed:
                self._wait(world_time, given_up or threading.Event())

    @property
    def is_free(self) -> bool:
        """Whether the world may take its next step at once; a free world asks before every step."""
        return self.factor is None and not self._paused

    def wake(self) -> None:
        """Wake the waiting threads, so that they check whether to stop waiting."""
        with self._changed:
            self._changed.notify_all()

    def pause(self) -> None:
        """Pause the world before its next step."""
        self._change(paused=True)

    def resume(self) -> None:
        self._change(paused=False)

    def step(self, steps: int = 1) -> None:
        """Let a paused world advance by that many steps."""
        with self._changed:
            self._allowed_steps += steps
            self._changed.notify_all()

    def set_factor(self, factor: float | None) -> None:
        """Change the speed from now on."""
        with self._changed:
            self.factor, self._anchor = factor, None
            self._changed.notify_all()

    def end(self) -> None:
        """Never wait again: the run is being stopped."""
        with self._changed:
            self._ended = True
            self._changed.notify_all()

    @property
    def slipped(self) -> bool:
        """Whether the world has ever been too slow for its pace."""
        return self._slipped

    def _change(self, *, paused: bool) -> None:
        with self._changed:
            self._paused, self._allowed_steps, self._anchor = paused, 0, None
            self._changed.notify_all()

    def _wait(self, world_time: float, given_up: threading.Event) -> None:
        while not self._ended and not given_up.is_set():
            if self._paused and self._allowed_steps:
                self._allowed_steps -= 1
                return
            ahead = None if self._paused else self._ahead(world_time)
            if ahead is not None and ahead <= SHORTEST_WAIT:
                return
            # Wait until it is time, or until the pacing changes.
            self._changed.wait(ahead)

    def _ahead(self, world_time: float) -> float:
        """Seconds of the wall clock by which the world is early."""
        if self.factor is None:
            return 0.0
        now = self._clock()
        if self._anchor is None:
            self._anchor = (now, world_time)
        wall, world = self._anchor
        ahead = wall + (world_time - world) / self.factor - now
        if ahead < -SLIP:
            self._anchor, self._slipped = (now, world_time), True
        return ahead
