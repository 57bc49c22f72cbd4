"""Why the robot moved as it did, or did not."""

from bisect import bisect_right
from math import dist
from typing import Any

from learnblock.why.doing import LONG_AGO, Doing
from learnblock.why.ending import Ending
from learnblock.why.history import History
from learnblock.why.overall import Overall
from learnblock.why.sentences import Telling
from learnblock.why.slicing import Slices
from learnblock.why.standing import Standing
from learnblock.why.wording import MOVEMENTS, STAND, movement

#: The most lines that an answer names, if the question has no moment.
LINES = 2
#: A robot that has moved less than this, in mm, stands still.
_STILL = 2.0


class Moving:
    """Tells why the robot moved, or did not.

    Args:
        slices: of the run.
        doing: tells why statements ran.
        ending: tells how the run ended.
        overall: tells about the run as a whole.
        telling: the answer.
    """

    def __init__(
        self, slices: Slices, *, doing: Doing, ending: Ending, overall: Overall, telling: Telling
    ) -> None:
        self._history: History = slices.history
        self._slices = slices
        self._standing = Standing(slices)
        self._doing = doing
        self._ending = ending
        self._overall = overall
        self._telling = telling

    def why(self, name: str, until: int, time: float | None) -> None:
        """Tell why the robot moved so."""
        name = name if name in MOVEMENTS else ""
        wanted = self._told_to(name, until, time)
        soon = self._about_to(name, until)
        if wanted >= 0 and not self._is_long_over(name, wanted, time):
            for command in self._by_line(name, wanted, time):
                self._telling.begin_part()
                self._doing.moved(command, self._lasts_until(name, command, until))
        elif soon >= 0:
            self._doing.moved(soon, until)
        elif name == STAND and self._stands(until, time):
            return
        elif wanted >= 0:
            self._telling.say_of_line("why-not-then", 0, until, time=time or 0.0)
            self._doing.moved(self._in_force(until), until)
        else:
            self._doing.not_happened(until, time)
            self._doing.not_moved(name, until, time)

    def _told_to(self, name: str, until: int, time: float | None) -> int:
        """The last command of a movement up to an event; -1 if there was none.

        What was in force at the very moment is meant rather than what came right after it.
        """
        exact = self._in_force(until if time is None else self._history.at(time))
        if exact >= 0 and name in self._names(exact):
            return exact
        commands = self._slices.of_base
        before = reversed(commands[: bisect_right(commands, until)])
        first = self._in_force(self._doing.first) if self._doing.first else 0
        return next(
            (command for command in before if name in self._names(command) and command >= first), -1
        )

    def _by_line(self, name: str, last: int, time: float | None) -> list[int]:
        """The last commands of a movement by each line that gave some, the last one first.

        A question about a moment is about one command.
        """
        if self._doing.is_moment(time):
            return [last]
        last_by_line: dict[int, int] = {}
        first = self._in_force(self._doing.first)
        for command in reversed(self._slices.of_base[: bisect_right(self._slices.of_base, last)]):
            is_other = name == movement(*self._history.events[command][3][:2]) and command >= first
            if is_other or command == last:
                use = self._doing.outermost(command)
                last_by_line.setdefault(self._standing.call_of(use) if use else -1, command)
        return [*last_by_line.values()][:LINES]

    def _lasts_until(self, name: str, command: int, until: int) -> int:
        """The last event up to another one at which a movement is still in force."""
        commands = self._slices.of_base
        later = commands[bisect_right(commands, command) : bisect_right(commands, until)]
        other = next((index for index in later if name not in self._names(index)), until + 1)
        return max(command, other - 1)

    def _in_force(self, until: int) -> int:
        """The last command to the wheels up to an event; -1 if there was none."""
        return self._history.last_of(self._slices.of_base, until)

    def _about_to(self, name: str, until: int) -> int:
        """The first command of a movement by the skill that lasts at an event; -1 if none."""
        commands, use = self._slices.of_base, self._standing.running(until)
        later = commands[bisect_right(commands, until) :] if use else []
        own = (command for command in later if self._doing.outermost(command) is use)
        return next((command for command in own if name in self._names(command)), -1)

    def _is_long_over(self, name: str, command: int, time: float | None) -> bool:
        """Whether another movement has replaced one long before a moment."""
        if time is None or not self._doing.is_moment(time):
            return False
        commands = self._slices.of_base
        later = commands[bisect_right(commands, command) :]
        end = next((index for index in later if name not in self._names(index)), -1)
        return end >= 0 and time - self._history.time(end) > LONG_AGO

    def _stands(self, until: int, time: float | None) -> bool:
        """Tell why the robot stands still though no command says so; False if it does not."""
        if self._in_force(until) < 0:
            self._doing.not_moving(until, time)
            return True
        bump = self._blocking(time)
        if bump is not None:
            self._doing.bumped(bump, until)
        elif self._ending.is_over(until):
            if not self._ending.failed(until):
                self._ending.stop_reason(until)
            self._telling.say_of_line("why-stops-at-end", 0, until)
            self._doing.moved(self._in_force(until), until)
        return bump is not None or self._ending.is_over(until)

    def _blocking(self, time: float | None) -> dict[str, Any] | None:
        """The collision since which the robot has not moved, at a time; None if there is none."""
        lines = self._history.recorded.lines
        at = self._history.end if time is None else time
        places = [line["pose"] for line in lines if "pose" in line and at - 0.5 <= line["t"] <= at]
        bumps = [line for line in lines if "bump" in line and line["t"] <= at]
        is_still = places and all(dist(place[:2], places[0][:2]) < _STILL for place in places)
        return bumps[-1] if bumps and is_still else None

    def _names(self, index: int) -> tuple[str, ...]:
        """The names of a movement; a question need not tell turning on the spot from a curve."""
        name = movement(*self._history.events[index][3][:2])
        return (name, name.replace("curve", "spin"), *(("",) if "-" in name else ()))

    def why_not(self, name: str, until: int, time: float | None) -> None:
        """Tell why the robot did not move so."""
        name = name if name in MOVEMENTS else ""
        stood = any(STAND in self._names(command) for command in self._slices.of_base)
        if name == STAND and time is None and stood:
            # It did stop, more than once perhaps: but it went on.
            self._overall.not_end(until)
        self._doing.not_moved(name, until, time)
