"""Answers to questions about a run."""

from collections.abc import Callable
from functools import partial
from typing import Any

from learnblock.i18n.names import goal_phrase
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind, Node
from learnblock.why.actions import ABOUT, Actions
from learnblock.why.causes import Causes
from learnblock.why.games import GameFacts
from learnblock.why.history import EventHistory
from learnblock.why.inquiry import Inquiry
from learnblock.why.missed import goal_missed
from learnblock.why.movements import LINES, Movements
from learnblock.why.omissions import Omissions
from learnblock.why.questions import Question, QuestionKind
from learnblock.why.readings import Readings
from learnblock.why.run_end import RunEnd
from learnblock.why.sentences import Draft, Explanation
from learnblock.why.slices import Slices
from learnblock.why.things import Seen, with_things
from learnblock.why.unused import Unused
from learnblock.why.variables import VariableFacts
from learnblock.why.waits import Waits
from learnblock.why.whole_run import WholeRun


def answer(history: EventHistory, question: Question, identify: Seen | None = None) -> Explanation:
    """Answer a question about a run.

    Args:
        history: of the run.
        question: about it.
        identify: tells what a distance sensor looked at, by its side and the time in s.
    """
    return Answers(history, identify).answer(question)


class Answers:
    """Answers questions about one run.

    Args:
        history: of the run.
        identify: tells what a distance sensor looked at, by its side and the time in s.
    """

    def __init__(self, history: EventHistory, identify: Seen | None = None) -> None:
        self._history = history
        self._slices = Slices(history)
        self._readings = Readings(self._slices)
        self._unused = Unused(self._slices)
        self._identify = identify

    def answer(self, question: Question) -> Explanation:
        """Answer a question."""
        draft = Draft(self._history)
        inquiry = Inquiry(
            self._slices, self._readings, self._unused, draft, question.time, question.since
        )
        _Answering(inquiry).answer(question)
        return with_things(draft.answer(), self._identify)


