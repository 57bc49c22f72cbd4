"""The places to go to in a run: from line to line, turn to turn, mark to mark, change to change.

Much may happen at one moment, so a place in a run is a moment together with the last event that
has happened there.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from enum import StrEnum
from functools import cached_property

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import LOOPS, Kind, Node
from learnblock.runtime.log.noting import TICK
from learnblock.why.history import EventHistory
from learnblock.why.moments import Moments
from learnblock.why.shapes import OF_NODES

#: A time in ticks, and the last event that has happened by then; -1 before the first one.
Place = tuple[int, int]
START: Place = (0, -1)
#: Events that end a statement without beginning the next one.
_BETWEEN = frozenset({Op.ENTER, Op.LEAVE})
#: Events that only say how the log was kept.
_UNSEEN = frozenset({Op.REPEATED, Op.GAP})
#: The events to step to.
_STEPS = OF_NODES - _BETWEEN


class To(StrEnum):
    """The kinds of places to go to."""

    TIME = "time"
    LINE = "line"
    EVENT = "event"
    TURN = "turn"
    MARK = "mark"
    CHANGE = "change"
    RUN = "run"


class Steps:
    """The places in a run to go to.

    Args:
        history: the run.
        moments: its moments.
    """

    def __init__(self, history: EventHistory, moments: Moments) -> None:
        self._history = history
        self._moments = moments
        self._found: dict[tuple[To, object], Sequence[Place]] = {}

    def at(self, time: float) -> Place:
        """The place at a time in s, when everything of that time has happened."""
        return round(time / TICK), self._history.at(time)

    def line_at(self, place: Place) -> int:
        """The line of the program's Python that ran last; 0 before the first one."""
        index = bisect_right(self._places_of_lines, place)
        return self._lines[index - 1][1] if index else 0

    def go(self, by: int, place: Place, to: To, subject: str | frozenset[int] = "") -> Place | None:
        """The nearest place before or after another one; None if there is none.

        Args:
            by: -1 for the one before, 1 for the one after.
            place: where to start.
            to: what to go to; a turn is one of the innermost loop there.
            subject: the kind of mark (empty for any), the name of the variable, or the lines of
                the program's Python that are to run.
        """
        if to is To.TURN:
            subject = frozenset({self._loop_around(place)})
        if (to, subject) not in self._found:
            self._found[to, subject] = self._find(to, subject)
        places = self._found[to, subject]
        index = bisect_right(places, place) if by > 0 else bisect_left(places, place) - 1
        return places[index] if 0 <= index < len(places) else None

    def _find(self, to: To, subject: str | frozenset[int]) -> Sequence[Place]:
        match to, subject:
            case To.MARK, str(kind):
                return [
                    self.at(mark.time) for mark in self._moments.marks if kind in ("", mark.kind)
                ]
            case To.CHANGE, str(name):
                return self._of_events(self._moments.changed(name))
            case To.RUN, frozenset(lines):
                return [place for place, line in self._lines if line in lines]
            case To.TURN, frozenset(loops):
                return sorted(set(self._turns(loops)))
            case To.EVENT, _:
                events = enumerate(self._history.events)
                return self._of_events(index for index, event in events if event[0] not in _UNSEEN)
            case _:
                return self._places_of_lines

    def _of_events(self, events: Iterable[int]) -> list[Place]:
        ticks = self._history.ticks
        return [(ticks[event], event) for event in events]

    # Lines.

    @cached_property
    def _places_of_lines(self) -> list[Place]:
        return [place for place, _ in self._lines]

    @cached_property
    def _lines(self) -> list[tuple[Place, int]]:
        """The places at which lines ran, in order, each with its line."""
        ran = dict(self._without_events())
        ran.update(self._by_event())
        return sorted(ran.items())

    def _without_events(self) -> Iterator[tuple[Place, int]]:
        """The lines at moments for which the log contains nothing else.

        Turns of a loop that were alike have no events of their own.
        """
        ticks_of_events = set(self._history.ticks)
        for time, line in self._moments.ran:
            place = self.at(time)
            if place[0] not in ticks_of_events:
                yield place, line

    def _by_event(self) -> Iterator[tuple[Place, int]]:
        """The lines in the events.

        Each is at the last of its events in the moment in which it begins: then a condition has
        been decided, a variable has been written, and a long wait has begun.
        """
        history = self._history
        place, current_line = START, 0
        before: tuple[int, int] | None = None
        for index, event in enumerate(history.events):
            tick = history.ticks[index]
            if event[0] in _BETWEEN:
                before = None
                continue
            line = self._line_begun(index)
            here = (id(history.frames[index]), line)
            if line and here != before:
                if current_line:
                    yield place, current_line
                before, current_line, place = here, line, (tick, index)
            elif before and place[0] == tick:
                place = tick, index
        if current_line:
            yield place, current_line

    def _line_begun(self, index: int) -> int:
        """The line that an event belongs to; 0 if it only ends what began before."""
        history = self._history
        event = history.events[index]
        use = history.skills.get(index)
        if event[0] == Op.SKILL and use and not use.within:
            # A call that has not returned yet has no node in the log.
            is_known = use.node >= 0
            line = history.nodes[use.node].line if is_known else 0
            return line or self._moments.line_at(history.time(index))
        if event[0] not in _STEPS:
            return 0
        node = history.nodes[event[1]]
        returns = event[0] == Op.RESULT and ((use and use.result == index) or self._is_own(node))
        return 0 if returns else node.line

    def _is_own(self, node: Node) -> bool:
        return not node.base and node.name in self._own_functions

    @cached_property
    def _own_functions(self) -> frozenset[str]:
        nodes = self._history.nodes
        return frozenset(node.name for node in nodes if node.kind is Kind.FUNCTION)

    # Turns.

    def _loop_around(self, place: Place) -> int:
        """The innermost loop around the line at a place; -1 if there is none."""
        line = self.line_at(place)
        nodes = self._history.nodes
        number = next((index for index, node in enumerate(nodes) if node.line == line), -1)
        while number >= 0 and nodes[number].kind not in LOOPS:
            number = nodes[number].control
        return number

    def _turns(self, loops: frozenset[int]) -> Iterator[Place]:
        """The turns of some loops; -1 stands for all."""
        history = self._history
        for number, node in enumerate(history.nodes):
            if node.kind in LOOPS and (number in loops or -1 in loops):
                yield from self._of_events(filter(self._begins_turn, history.of_node[number]))
                yield from self._of_events(history.counts[number])
                yield from (place for place, line in self._without_events() if line == node.line)

    def _begins_turn(self, index: int) -> bool:
        op, _, value, *_ = (*self._history.events[index], None)
        return op == Op.TURN or (op == Op.CONDITION and bool(value))
