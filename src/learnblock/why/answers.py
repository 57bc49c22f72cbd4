"""Answers to questions about a run."""

from bisect import bisect_right
from collections.abc import Callable
from math import dist
from typing import Any

from learnblock.i18n.names import goal_phrase
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind, Node
from learnblock.why.because import Because
from learnblock.why.doing import LONG_AGO, Doing
from learnblock.why.ending import Ending
from learnblock.why.history import History
from learnblock.why.questions import Ask, Question
from learnblock.why.reaching import Reaching
from learnblock.why.readings import Readings
from learnblock.why.seeing import Seen, with_things
from learnblock.why.sentences import Answer, Telling
from learnblock.why.slicing import Slices
from learnblock.why.standing import Standing
from learnblock.why.unused import Unused
from learnblock.why.wording import MOVEMENTS, STAND, movement

#: A robot that has not moved so many mm stands still.
_STILL = 2.0
#: The time of what is asked about may be so many seconds off: people round it.
_ABOUT = 0.06


def answer(history: History, question: Question, seen: Seen | None = None) -> Answer:
    """Answer a question about a run.

    Args:
        history: of the run.
        question: about it.
        seen: tells what a distance sensor looked at, by its side and the time in s.
    """
    return Answers(history, seen).answer(question)


class Answers:
    """Answers questions about one run.

    Args:
        history: of the run.
        seen: tells what a distance sensor looked at, by its side and the time in s.
    """

    def __init__(self, history: History, seen: Seen | None = None) -> None:
        self._history = history
        self._slices = Slices(history)
        self._readings = Readings(self._slices)
        self._unused = Unused(self._slices)
        self._seen = seen

    def answer(self, question: Question) -> Answer:
        """Answer a question."""
        telling = Telling(self._history)
        _Answering(self._slices, self._readings, self._unused, telling, question.time).answer(
            question
        )
        return with_things(telling.answer(), self._seen)


