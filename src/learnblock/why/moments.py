"""A moment of a run: the place in the program, its variables, and what had happened so far."""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any

from learnblock.runtime.log.events import Event, Op
from learnblock.runtime.log.nodes import Kind
from learnblock.runtime.log.noting import TICK
from learnblock.runtime.remote import RemoteRobot
from learnblock.why.history import EventHistory, Frame
from learnblock.why.recorded import Recorded
from learnblock.why.shapes import identities

#: Kinds of marks, by the name of their line in the log.
_MARKS = {"goal": "goal", "bump": "bump", "print": "print", "send": "message", "placed": "placed"}
#: The snapshot of the robot, which isn't shown as a variable.
_ROBOT = {"is": RemoteRobot.__name__}


@dataclass(frozen=True, slots=True)
class Mark:
    """Something that stands out in a run.

    Args:
        time: in s.
        kind: ``goal``, ``bump``, ``print``, ``message``, ``placed``, ``emotion``, ``when`` or
            ``error``.
        text: the goal, the thing, the text, the emotion or the name.
    """

    time: float
    kind: str
    text: str


@dataclass(frozen=True, slots=True)
class RunMoment:
    """A moment of a run.

    Args:
        time: in s.
        line: the line of the program's Python that ran; 0 before the first.
        shared: the program's variables, by name, as text.
        local: those of the function that ran.
        whens: of each `when`, whether it was active, and since when, in s.
        stack: the functions that ran, outermost first.
        printed: the number of characters printed so far.
    """

    time: float
    line: int
    shared: dict[str, str]
    local: dict[str, str]
    whens: dict[str, tuple[bool, float]]
    stack: tuple[str, ...]
    printed: int


