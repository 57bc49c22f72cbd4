"""The values of variables next to the lines of a program, at a place in its run."""

from collections.abc import Iterator
from dataclasses import dataclass

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind
from learnblock.why.history import EventHistory, Frame
from learnblock.why.moments import Moments, shown, written

#: How far back in the log the beginning of a line is searched.
_FARTHEST = 500
_PROGRAM = Frame(-1)
#: Events that contain the program's position.
_PLACED = frozenset({Op.CONDITION, Op.OPERAND, Op.RESULT, Op.WRITE, Op.TURN, Op.CALLS, Op.RETURN})


@dataclass(frozen=True, slots=True)
class ValueThere:
    """A value next to a line.

    Args:
        line: the line of the program's Python.
        name: what has the value; "" for the condition in that line.
        value: as Python would show it.
    """

    line: int
    name: str
    value: str


def values_there(
    history: EventHistory, moments: Moments, event: int, line: int
) -> list[ValueThere]:
    """The values next to the lines, after an event.

    Next to the line that ran are the values that it has read and written, and whether its condition
    was true. Every other variable is next to the line that gave it its value.

    Args:
        history: the run.
        moments: its moments.
        event: the last event that has happened; -1 before the first.
        line: the line that ran.
    """
    return [] if event < 0 else list(_There(history, moments, event, line).values())


class _There:
    """The values at one place of a run."""

    def __init__(self, history: EventHistory, moments: Moments, event: int, line: int) -> None:
        self._history = history
        self._moments = moments
        self._event = event
        self._line = line
        self._frame = history.frames[event] or _PROGRAM

    def values(self) -> Iterator[ValueThere]:
        here = self._names_here()
        for name in here:
            if (write := self._last_write(name)) >= 0:
                yield ValueThere(self._line, name, self._value(write, name))
        yield from self._decisions()
        for name in self._history.writes:
            if name not in here and not name.startswith("_"):
                yield from self._elsewhere(name)

    def _names_here(self) -> list[str]:
        """The variables that the line that ran reads or writes."""
        function = self._frame.node
        nodes = [
            node
            for number, node in enumerate(self._history.nodes)
            if node.line == self._line and function in (node.function, number)
        ]
        names = (name for node in nodes for name in (*node.reads, *node.writes, *node.parameters))
        unseen = self._moments.robots
        return [name for name in dict.fromkeys(names) if name not in unseen and name[0] != "_"]

    def _decisions(self) -> Iterator[ValueThere]:
        """What the conditions in the line that ran have measured, and whether they were true."""
        history, values = self._history, list[ValueThere]()
        decided = False
        for index in range(self._event, max(-1, self._event - _FARTHEST), -1):
            event = history.events[index]
            op = event[0]
            if op not in _PLACED or history.frames[index] is not self._frame:
                continue
            node = history.node(index)
            if node.line != self._line or op == Op.TURN:
                break
            if op == Op.CONDITION:
                decided = True
                values.insert(0, ValueThere(self._line, "", shown(bool(event[2]))))
            elif decided and op == Op.RESULT and not isinstance(event[2], bool | None):
                values.insert(0, ValueThere(self._line, f"{node.name}()", shown(event[2])))
        return iter(values)

    def _elsewhere(self, name: str) -> Iterator[ValueThere]:
        write = self._last_write(name)
        if write < 0:
            return
        node, value = self._history.node(write), self._value(write, name)
        # A value that is written there need not be repeated.
        is_plain = node.kind is Kind.ASSIGN and node.text == f"{name} = {value}"
        if node.line != self._line and not is_plain and name not in self._moments.robots:
            yield ValueThere(node.line, name, value)

    def _last_write(self, name: str) -> int:
        """The event that gave a variable its value in the running function."""
        own = self._frame.entered if self._frame.node >= 0 else -1
        last = self._moments.last_write(name, self._event, own) if own >= 0 else -1
        return last if last >= 0 else self._moments.last_write(name, self._event, -1)

    def _value(self, write: int, name: str) -> str:
        return shown(written(self._history, write, name))