class _Answering:
    """One answer."""

    def __init__(
        self,
        slices: Slices,
        readings: Readings,
        unused: Unused,
        telling: Telling,
        time: float | None,
    ) -> None:
        self._history: History = slices.history
        self._slices = slices
        self._telling = telling
        self._standing = Standing(slices)
        self._because = Because(slices, readings, unused, telling)
        self._ending = Ending(slices, self._because, telling, time)
        self._reaching = Reaching(slices, readings, self._because, telling, self._ending)
        self._doing = Doing(slices, self._because, self._reaching, telling)

    def answer(self, question: Question) -> None:
        history = self._history
        if not history.events:
            if not self._ending.failed(-1):
                self._telling.say_of_line("why-no-events", 0)
            return
        until = len(history.events) - 1
        if question.time is not None:
            # What the robot does at a moment does not depend on what it is told right after.
            about = 0.0 if question.ask is Ask.NOW else _ABOUT
            until = max(0, history.at(question.time + about))
        _ANSWERS[question.ask](self, question.subject, until, question.time)
        if not len(self._telling):
            self._telling.say_of_line("why-unknown", 0)

    def _movement(self, name: str, until: int, time: float | None) -> None:
        name = name if name in MOVEMENTS else ""
        wanted = self._told_to(name, until, time)
        soon = self._about_to(name, until)
        if wanted >= 0 and not self._is_long_over(name, wanted, time):
            self._doing.moved(wanted, until)
        elif soon >= 0:
            self._doing.moved(soon, until)
        elif name == STAND and self._stands(until, time):
            return
        elif wanted >= 0:
            self._telling.say_of_line("why-not-then", 0, until, time=time or 0.0)
            self._doing.moved(self._in_force(until), until)
        else:
            self._not_happened(until, time)
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
        return next((index for index in before if name in self._names(index)), -1)

    def _in_force(self, until: int) -> int:
        """The last command to the wheels up to an event; -1 if there was none."""
        return self._history.last_of(self._slices.of_base, until)

    def _about_to(self, name: str, until: int) -> int:
        """The first command of a movement by the skill that lasts at an event; -1 if none."""
        commands, use = self._slices.of_base, self._standing.running(until)
        later = commands[bisect_right(commands, until) :] if use else []
        own = (one for one in later if self._doing.outermost(one) is use)
        return next((one for one in own if name in self._names(one)), -1)

    def _not_happened(self, until: int, time: float | None) -> None:
        at = self._history.end if time is None else min(time, self._history.end)
        self._telling.say_of_line("why-not-happened", 0, until, time=round(at, 2))

    def _is_long_over(self, name: str, command: int, time: float | None) -> bool:
        """Whether another movement has replaced one long before a moment."""
        commands = self._slices.of_base
        later = commands[bisect_right(commands, command) :]
        end = next((index for index in later if name not in self._names(index)), -1)
        return time is not None and end >= 0 and time - self._history.time(end) > LONG_AGO

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
        is_still = places and all(dist(one[:2], places[0][:2]) < _STILL for one in places)
        return bumps[-1] if bumps and is_still else None

    def _names(self, index: int) -> tuple[str, ...]:
        """The names of a movement; a question need not tell turning on the spot from a curve."""
        name = movement(*self._history.events[index][3][:2])
        return (name, name.replace("curve", "spin"), *(("",) if "-" in name else ()))

    def _not_movement(self, name: str, until: int, time: float | None) -> None:
        name = name if name in MOVEMENTS else ""
        self._doing.not_moved(name, until, time)

    def _skill(self, name: str, until: int, time: float | None) -> None:
        ran = self._doing.results(self._skills(name), until)
        if ran:
            self._doing.ran(ran[-1], until)
        else:
            self._not_happened(until, time)
            self._doing.not_done(self._skills(name), name, until, time)

    def _not_skill(self, name: str, until: int, time: float | None) -> None:
        self._doing.not_done(self._skills(name), name, until, time)

    def _skills(self, name: str) -> list[int]:
        return self._calls(lambda node: node.name == name and node.base == "robot")

    def _calls(self, fits: Callable[[Node], bool]) -> list[int]:
        return [
            number
            for number, node in enumerate(self._history.nodes)
            if node.kind is Kind.CALL and fits(node)
        ]

    def _print(self, subject: str, until: int, time: float | None) -> None:
        calls = self._prints(subject)
        ran = self._doing.results(calls, until)
        if ran:
            self._doing.ran(ran[-1], until)
        else:
            self._not_happened(until, time)
            self._doing.not_done(calls, "print", until, time)

    def _not_print(self, subject: str, until: int, time: float | None) -> None:
        self._doing.not_done(self._prints(subject), "print", until, time)

    def _printed(self, text: str, until: int, time: float | None) -> None:
        event = self._printing(text, time)
        if event >= 0:
            self._doing.ran(event, until)
        else:
            self._print(text, until, time)

    def _printing(self, text: str, time: float | None) -> int:
        """The event that printed exactly this text last, up to a time in s; -1 if none did."""
        history = self._history
        calls = self._calls(lambda node: node.name == "print" and not node.base)
        events = sorted(event for call in calls for event in history.of_node.get(call, ()))
        done = [event for event in events if history.events[event][0] == Op.RESULT]
        limit = history.end if time is None else time + _ABOUT
        texts = [line for line in history.recorded.lines if "print" in line]
        if len(done) == len(texts):
            alike = [
                event
                for event, line in zip(done, texts, strict=True)
                if str(line["print"]) == text and line.get("t", 0.0) <= limit
            ]
            return alike[-1] if alike else -1
        # The log has lost some: of those that are left, one of the same moment printed it.
        times = [line["t"] for line in texts if str(line["print"]) == text and line["t"] <= limit]
        there = [event for event in done if times and abs(history.time(event) - times[-1]) < _ABOUT]
        return there[-1] if there else -1

    def _prints(self, subject: str) -> list[int]:
        """The calls of print on a line, or with a text; all of them if none has it."""
        calls = self._calls(lambda node: node.name == "print" and not node.base)
        of_line = [call for call in calls if str(self._history.line(call)) == subject]
        fold = subject.casefold()
        of_text = [call for call in calls if fold in self._history.nodes[call].text.casefold()]
        return of_line or of_text or calls

    def _line(self, subject: str, until: int, time: float | None) -> None:
        numbers = self._nodes_of(subject)
        ran = sorted(
            event
            for number in numbers
            for event in self._history.of_node.get(number, ())
            if event <= until
        )
        if not ran:
            self._not_line(subject, until, time)
            return
        self._doing.ran(ran[-1], until)

    def _not_line(self, subject: str, until: int, time: float | None) -> None:
        numbers = self._nodes_of(subject)
        if not numbers:
            self._telling.say_of_line("why-no-such-line", int(subject) if subject.isdigit() else 0)
            return
        self._doing.not_done(numbers[:1], "", until, time)

    def _nodes_of(self, line: str) -> list[int]:
        return [
            number
            for number in range(len(self._history.nodes))
            if str(self._history.line(number)) == line
        ]

    def _when(self, name: str, until: int, time: float | None) -> None:
        entered = [
            event
            for number in self._functions(name)
            for event in self._history.of_node.get(number, ())
            if event <= until and self._history.events[event][0] == Op.ENTER
        ]
        if not entered:
            self._not_when(name, until, time)
            return
        self._telling.say(
            "why-when-ran", self._history.events[entered[-1]][1], entered[-1], name=name
        )
        self._because.tell(entered[-1], names=())

    def _not_when(self, name: str, until: int, time: float | None) -> None:
        for number in self._functions(name):
            self._reaching.inactive(number, until, self._doing.since(time))
            entered = self._history.last_of(self._history.of_node.get(number, []), until)
            if entered >= 0:
                self._telling.say("why-when-ran", number, entered, name=name)
                self._because.tell(entered, names=())

    def _functions(self, name: str) -> list[int]:
        return [
            number
            for number, node in enumerate(self._history.nodes)
            if node.kind is Kind.FUNCTION and node.is_when and node.name == name
        ]

    def _value(self, name: str, until: int, time: float | None) -> None:
        del time
        write = self._slices.last_write(name, until)
        if write < 0:
            mine = self._history.last_of(self._history.writes.get(name, []), until)
            if mine < 0:
                self._not_written(name, until)
                return
            until = mine
        self._because.others(name, until)
        self._because.value(name, until)
        self._because.stopped_writing(name, until, 0.9)
        self._because.finish()
        self._doing.not_written_again(name, until)

    def _not_written(self, name: str, until: int) -> None:
        writers = [number for number, node in enumerate(self._history.nodes) if name in node.writes]
        self._telling.say_of_line("why-not-set", 0, until, name=name)
        for number in writers:
            self._reaching.tell(number, until)

    def _goal(self, name: str, until: int, time: float | None) -> None:
        goals = self._goals(name)
        missed = [goal for goal in goals if goal.get("state") != "reached"]
        named = [goal for goal in goals if goal.get("name") == name] or missed or [*goals]
        for goal in named[:1]:
            state, name = str(goal.get("state")), str(goal.get("name"))
            reached = goal.get("time")
            is_later = reached is not None and time is not None and reached > time + _ABOUT
            if reached is None or is_later:
                state, event = "open", until
                at = self._history.end if time is None else min(time, self._history.end)
            else:
                event, at = max(0, self._history.at(reached)), reached
            self._telling.say_of_line(
                "why-goal", 0, event, name=goal_phrase(name), state=state, time=round(at, 2)
            )
            until = event
            if state == "reached":
                self._now("", until, None)
                return
        if not named:
            self._telling.say_of_line("why-no-goal", 0, until)
        self._first_bump(until)
        self._now("", until, None)

    def _goals(self, name: str) -> list[dict[str, Any]]:
        """The goals of the run; while it goes on, the named one as it is now."""
        recorded = self._history.recorded
        if goals := recorded.ending.get("goals"):
            return list(goals)
        told = [line for line in recorded.lines if line.get("goal") == name]
        now = {"state": told[-1]["state"], "time": told[-1]["t"]} if told else {"state": "open"}
        return [{"name": name, **now}] if name and not recorded.ending else []

    def _emotion(self, name: str, until: int, time: float | None) -> None:
        shown = [
            index
            for index, event in enumerate(self._history.events[: until + 1])
            if event[0] == Op.COMMAND and event[2] == "show_emotion" and event[3][:1] == [name]
        ]
        use = self._history.skills.get(shown[-1]) if shown else None
        while use is not None and use.within is not None:
            use = use.within
        if use is not None:
            self._doing.ran(use.result if use.result >= 0 else use.begun, until)
            return
        self._not_happened(until, time)
        self._now("", until, time)

    def _first_bump(self, until: int) -> None:
        bumps = [line for line in self._history.recorded.lines if "bump" in line]
        if bumps:
            self._doing.bumped(bumps[0], until)

    def _bump(self, name: str, until: int, time: float | None) -> None:
        bumps = [
            line
            for line in self._history.recorded.lines
            if "bump" in line
            and (time is None or line.get("t", 0.0) <= time + 0.5)
            and name in ("", line["bump"])
        ]
        if not bumps:
            self._telling.say_of_line("why-no-bump", 0, until)
            return
        self._doing.bumped(bumps[-1] if time is not None else bumps[0], until)

    def _end(self, subject: str, until: int, time: float | None) -> None:
        del subject, until, time
        last = len(self._history.events) - 1
        if self._ending.failed(last):
            return
        self._now("", last, None)

    def _now(self, subject: str, until: int, time: float | None) -> None:
        """What the robot was doing, and what the program was busy with."""
        del subject, time
        self._ending.stop_reason(until)
        last = self._history.last_of(self._slices.of_base, until)
        if last >= 0:
            self._doing.moved(last, until)
        self._reaching.busy(until)


