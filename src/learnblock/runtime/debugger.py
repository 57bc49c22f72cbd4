"""Pause, step and breakpoints: pauses a program at a line, and its world with it."""

import threading
from collections.abc import Collection
from typing import Literal, Protocol

from learnblock.runtime.messages import Control, Mode
from learnblock.runtime.status import State, Status

#: Why a program is held before a line.
HeldBy = Literal["breakpoint", "step", "pause"]


class Holdable(Protocol):
    """Paused together with a program: the pacing of its world, or the brake of a real robot."""

    def pause(self) -> None: ...

    def resume(self) -> None: ...


class Debugger:
    """Stops a program at breakpoints and on request; its methods may be called from any thread.

    `resume`, `step` and `step_over` apply to a paused program, and do nothing
    otherwise. The program itself looks for its breakpoints (see `learnblock.runtime.gate`); here
    they are set, and here the host waits.

    Args:
        breakpoints: lines of the program's Python.
        paused: pause it at its first line.
    """

    def __init__(self, breakpoints: Collection[int] = (), *, paused: bool = False) -> None:
        #: The settings for the program; replaced with every change.
        self.control = Control(frozenset(breakpoints), Mode.STEP if paused else Mode.RUN)
        self._commands = threading.Condition()
        self._held = self._paused = self._ended = False
        self._depth = 0
        self._status: Status | None = None
        self._governed: Holdable | None = None

    def report_to(self, status: Status) -> None:
        """Report to `status` when the world is paused and resumed."""
        with self._commands:
            self._status = status
            self._report_pause()

    def govern(self, governed: Holdable) -> None:
        """Also pause this, now that the program has created its robot."""
        with self._commands:
            self._governed = governed
            if self._paused:
                governed.pause()

    def holds(self, line: int, depth: int) -> bool:
        """Whether the program pauses at `line`, which it has reached; if so, call `wait`."""
        with self._commands:
            # The breakpoints may have changed since the program stopped.
            self._held = not self._ended and self.control.holds(line, depth)
            self._depth = depth
            if self._held and self._governed:
                self._governed.pause()
            return self._held

    def held_by(self, line: int) -> HeldBy:
        """Why the program is held before `line`."""
        with self._commands:
            if line in self.control.breakpoints:
                return "breakpoint"
            is_stepping = self.control.mode is not Mode.RUN and not self._paused
            return "step" if is_stepping else "pause"

    def wait(self) -> None:
        """Return when the program may continue."""
        with self._commands:
            self._commands.wait_for(lambda: not self._held or self._ended)
            self._held = False

    def set_breakpoints(self, lines: Collection[int]) -> None:
        """Replace the breakpoints: the program pauses only before these lines."""
        with self._commands:
            self.control = Control(frozenset(lines), self.control.mode, self.control.depth)

    def pause(self) -> None:
        """Pause the world at once, and the program at its next line."""
        with self._commands:
            self._paused = True
            self.control = Control(self.control.breakpoints, Mode.STEP)
            if self._governed:
                self._governed.pause()
            self._report_pause()

    def resume(self) -> None:
        """Continue to the next breakpoint."""
        self._continue(Mode.RUN)

    def step(self) -> None:
        """Run to the next line, stepping into functions."""
        self._continue(Mode.STEP)

    def step_over(self) -> None:
        """Run to the next line of the same function, or of one of its callers."""
        # A program that has not paused yet has no line to step over.
        self._continue(Mode.STEP_OVER if self._held else Mode.STEP)

    def end(self) -> None:
        """Never pause the program again: it is being stopped."""
        with self._commands:
            self._ended = True
            self._commands.notify_all()

    def _continue(self, mode: Mode) -> None:
        with self._commands:
            if not self._held and self.control.mode is Mode.RUN:
                return
            self.control = Control(self.control.breakpoints, mode, self._depth)
            self._held = self._paused = False
            if self._governed:
                self._governed.resume()
            self._report_pause()
            self._commands.notify_all()

    def _report_pause(self) -> None:
        if self._status:
            change = self._status.enter if self._paused else self._status.leave
            change(State.PAUSED)