class _Answering:
    """One answer."""

    def __init__(self, inquiry: Inquiry) -> None:
        self._history: EventHistory = inquiry.history
        self._slices = inquiry.slices
        self._position = inquiry.position
        self._commands = inquiry.commands
        self._draft = inquiry.draft
        self._games = GameFacts(inquiry.history, inquiry.draft)
        self._since = inquiry.since
        # Each one uses only those above it.
        self._variables = VariableFacts(inquiry)
        self._causes = Causes(inquiry)
        self._run_end = RunEnd(inquiry, causes=self._causes, games=self._games)
        self._waits = Waits(inquiry, causes=self._causes)
        self._omissions = Omissions(
            inquiry, causes=self._causes, run_end=self._run_end, waits=self._waits
        )
        self._actions = Actions(
            inquiry, causes=self._causes, waits=self._waits, omissions=self._omissions
        )
        self._whole_run = WholeRun(
            inquiry,
            causes=self._causes,
            run_end=self._run_end,
            waits=self._waits,
            omissions=self._omissions,
            actions=self._actions,
        )
        self._movements = Movements(
            inquiry, run_end=self._run_end, actions=self._actions, whole_run=self._whole_run
        )

    def answer(self, question: Question) -> None:
        history = self._history
        if not history.events:
            if not self._run_end.failed(-1):
                self._draft.say_of_line("why-no-events", 0)
            return
        until = len(history.events) - 1
        if question.time is not None:
            # The robot's movement at a moment does not depend on a command right after it.
            about = 0.0 if question.ask is QuestionKind.NOW else ABOUT
            until = max(0, history.at(question.time + about))
        _ANSWERS[question.ask](self, question.subject, until, question.time)
        if not len(self._draft):
            self._draft.say_of_line("why-unknown", 0)

    def _movement(self, name: str, until: int, time: float | None) -> None:
        self._movements.why(name, until, time)

    def _not_movement(self, name: str, until: int, time: float | None) -> None:
        self._movements.why_not(name, until, time)

    def _skill(self, name: str, until: int, time: float | None) -> None:
        if not self._ran(self._skills(name), until, time):
            self._actions.not_happened(until, time)
            self._actions.not_done(self._skills(name), name, until, time)

    def _ran(self, numbers: list[int], until: int, time: float | None) -> bool:
        """Tell why statements ran; each of them if no moment is given. False if none ran."""
        ran = [
            event for event in self._actions.results(numbers, until) if self._actions.in_span(event)
        ]
        if not ran:
            return False
        last = {self._line_of(event): event for event in ran}
        if self._actions.is_moment(time):
            last = {0: ran[-1]}
        for event in [*reversed(last.values())][:LINES]:
            self._draft.begin_part()
            self._actions.ran(event, until)
        return True

    def _line_of(self, event: int) -> int:
        use = self._history.skills.get(event)
        number = self._position.call_of(use) if use else self._history.number(event)
        return self._history.line(number) if number >= 0 else 0

    def _not_skill(self, name: str, until: int, time: float | None) -> None:
        self._actions.not_done(self._skills(name), name, until, time)

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
        ran = [
            event for event in self._actions.results(calls, until) if self._actions.in_span(event)
        ]
        if ran:
            self._print_ran(ran[-1], until)
        else:
            self._actions.not_happened(until, time)
            self._actions.not_done(calls, "print", until, time)

    def _print_ran(self, event: int, until: int) -> None:
        self._actions.ran(event, until)
        if self._history.op(event) == Op.RESULT:
            self._variables.not_yet(self._history.number(event), event)

    def _not_print(self, subject: str, until: int, time: float | None) -> None:
        self._actions.not_done(self._prints(subject), "print", until, time)

    def _printed(self, text: str, until: int, time: float | None) -> None:
        event = self._printing(text, time)
        if event >= 0:
            self._print_ran(event, until)
        else:
            self._print(text, until, time)

    def _printing(self, text: str, time: float | None) -> int:
        """The event that printed exactly this text last, up to a time in s; -1 if none did."""
        history = self._history
        calls = self._calls(lambda node: node.name == "print" and not node.base)
        events = sorted(event for call in calls for event in history.of_node.get(call, ()))
        prints = [event for event in events if history.op(event) == Op.RESULT]
        limit = history.end if time is None else time + ABOUT
        texts = [line for line in history.recorded.lines if "print" in line]
        if len(prints) == len(texts):
            alike = [
                event
                for event, line in zip(prints, texts, strict=True)
                if str(line["print"]) == text and line.get("t", 0.0) <= limit
            ]
            return alike[-1] if alike else -1
        # The log has lost some: of those that are left, one of the same moment printed it.
        times = [line["t"] for line in texts if str(line["print"]) == text and line["t"] <= limit]
        there = [
            event for event in prints if times and abs(history.time(event) - times[-1]) < ABOUT
        ]
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
            if self._actions.first <= event <= until
        )
        if not ran:
            self._not_line(subject, until, time)
            return
        self._actions.ran(ran[-1], until)

    def _not_line(self, subject: str, until: int, time: float | None) -> None:
        numbers = self._nodes_of(subject)
        if not numbers:
            self._draft.say_of_line("why-no-such-line", int(subject) if subject.isdigit() else 0)
            return
        self._actions.not_done(numbers[:1], "", until, time)

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
            if self._actions.first <= event <= until and self._history.op(event) == Op.ENTER
        ]
        if not entered:
            self._not_when(name, until, time)
            return
        self._draft.say("why-when-ran", self._history.number(entered[-1]), entered[-1], name=name)
        self._causes.tell(entered[-1], names=())

    def _not_when(self, name: str, until: int, time: float | None) -> None:
        for number in self._functions(name):
            self._omissions.inactive(number, until, self._actions.since(time))
            entered = self._history.last_of(self._history.of_node.get(number, []), until)
            if entered >= 0:
                self._draft.say("why-when-ran", number, entered, name=name)
                self._causes.tell(entered, names=())

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
        self._variables.others(name, until)
        self._causes.value(name, until)
        self._causes.stopped_writing(name, until, 0.9)
        self._causes.finish()
        self._actions.not_written_again(name, until)

    def _not_written(self, name: str, until: int) -> None:
        writers = [number for number, node in enumerate(self._history.nodes) if name in node.writes]
        self._draft.say_of_line("why-not-set", 0, until, name=name)
        for number in writers:
            self._omissions.tell(number, until)

    def _goal(self, name: str, until: int, time: float | None) -> None:
        goals = self._goals(name)
        missed = [goal for goal in goals if goal.get("state") != "reached"]
        candidates = [goal for goal in goals if goal.get("name") == name] or missed or [*goals]
        for goal in candidates[:1]:
            state, name = str(goal.get("state")), str(goal.get("name"))
            reached = goal.get("time")
            is_later = reached is not None and time is not None and reached > time + ABOUT
            if reached is None or is_later:
                state, event = "open", until
                at = self._history.end if time is None else min(time, self._history.end)
            else:
                event, at = max(0, self._history.at(reached)), reached
            self._draft.say_of_line(
                "why-goal", 0, event, name=goal_phrase(name), state=state, time=round(at, 2)
            )
            until = event
            if state == "reached":
                self._now("", until, None)
                return
            self._games.tell_winner(until, time)
            if miss := goal_missed(self._history.recorded, name, at):
                there = {} if miss.time is None else {"time": round(miss.time, 2)}
                self._draft.say_of_line(miss.words.code, 0, event, **miss.words.values, **there)
        if not candidates:
            self._draft.say_of_line("why-no-goal", 0, until)
        self._first_bump(until)
        self._now("", until, None)

    def _goals(self, name: str) -> list[dict[str, Any]]:
        """The goals of the run; during the run, the named one in its current state."""
        recorded = self._history.recorded
        if goals := recorded.ending.get("goals"):
            return list(goals)
        states = [line for line in recorded.lines if line.get("goal") == name]
        last = states[-1] if states else {"state": "open", "t": None}
        now = {"state": last["state"], "time": last["t"]}
        return [{"name": name, **now}] if name and not recorded.ending else []

    def _game(self, name: str, until: int, time: float | None, *, what: str) -> None:
        del name
        skills = self._games.tell(what, until, time)
        self._ran([number for skill in skills for number in self._skills(skill)], until, time)

    def _emotion(self, name: str, until: int, time: float | None) -> None:
        commands = [
            index
            for index, event in enumerate(self._history.events[: until + 1])
            if event[0] == Op.COMMAND and event[2] == "show_emotion" and event[3][:1] == [name]
        ]
        last_by_line: dict[int, int] = {}
        for index in reversed(commands):
            use = self._history.own_use(index)
            if use is not None and index >= self._actions.first:
                event = use.result if 0 <= use.result <= until else use.begun
                last_by_line.setdefault(self._line_of(event), event)
        several = 1 if self._actions.is_moment(time) else LINES
        for event in [*last_by_line.values()][:several]:
            self._draft.begin_part()
            self._actions.ran(event, until)
        if last_by_line:
            return
        self._actions.not_happened(until, time)
        self._now("", until, time)

    def _first_bump(self, until: int) -> None:
        bumps = [line for line in self._history.recorded.lines if "bump" in line]
        if bumps:
            self._actions.bumped(bumps[0], until)

    def _bump(self, name: str, until: int, time: float | None) -> None:
        bumps = [
            line
            for line in self._history.recorded.lines
            if "bump" in line
            and (time is None or line.get("t", 0.0) <= time + 0.5)
            and (self._since is None or line.get("t", 0.0) >= self._since - ABOUT)
            and name in ("", line["bump"])
        ]
        if not bumps:
            if any("bump" in line for line in self._history.recorded.lines):
                self._actions.not_happened(until, time)
            else:
                self._draft.say_of_line("why-no-bump", 0, until)
            return
        self._actions.bumped(bumps[-1] if self._actions.is_moment(time) else bumps[0], until)

    def _end(self, subject: str, until: int, time: float | None) -> None:
        del subject, until, time
        last = len(self._history.events) - 1
        if self._run_end.failed(last):
            return
        self._run_end.stop_reason(last)
        self._whole_run.came_to_end(last)
        self._now("", last, None)

    def _now(self, subject: str, until: int, time: float | None) -> None:
        """What the robot was doing, and what the program was busy with."""
        del subject, time
        self._run_end.stop_reason(until)
        if self._since is not None:
            self._whole_run.say_commands(self._actions.first, until)
        last = self._commands.last(until)
        if last >= 0:
            self._actions.moved(last, until)
        self._omissions.busy(until)

    def _not_end(self, subject: str, until: int, time: float | None) -> None:
        if not self._whole_run.not_end(until):
            self._end(subject, until, time)

    def _nothing(self, subject: str, until: int, time: float | None) -> None:
        if not self._whole_run.nothing(self._actions.since(time), until):
            self._now(subject, until, time)

    def _speed(self, which: str, until: int, time: float | None) -> None:
        self._whole_run.speed(which, self._actions.since(time), until)

    def _long(self, name: str, until: int, time: float | None) -> None:
        if not self._whole_run.long(name, self._actions.since(time), until):
            self._movement(name, until, time)

    def _lost(self, subject: str, until: int, time: float | None) -> None:
        del subject, time
        self._whole_run.lost(self._actions.first, until)

    def _fall(self, subject: str, until: int, time: float | None) -> None:
        del subject, time
        self._whole_run.fall(until)