_ANSWERS: dict[Ask, Callable[[_Answering, str, int, float | None], None]] = {
    Ask.MOVEMENT: _Answering._movement,  # noqa: SLF001 - a table of its own methods
    Ask.NOT_MOVEMENT: _Answering._not_movement,  # noqa: SLF001
    Ask.SKILL: _Answering._skill,  # noqa: SLF001
    Ask.NOT_SKILL: _Answering._not_skill,  # noqa: SLF001
    Ask.PRINT: _Answering._print,  # noqa: SLF001
    Ask.NOT_PRINT: _Answering._not_print,  # noqa: SLF001
    Ask.PRINTED: _Answering._printed,  # noqa: SLF001
    Ask.WHEN: _Answering._when,  # noqa: SLF001
    Ask.NOT_WHEN: _Answering._not_when,  # noqa: SLF001
    Ask.LINE: _Answering._line,  # noqa: SLF001
    Ask.NOT_LINE: _Answering._not_line,  # noqa: SLF001
    Ask.VALUE: _Answering._value,  # noqa: SLF001
    Ask.GOAL: _Answering._goal,  # noqa: SLF001
    Ask.REACHED: _Answering._goal,  # noqa: SLF001
    Ask.EMOTION: _Answering._emotion,  # noqa: SLF001
    Ask.END: _Answering._end,  # noqa: SLF001
    Ask.BUMP: _Answering._bump,  # noqa: SLF001
    Ask.NOW: _Answering._now,  # noqa: SLF001
}
