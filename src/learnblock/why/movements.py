"""Why the robot moved, or did not."""

from bisect import bisect_right
from math import dist
from typing import Any

from learnblock.why.actions import LONG_AGO, Actions
from learnblock.why.history import EventHistory
from learnblock.why.inquiry import Inquiry
from learnblock.why.run_end import RunEnd
from learnblock.why.whole_run import WholeRun
from learnblock.why.wording import MOVEMENTS, STAND

#: The most lines that an answer names, if the question has no moment.
LINES = 2
#: A robot that has moved less than this, in mm, counts as standing still.
_STILL = 2.0


class Movements:
    """Tells why the robot moved, or did not.

    Args:
        inquiry: the question, and its answer so far.
        run_end: tells how the run ended.
        actions: tells why statements ran.
        whole_run: tells about the run as a whole.
    """

    def __init__(
        self, inquiry: Inquiry, *, run_end: RunEnd, actions: Actions, whole_run: WholeRun
    ) -> None:
        self._history: EventHistory = inquiry.history
        self._position = inquiry.position
        self._commands = inquiry.commands
        self._draft = inquiry.draft
        self._run_end = run_end
        self._actions = actions
        self._whole_run = whole_run

    def why(self, name: str, until: int, time: float | None) -> None:
        """Tell why the robot made a movement."""
        name = name if name in MOVEMENTS else ""
        last_command = self._told_to(name, until, time)
        soon = self._about_to(name, until)
        if last_command >= 0 and not self._is_long_over(name, last_command, time):
            for command in self._by_line(name, last_command, time):
                self._draft.begin_part()
                self._actions.moved(command, self._lasts_until(name, command, until))
        elif soon >= 0:
            self._actions.moved(soon, until)
        elif name == STAND and self._stands(until, time):
            return
        elif last_command >= 0:
            self._draft.say_of_line("why-not-then", 0, until, time=time or 0.0)
            self._actions.moved(self._commands.last(until), until)
        else:
            self._actions.not_happened(until, time)
            self._actions.not_moved(name, until, time)

    def _told_to(self, name: str, until: int, time: float | None) -> int:
        """The last command of a movement up to an event; -1 if there was none.

        The command in force at that moment counts rather than one right after it.
        """
        exact = self._commands.last(until if time is None else self._history.at(time))
        if exact >= 0 and name in self._commands.names(exact):
            return exact
        commands = self._commands.all
        before = reversed(commands[: bisect_right(commands, until)])
        first = self._commands.last(self._actions.first) if self._actions.first else 0
        return next(
            (
                command
                for command in before
                if name in self._commands.names(command) and command >= first
            ),
            -1,
        )

    def _by_line(self, name: str, last: int, time: float | None) -> list[int]:
        """The last commands of a movement by each line that gave some, the last one first.

        A question about a moment is about one command.
        """
        if self._actions.is_moment(time):
            return [last]
        last_by_line: dict[int, int] = {}
        first = self._commands.last(self._actions.first)
        for command in reversed(self._commands.all[: bisect_right(self._commands.all, last)]):
            is_other = name == self._commands.movement(command) and command >= first
            if is_other or command == last:
                use = self._history.own_use(command)
                last_by_line.setdefault(self._position.call_of(use) if use else -1, command)
        return [*last_by_line.values()][:LINES]

    def _lasts_until(self, name: str, command: int, until: int) -> int:
        """The last event up to another one at which a movement is still in force."""
        commands = self._commands.all
        later = commands[bisect_right(commands, command) : bisect_right(commands, until)]
        other = next(
            (index for index in later if name not in self._commands.names(index)), until + 1
        )
        return max(command, other - 1)

    def _about_to(self, name: str, until: int) -> int:
        """The first command of a movement by the skill that lasts at an event; -1 if none."""
        commands, use = self._commands.all, self._position.running(until)
        later = commands[bisect_right(commands, until) :] if use else []
        own = (command for command in later if self._history.own_use(command) is use)
        return next((command for command in own if name in self._commands.names(command)), -1)

    def _is_long_over(self, name: str, command: int, time: float | None) -> bool:
        """Whether another movement has replaced one long before a moment."""
        if time is None or not self._actions.is_moment(time):
            return False
        commands = self._commands.all
        later = commands[bisect_right(commands, command) :]
        end = next((index for index in later if name not in self._commands.names(index)), -1)
        return end >= 0 and time - self._history.time(end) > LONG_AGO

    def _stands(self, until: int, time: float | None) -> bool:
        """Explain why the robot is not moving although no command stopped it; False if unknown."""
        if self._commands.last(until) < 0:
            self._actions.not_moving(until, time)
            return True
        bump = self._blocking(time)
        if bump is not None:
            self._actions.bumped(bump, until)
        elif self._run_end.is_over(until):
            if not self._run_end.failed(until):
                self._run_end.stop_reason(until)
            self._draft.say_of_line("why-stops-at-end", 0, until)
            self._actions.moved(self._commands.last(until), until)
        return bump is not None or self._run_end.is_over(until)

    def _blocking(self, time: float | None) -> dict[str, Any] | None:
        """The collision since which the robot has not moved, at a time; None if there is none."""
        lines = self._history.recorded.lines
        at = self._history.end if time is None else time
        places = [line["pose"] for line in lines if "pose" in line and at - 0.5 <= line["t"] <= at]
        bumps = [line for line in lines if "bump" in line and line["t"] <= at]
        is_still = places and all(dist(place[:2], places[0][:2]) < _STILL for place in places)
        return bumps[-1] if bumps and is_still else None

    def why_not(self, name: str, until: int, time: float | None) -> None:
        """Tell why the robot did not make a movement."""
        name = name if name in MOVEMENTS else ""
        has_stopped = any(STAND in self._commands.names(command) for command in self._commands.all)
        if name == STAND and time is None and has_stopped:
            # It did stop, perhaps more than once, but it continued.
            self._whole_run.not_end(until)
        self._actions.not_moved(name, until, time)