class Moments:
    """All moments of a run.

    Args:
        history: the run.
    """

    def __init__(self, history: EventHistory) -> None:
        self._history = history
        lines = history.recorded.lines
        #: When a line of the program's Python ran, in s, and which one.
        self.ran = history.recorded.ran
        self._ran_at = [time for time, _ in self.ran]
        printed = [(line["t"], line["print"]) for line in lines if "print" in line]
        self._printed_at = [time for time, _ in printed]
        #: The number of characters printed, by the number of prints.
        self._characters = [0, *accumulate(len(text) + 1 for _, text in printed)]
        #: Variables that only hold the robot, which aren't shown.
        self.robots = frozenset(
            name
            for name, writes in history.writes.items()
            if all(written(history, write, name) == _ROBOT for write in writes)
        )
        self._shared: dict[str, list[int]] = {}
        self._by_name: dict[str, _Tellings] = {}
        self.marks = tuple(sorted(_marks(history), key=lambda mark: mark.time))

    def at(self, time: float, event: int | None = None) -> RunMoment:
        """The moment at a time in s.

        Args:
            time: the time.
            event: the last event of that time that has happened; None if everything has.
        """
        history = self._history
        last = history.at(time)
        place = self._place(time) if event is None else _Place(event)
        event = last if event is None else event
        frame = self._frame_after(place.event)
        return RunMoment(
            time,
            self.line_at(time),
            dict(self._variables(place, None)),
            dict(self._variables(place, frame)) if frame else {},
            self._whens(time, event),
            tuple(_names(history, frame)),
            self._printed(time, event, last),
        )

    def line_at(self, time: float) -> int:
        """The line of the program's Python that ran last, up to a time in s; 0 for none."""
        index = bisect_right(self._ran_at, time)
        return self.ran[index - 1][1] if index else 0

    def text_at(self, time: float) -> str:
        """The author's text of the line that ran at a time."""
        program = self._history.program
        return program.quote(program.written_line(self.at(time).line))

    def changed(self, name: str) -> tuple[int, ...]:
        """The events that gave a variable another value than it had."""
        changes: list[int] = []
        values: dict[int, Any] = {}
        for event in self._history.writes.get(name, ()):
            scope, value = self.scope(event, name), written(self._history, event, name)
            if scope not in values or values[scope] != value:
                changes.append(event)
            values[scope] = value
        return tuple(changes)

    def last_write(self, name: str, event: int, entered: int) -> int:
        """The last event up to `event` that wrote a variable; -1 if there is none.

        Args:
            name: the variable.
            event: the event.
            entered: the event that began the call whose variable it is; -1 for the program's.
        """
        if entered < 0:
            return self._history.last_of(self._shared_writes(name), event)
        writes = self._history.writes.get(name, [])
        for index in range(bisect_right(writes, event) - 1, -1, -1):
            if writes[index] < entered:
                break
            if self.scope(writes[index], name) == entered:
                return writes[index]
        return -1

    def _shared_writes(self, name: str) -> list[int]:
        """The writes of a variable of the program itself."""
        if name not in self._shared:
            writes = self._history.writes.get(name, ())
            self._shared[name] = [event for event in writes if self.scope(event, name) < 0]
        return self._shared[name]

    def _printed(self, time: float, event: int, last: int) -> int:
        """The number of characters printed up to an event; `last` is the last one of its time."""
        printed = bisect_right(self._printed_at, time)
        if event < last:
            history = self._history
            first = bisect_left(history.ticks, history.ticks[last])
            before = bisect_left(self._printed_at, time)
            now = sum(_prints(history, index) for index in range(first, event + 1))
            printed = min(before + now, printed)
        return self._characters[printed]

    def _place(self, time: float) -> "_Place":
        """Where the program was: in a turn that was only counted, in the one that it was like."""
        history = self._history
        ticks, turns = round(time / TICK), []
        event = bisect_right(history.ticks, ticks) - 1
        while 0 <= event < len(history.events) - 1:
            repeated = event + 1
            op, _, count, lasting, *_ = (*history.events[repeated], 0, 0, 0)
            length = lasting // count if op == Op.REPEATED and count else 0
            turn = history.turn_before(repeated) if length else range(0)
            ended = history.ticks[event]
            if not turn or not 0 <= ticks - ended < lasting:
                break
            turns.append(turn)
            ticks = ended - length + (ticks - ended) % length
            event = max(turn.start - 1, bisect_right(history.ticks, ticks, hi=turn.stop) - 1)
        return _Place(event, tuple(turns))

    def _frame_after(self, event: int) -> Frame | None:
        """The call of a function that continues after an event; None for the program itself."""
        if event < 0:
            return None
        frame = self._history.frames[event]
        if self._history.op(event) == Op.LEAVE:
            return _function(frame.caller)
        return _function(frame)

    def _variables(self, place: "_Place", frame: Frame | None) -> Iterator[tuple[str, str]]:
        """The variables of the program, or of the call of a function."""
        history = self._history
        for name in {**history.writes, **history.tellings}:
            last = next(self._tellings(place, frame, name), -1)
            if name in self.robots or last < 0 or history.op(last) == Op.GONE:
                continue
            if (value := self._held(place, last, name)) != _ROBOT:
                yield name, shown(value)

    def _tellings(self, place: "_Place", frame: Frame | None, name: str) -> Iterator[int]:
        """The events with a variable of a call, the last one first."""
        tellings = self._tellings_of(name)
        if frame is None:
            return place.latest(tellings.shared)
        return (event for event in place.latest(tellings.all) if self._owner(event, name) is frame)

    def _tellings_of(self, name: str) -> "_Tellings":
        """The events with a variable, in order."""
        if name not in self._by_name:
            history = self._history
            tellings = sorted((*history.writes.get(name, ()), *history.tellings.get(name, ())))
            shared = [event for event in tellings if self._owner(event, name) is None]
            self._by_name[name] = _Tellings(tellings, shared)
        return self._by_name[name]

    def scope(self, write: int, name: str) -> int:
        """The call whose variable is written: the event that began it; -1 for the program's."""
        frame = self._owner(write, name)
        return frame.entered if frame else -1

    def _owner(self, event: int, name: str) -> Frame | None:
        """The call that owns the variable in an event; None for the program's."""
        history = self._history
        frame = _function(history.frames[event])
        if frame is None or history.op(event) == Op.VARIABLES:
            return frame
        is_own = name in history.nodes[frame.node].parameters
        return frame if is_own or name in history.locals_of(frame.node) else None

    def _held(self, place: "_Place", event: int, name: str) -> Any:
        """The value of a variable in an event; a list may have changed since."""
        identity = _identity(self._history, event, name)
        if not identity or identity not in self._history.contents:
            return written(self._history, event, name)
        last = next(place.latest(self._history.contents[identity]), event)
        return _contents(self._history.events[last], identity)

    def _whens(self, time: float, event: int) -> dict[str, tuple[bool, float]]:
        states: dict[str, tuple[bool, float]] = {}
        for node in self._history.nodes:
            if node.kind is Kind.FUNCTION and node.is_when:
                states[node.name] = self._when(node.name, time, event)
        return states

    def _when(self, name: str, time: float, event: int) -> tuple[bool, float]:
        active, since = False, 0.0
        for switch in switches(self._history, name):
            if switch[0] > event:
                break
            if switch[1] and not active:
                since = self._history.time(switch[0])
            active = switch[1]
        return active, round(time - since, 3) if active else 0.0


@dataclass(frozen=True, slots=True)
class _Tellings:
    """The events with the values of a variable, in order.

    Args:
        all: those of every variable of this name.
        shared: those of the program's.
    """

    all: list[int]
    shared: list[int]