_ANSWERS: dict[QuestionKind, Callable[[_Answering, str, int, float | None], None]] = {
    QuestionKind.MOVEMENT: _Answering._movement,  # noqa: SLF001 - a table of its own methods
    QuestionKind.NOT_MOVEMENT: _Answering._not_movement,  # noqa: SLF001
    QuestionKind.SKILL: _Answering._skill,  # noqa: SLF001
    QuestionKind.NOT_SKILL: _Answering._not_skill,  # noqa: SLF001
    QuestionKind.PRINT: _Answering._print,  # noqa: SLF001
    QuestionKind.NOT_PRINT: _Answering._not_print,  # noqa: SLF001
    QuestionKind.PRINTED: _Answering._printed,  # noqa: SLF001
    QuestionKind.WHEN: _Answering._when,  # noqa: SLF001
    QuestionKind.NOT_WHEN: _Answering._not_when,  # noqa: SLF001
    QuestionKind.LINE: _Answering._line,  # noqa: SLF001
    QuestionKind.NOT_LINE: _Answering._not_line,  # noqa: SLF001
    QuestionKind.VALUE: _Answering._value,  # noqa: SLF001
    QuestionKind.GOAL: _Answering._goal,  # noqa: SLF001
    QuestionKind.REACHED: _Answering._goal,  # noqa: SLF001
    QuestionKind.EMOTION: _Answering._emotion,  # noqa: SLF001
    QuestionKind.END: _Answering._end,  # noqa: SLF001
    QuestionKind.BUMP: _Answering._bump,  # noqa: SLF001
    QuestionKind.NOT_END: _Answering._not_end,  # noqa: SLF001
    QuestionKind.NOTHING: _Answering._nothing,  # noqa: SLF001
    QuestionKind.SPEED: _Answering._speed,  # noqa: SLF001
    QuestionKind.LONG: _Answering._long,  # noqa: SLF001
    QuestionKind.LOST: _Answering._lost,  # noqa: SLF001
    QuestionKind.FALL: _Answering._fall,  # noqa: SLF001
    QuestionKind.SCORE: partial(_Answering._game, what="score"),  # noqa: SLF001
    QuestionKind.LIVES: partial(_Answering._game, what="lives"),  # noqa: SLF001
    QuestionKind.GAME: partial(_Answering._game, what="end"),  # noqa: SLF001
    QuestionKind.NOW: _Answering._now,  # noqa: SLF001
}
