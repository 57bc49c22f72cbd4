"""Pause, step and breakpoints: what holds a program at a line."""

import threading
from collections.abc import Callable, Collection
from dataclasses import dataclass
from enum import Enum, auto

from learnblock.runtime.messages import Variables


class Mode(Enum):
    """What a debugger waits for."""

    RUN = auto()
    STEP = auto()
    STEP_OVER = auto()


@dataclass(frozen=True, slots=True)
class Held:
    """A program held at a line of its Python."""

    line: int
    variables: Variables


class Debugger:
    """Holds a program at breakpoints and when paused; its methods may be called from any thread.

    `resume`, `step` and `step_over` speak to a program that is held, and change nothing otherwise.

    Args:
        breakpoints: lines of the program's Python.
        paused: hold it at its first line.
        on_held: is told, in the host's thread, whenever the program is held, and with None when it
            goes on; by default nobody is.
    """

    def __init__(
        self,
        breakpoints: Collection[int] = (),
        *,
        paused: bool = False,
        on_held: Callable[[Held | None], object] = bool,
    ) -> None:
        self.breakpoints = frozenset(breakpoints)
        self._on_held = on_held
        self._mode = Mode.STEP if paused else Mode.RUN
        self._depth = 0
        self._ended = False
        self._commands = threading.Condition()
        self._held = False

    def reached(self, line: int, depth: int, variables: Callable[[], Variables]) -> None:
        """Return when the program may run the line it has reached."""
        if not self._holds(line, depth):
            return
        held = Held(line, variables())
        self._depth, self._held = depth, True
        self._on_held(held)
        with self._commands:
            self._commands.wait_for(lambda: not self._held or self._ended)
            self._held = False
        self._on_held(None)

    def pause(self) -> None:
        """Hold the program at its next line."""
        with self._commands:
            self._mode = Mode.STEP

    def resume(self) -> None:
        self._give(Mode.RUN)

    def step(self) -> None:
        """Run to the next line, into functions."""
        self._give(Mode.STEP)

    def step_over(self) -> None:
        """Run to the next line of the same function, or of one that called it."""
        self._give(Mode.STEP_OVER)

    def end(self) -> None:
        """Never hold the program again: it is being stopped."""
        with self._commands:
            self._ended = True
            self._commands.notify_all()

    def _holds(self, line: int, depth: int) -> bool:
        if self._ended:
            return False
        return (
            line in self.breakpoints
            or self._mode is Mode.STEP
            or (self._mode is Mode.STEP_OVER and depth <= self._depth)
        )

    def _give(self, command: Mode) -> None:
        with self._commands:
            if self._held:
                self._mode, self._held = command, False
                self._commands.notify_all()