@dataclass(frozen=True, slots=True)
class _Place:
    """Where a program was at one moment.

    Args:
        event: the last event that had happened.
        turns: the turns of loops that are repeated at that moment, outermost first: of each, the
            turn that was kept, in which `event` is.
    """

    event: int
    turns: tuple[range, ...] = ()

    def latest(self, events: Sequence[int]) -> Iterator[int]:
        """Those of some events that had happened by then, the last one first."""
        until = self.event
        for turn in reversed(self.turns):
            first, end = bisect_left(events, turn.start), bisect_left(events, turn.stop)
            now = bisect_right(events, until)
            yield from reversed(events[first:now])
            # The turn before was the same one to its end.
            yield from reversed(events[now:end])
            until = turn.start - 1
        yield from reversed(events[: bisect_right(events, until)])


def switches(history: EventHistory, when: str) -> Sequence[tuple[int, bool]]:
    """The events that made a `when` active or inactive, in order."""
    by_call = [(event, history.node(event).name == "activate") for event in history.switches[when]]
    by_condition = [
        (event, bool(history.value(event)))
        for number, node in enumerate(history.nodes)
        if node.kind is Kind.WHEN and node.name == when
        for event in history.of_node[number]
    ]
    return sorted([*by_call, *by_condition])


def written(history: EventHistory, event: int, name: str) -> Any:
    """The value that an event gave to a variable."""
    if history.op(event) == Op.VARIABLES:
        _, _, _, pairs, *_ = history.events[event]
        return dict(pairs).get(name)
    op, number, value, *_ = history.events[event]
    node = history.nodes[number]
    names = node.parameters if op == Op.ENTER else node.writes
    if op != Op.ENTER and len(names) == 1:
        return value
    # Several at once: their values in a list.
    index = names.index(name)
    return value[index] if isinstance(value, list | tuple) and index < len(value) else None


def _identity(history: EventHistory, event: int, name: str) -> int:
    """The identity of the list in a variable, by an event; 0 if it holds none."""
    event_told, of_each = history.events[event], identities(history.events[event])
    if not of_each:
        return 0
    if event_told[0] == Op.VARIABLES:
        names: Sequence[str] = [variable for variable, _ in event_told[3]]
    else:
        node = history.nodes[event_told[1]]
        names = node.parameters if event_told[0] == Op.ENTER else node.writes
    return of_each[names.index(name)] if len(names) == len(of_each) else 0


def _contents(telling: Event, identity: int) -> Any:
    """The content of a list, by an event."""
    if telling[0] == Op.CONTENTS:
        return telling[2]
    index = list(identities(telling)).index(identity)
    if telling[0] == Op.VARIABLES:
        return telling[3][index][1]
    return (
        telling[2]
        if len(identities(telling)) == 1 and telling[0] != Op.ENTER
        else telling[2][index]
    )


def _function(frame: Frame | None) -> Frame | None:
    """A call of a function; None for the program itself."""
    return frame if frame and frame.node >= 0 else None


def shown(value: Any) -> str:
    """A snapshot as Python would show it."""
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(shown, value))}]"
    match value:
        case {"more": number}:
            return f"... {number} more"
        case {"is": kind}:
            return f"<{kind}>"
        case {"pairs": pairs}:
            return f"{{{', '.join(f'{shown(key)}: {shown(item)}' for key, item in pairs)}}}"
    return repr(value)


def _prints(history: EventHistory, event: int) -> bool:
    """Whether the program has printed something at an event."""
    op, *values = history.events[event]
    return op == Op.RESULT and history.nodes[values[0]].name == "print"


def _names(history: EventHistory, frame: Frame | None) -> list[str]:
    names: list[str] = []
    while frame is not None and frame.node >= 0:
        names.insert(0, history.nodes[frame.node].name)
        frame = frame.caller
    return names


def _marks(history: EventHistory) -> Iterator[Mark]:
    recorded: Recorded = history.recorded
    yield from marks_in(recorded.lines)
    for node in history.nodes:
        if node.kind is Kind.FUNCTION and node.is_when:
            yield from _activations(history, node.name)
    if error := recorded.ending.get("error"):
        yield Mark(recorded.ending.get("time", history.end), "error", str(error.get("text", "")))


def marks_in(lines: Iterable[Mapping[str, Any]]) -> Iterator[Mark]:
    """What stands out in some lines of the log."""
    for line in lines:
        for name, kind in _MARKS.items():
            if name in line:
                text = f"{line[name]}: {line['state']}" if name == "goal" else str(line[name])
                yield Mark(line["t"], kind, "" if name == "placed" else text)
        if line.get("do") == "show_emotion":
            yield Mark(line["t"], "emotion", str(line["args"][0]))


def _activations(history: EventHistory, when: str) -> Iterator[Mark]:
    active = False
    for event, on in switches(history, when):
        if on and not active:
            yield Mark(history.time(event), "when", when)
        active = on
