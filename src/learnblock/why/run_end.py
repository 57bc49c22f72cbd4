"""Why a run was over: an error, its end, or its time limit."""

from typing import Any

from learnblock.i18n import Phrase, Value
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind
from learnblock.why.causes import Causes
from learnblock.why.games import GameFacts
from learnblock.why.history import EventHistory
from learnblock.why.inquiry import Inquiry

#: The time in a question may be this many seconds off: people round it.
_ABOUT = 0.06
_ENDS = {
    "finished": "why-finished",
    "time limit": "why-time-limit",
    "stopped": "why-stopped",
}


class RunEnd:
    """Tells how a run ended.

    Args:
        inquiry: the question, and its answer so far.
        causes: tells why something happened.
        games: tells how a game ended.
    """

    def __init__(self, inquiry: Inquiry, *, causes: Causes, games: GameFacts) -> None:
        self._history: EventHistory = inquiry.history
        self._causes = causes
        self._games = games
        self._draft = inquiry.draft
        self._time = inquiry.time

    def is_over(self, until: int) -> bool:
        """Whether the run was over at an event, and at the moment in question.

        The last event may be long before the end: it began a wait.
        """
        history = self._history
        is_late = self._time is None or self._time >= history.end - _ABOUT
        return is_late and until >= len(history.events) - 1

    def moment(self, until: int) -> float:
        """The time of an event in a question, in s: the moment in question, or the end of the run.

        The last event before may be long ago: it began a wait, or turns of a loop that were alike.
        """
        history = self._history
        if self._time is None:
            return history.end if until >= len(history.events) - 1 else history.time(until)
        moment = min(self._time, history.end)
        return moment if history.at(moment + _ABOUT) == until else history.time(until)

    def failed(self, until: int) -> bool:
        """Tell that an error had ended the program, if one had."""
        error: Any = self._history.recorded.ending.get("error")
        last = len(self._history.events) - 1
        if not error or not self.is_over(until):
            return False
        line = error.get("line") or 0
        message: Value = _phrase(error.get("message"))
        if isinstance(message, Phrase):
            # Its meaning, without Python's own words.
            message = message.values.get("meaning", message)
        self._draft.say_of_line("why-failed", line, last, message=message)
        if last >= 0:
            self._causes_of_failure(line, last)
        return True

    def _causes_of_failure(self, line: int, last: int) -> None:
        history = self._history
        numbers = [number for number in range(len(history.nodes)) if history.line(number) == line]
        nodes = [history.nodes[number] for number in numbers]
        names = {name for node in nodes for name in node.reads if node.kind is not Kind.FUNCTION}
        for name in sorted(names - {"robot"}):
            self._causes.value(name, last, 1.0)
        for number in numbers:
            result = history.last_of(history.of_node.get(number, []), last)
            if result >= 0 and history.op(result) == Op.RESULT:
                self._causes.returned(result)
        control = next((node.control for node in nodes if node.control >= 0), -1)
        decision = history.last_of(history.of_node.get(control, []), last)
        if decision >= 0:
            # A condition that asks for the same values is likely to be wrong.
            is_near = names.intersection(history.nodes[control].reads)
            self._causes.also(decision, 0.9 if is_near else 2.0)
        self._causes.finish()

    def stop_reason(self, until: int) -> None:
        """Tell why the run was over, if it was at an event."""
        code = _ENDS.get(self._history.recorded.ending.get("ended", ""))
        if not (self.is_over(until) and code):
            return
        if not (code == "why-finished" and self._games.tell_end()):
            self._draft.say_of_line(code, 0)


def _phrase(plain: Any) -> Phrase | str:
    """A phrase from the plain data in a log."""
    if isinstance(plain, dict) and isinstance(plain.get("code"), str):
        values = plain.get("values") or {}
        return Phrase(plain["code"], **{str(key): _value(item) for key, item in values.items()})
    return str(plain)


def _value(value: Any) -> Any:
    if isinstance(value, dict):
        return _phrase(value)
    return tuple(map(_value, value)) if isinstance(value, list) else value
