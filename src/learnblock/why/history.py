"""What a program did, in order, and why."""

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.runtime.log.events import Event, Op
from learnblock.runtime.log.nodes import Kind, Node
from learnblock.runtime.log.noting import TICK
from learnblock.why.recorded import Recorded
from learnblock.why.scopes import locals_in
from learnblock.why.shapes import OF_NODES, identities, require_event

#: Methods of a `when`.
_SWITCHES = frozenset({"activate", "deactivate"})


@dataclass(eq=False)
class Frame:
    """A call of one of the program's functions, or the program itself.

    Args:
        node: the function's node; -1 for the program itself.
        entered: the event that began it; -1 for the program, and where the log has a gap.
        caller: the frame that called it; None for the program itself, and for a `when`.
    """

    node: int
    entered: int = -1
    caller: "Frame | None" = None
    left: int = -1
    #: By condition or loop, the event of its last evaluation in this call.
    evaluated: dict[int, int] = field(default_factory=dict)


@dataclass(eq=False)
class CalledSkill:
    """A call of a skill.

    Args:
        name: the skill.
        args: its arguments, those given by name behind the others.
        begun: the event with which it begins.
        within: the skill that called it; None if the program did.
        frame: the call of a function that it was called in.
    """

    name: str
    args: list[Any]
    begun: int
    within: "CalledSkill | None"
    frame: Frame
    #: The event with which it ended; -1 while it lasts.
    ended: int = -1
    #: The node of its call in the program; -1 if the program has not called it itself.
    node: int = -1
    #: The event with its result; -1 while it lasts.
    result: int = -1
    commands: list[int] = field(default_factory=list)
    readings: list[int] = field(default_factory=list)
    #: The devices that it found missing, such as ``JointMotor:CAMERA``.
    missing: list[str] = field(default_factory=list)

    @property
    def outermost(self) -> "CalledSkill":
        """The skill that the program used itself, in which this one ran."""
        use = self
        while use.within is not None:
            use = use.within
        return use


class EventHistory:
    """The events of a log, each with its time, its frame and its cause.

    Args:
        recorded: the log.

    Raises:
        LearnBlockError: its events make no sense.
    """

    def __init__(self, recorded: Recorded) -> None:
        self.recorded = recorded
        self.program = recorded.program
        self.nodes: tuple[Node, ...] = recorded.nodes
        self.events: list[Event] = []
        #: Of each event, in ticks.
        self.ticks: list[int] = []
        self.frames: list[Frame] = []
        #: Of each event: the condition, loop or call that let it happen; -1 for the program itself.
        self.causes: list[int] = []
        #: The use of a skill that an event belongs to, by event.
        self.skills: dict[int, CalledSkill] = {}
        self.uses: list[CalledSkill] = []
        #: By node, its events; by name, the writes of a variable, and the calls of a function.
        self.of_node: dict[int, list[int]] = defaultdict(list)
        self.writes: dict[str, list[int]] = defaultdict(list)
        #: By `when`: the calls that switched it on or off.
        self.switches: dict[str, list[int]] = defaultdict(list)
        self.gaps: list[int] = []
        #: By loop, the events that count turns that were alike, up to the beginning of the next.
        self.counts: dict[int, list[int]] = defaultdict(list)
        #: By name, the events that report the value or the end of a variable, but not why.
        self.tellings: dict[str, list[int]] = defaultdict(list)
        #: By the identity of a list, the events that report its content.
        self.contents: dict[int, list[int]] = defaultdict(list)
        self._locals: dict[int, frozenset[str]] = {}
        #: How often each event happened: more than once in turns of a loop that were alike.
        self.times: list[int] = []
        try:
            _Reading(self).read(recorded)
        except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
            # Its events do not fit its program: another one may have written it.
            raise LearnBlockError("log-not-a-log") from error

    @cached_property
    def own_uses(self) -> tuple[CalledSkill, ...]:
        """The skills that the program used itself, in order."""
        return tuple(use for use in self.uses if use.within is None)

    @cached_property
    def _own_begun(self) -> list[int]:
        return [use.begun for use in self.own_uses]

    def own_use(self, event: int) -> CalledSkill | None:
        """The skill that the program used itself, by an event in it; None if there is none."""
        use = self.skills.get(event)
        return use.outermost if use else None

    def uses_back_from(self, event: int) -> Iterator[CalledSkill]:
        """The skills that the program used itself up to an event, the last one first."""
        return reversed(self.own_uses[: bisect_right(self._own_begun, event)])

    @property
    def end(self) -> float:
        """The time of the last event, in s."""
        lines = self.recorded.lines
        last = lines[-1].get("t", 0.0) if lines else 0.0
        return max(last, self.time(len(self.events) - 1) if self.events else 0.0)

    def time(self, event: int) -> float:
        """The time of an event in s."""
        return round(self.ticks[event] * TICK, 3)

    def op(self, event: int) -> int:
        """The kind of an event, an `Op`."""
        return self.events[event][0]  # type: ignore[no-any-return] # checked when it was read

    def number(self, event: int) -> int:
        """The number of the node of an event that has one."""
        return self.events[event][1]  # type: ignore[no-any-return] # as above

    def value(self, event: int) -> Any:
        """The value in an event, such as whether a condition was true, or a reading."""
        return self.events[event][2]

    def device(self, event: int) -> str:
        """The device of a command or reading, such as ``Base:ROBOT``."""
        return self.events[event][1]  # type: ignore[no-any-return] # as above

    def function(self, command: int) -> str:
        """The function of the device that a command calls."""
        return self.events[command][2]  # type: ignore[no-any-return] # as above

    def arguments(self, command: int) -> Sequence[Any]:
        """The arguments of a command."""
        return self.events[command][3]  # type: ignore[no-any-return] # as above

    def node(self, event: int) -> Node:
        """The node of an event that has one."""
        return self.nodes[self.number(event)]

    def line(self, node: int) -> int:
        """The author's line of a node."""
        return self.program.written_line(self.nodes[node].line)

    def at(self, time: float) -> int:
        """The last event up to a time in s; -1 if there is none."""
        return bisect_right(self.ticks, round(time / TICK)) - 1

    def locals_of(self, function: int) -> frozenset[str]:
        """The variables that a function has for itself: it writes them, and they are not global."""
        if function not in self._locals:
            self._locals[function] = locals_in(self.program.python, self.nodes[function].line)
        return self._locals[function]

    def events_of(self, node: int, since: int, until: int) -> list[int]:
        """The events of a node between two events."""
        return [event for event in self.of_node.get(node, ()) if since <= event <= until]

    def turn_before(self, repeated: int) -> range:
        """The events of the turn of a loop that `Op.REPEATED` says has been repeated."""
        turns = self.of_node[self.number(repeated)]
        before = bisect_right(turns, repeated)
        first = turns[before - 2] + 1 if before > 1 else repeated
        return range(first, repeated)

    def last_of(self, events: list[int], before: int) -> int:
        """The last of some events up to the event `before`; -1 if there is none."""
        index = bisect_right(events, before)
        return events[index - 1] if index else -1


class _Reading:
    """One pass over the events of a log.

    The log may lack events: those that were too frequent at one moment, and those that were
    dropped because it was full. So the frames are those that the events themselves name.
    """

    def __init__(self, history: EventHistory) -> None:
        self._history = history
        self._stack = [Frame(-1)]
        self._ticks = 0
        self._use: CalledSkill | None = None
        self._ended: CalledSkill | None = None
        self._call = -1

    def read(self, recorded: Recorded) -> None:
        for batch in recorded.batches:
            for event in batch:
                if event[0] == Op.AT:
                    self._ticks = int(event[1])
                elif event[0] == Op.PASSED:
                    self._ticks += event[1]
                else:
                    self._take(event)

    def _take(self, event: Event) -> None:
        history, op = self._history, event[0]
        require_event(event, len(history.nodes))
        if op == Op.REPEATED:
            self._ticks += event[3]
        if op in OF_NODES and op not in (Op.ENTER, Op.LEAVE):
            self._find_frame(history.nodes[event[1]].function)
        index = len(history.events)
        history.events.append(event)
        history.ticks.append(self._ticks)
        history.frames.append(self._stack[-1])
        history.causes.append(self._cause(event))
        history.times.append(1)
        if op in OF_NODES:
            history.of_node[event[1]].append(index)
        taker = _TAKERS.get(op)
        if taker:
            taker(self, index, event)

    def _find_frame(self, function: int) -> None:
        """Enter the call of a function, if the log does not contain the way to it."""
        stack = self._stack
        if stack[-1].node == function:
            return
        if any(frame.node == function for frame in stack):
            while stack[-1].node != function:
                stack.pop()
        else:
            stack.append(Frame(function, caller=stack[-1]))

    def _cause(self, event: Event) -> int:
        frame = self._stack[-1]
        if event[0] not in OF_NODES or event[0] in (Op.ENTER, Op.LEAVE):
            return -1
        control = self._history.nodes[event[1]].control
        return frame.entered if control < 0 else frame.evaluated.get(control, frame.entered)

    def _condition(self, index: int, event: Event) -> None:
        self._stack[-1].evaluated[event[1]] = index

    def _write(self, index: int, event: Event) -> None:
        for name in self._history.nodes[event[1]].writes:
            self._history.writes[name].append(index)
        self._list(index, event)

    def _list(self, index: int, event: Event) -> None:
        for identity in identities(event):
            if identity:
                self._history.contents[identity].append(index)

    def _gone(self, index: int, event: Event) -> None:
        for name in self._history.nodes[event[1]].writes:
            self._history.tellings[name].append(index)

    def _contents(self, index: int, event: Event) -> None:
        self._history.contents[event[1]].append(index)

    def _variables(self, index: int, event: Event) -> None:
        """Process a call's variables, which also show that it continues at this depth."""
        _, depth, line, pairs, _, is_innermost = event
        frame = self._frame_at(depth, line, index)
        if is_innermost:
            del self._stack[depth + 1 :]
        self._history.frames[index] = frame
        for name, _ in pairs:
            self._history.tellings[name].append(index)
        self._list(index, event)

    def _frame_at(self, depth: int, line: int, index: int) -> Frame:
        stack = self._stack
        if depth >= len(stack) or self._line(stack[depth]) != line:
            del stack[depth:]
            stack.append(Frame(self._function_in(line), index, stack[-1] if stack else None))
        return stack[-1] if depth >= len(stack) else stack[depth]

    def _line(self, frame: Frame) -> int:
        """The line where Python says that the function of a frame begins."""
        return 0 if frame.node < 0 else self._history.nodes[frame.node].first

    def _function_in(self, line: int) -> int:
        nodes = enumerate(self._history.nodes)
        return next(
            (n for n, node in nodes if node.kind is Kind.FUNCTION and node.first == line), -1
        )

    def _turn(self, index: int, event: Event) -> None:
        self._condition(index, event)
        self._write(index, event)

    def _calls(self, index: int, _: Event) -> None:
        self._call = index

    def _enter(self, index: int, event: Event) -> None:
        history, node = self._history, self._history.nodes[event[1]]
        if node.is_when:
            self._stack = self._stack[:1]
            cause = self._switched_on(node)
            frame = Frame(event[1], index)
        else:
            cause, self._call = self._call, -1
            frame = Frame(event[1], index, self._stack[-1])
        history.causes[index] = cause
        history.frames[index] = frame
        self._stack.append(frame)
        for name in node.parameters:
            history.writes[name].append(index)
        self._list(index, event)

    def _switched_on(self, when: Node) -> int:
        """The event that made a `when` active: its condition, or a call."""
        history = self._history
        conditions = [
            event
            for number, node in enumerate(history.nodes)
            if node.kind is Kind.WHEN and node.name == when.name
            for event in history.of_node[number][-1:]
        ]
        on = [
            event for event in history.switches[when.name] if history.node(event).name == "activate"
        ]
        return conditions[-1] if conditions else on[-1] if on else -1

    def _leave(self, index: int, event: Event) -> None:
        if any(frame.node == event[1] for frame in self._stack[1:]):
            while self._stack[-1].node != event[1]:
                self._stack.pop()
            frame = self._stack.pop()
            frame.left = index
            self._history.frames[index] = frame

    def _skill(self, index: int, event: Event) -> None:
        use = CalledSkill(event[1], list(event[2]), index, self._use, self._stack[-1])
        self._history.skills[index] = use
        self._history.uses.append(use)
        self._use = use

    def _skill_end(self, index: int, event: Event) -> None:
        use = self._use
        while use and use.name != event[1]:
            use = use.within
        if use:
            use.ended = index
            self._history.skills[index] = use
            self._use = use.within
            self._ended = use if use.within is None else self._ended

    def _command(self, index: int, _: Event) -> None:
        if self._use:
            self._use.commands.append(index)
            self._history.skills[index] = self._use

    def _reading(self, index: int, _: Event) -> None:
        if self._use:
            self._use.readings.append(index)
            self._history.skills[index] = self._use

    def _missing(self, index: int, event: Event) -> None:
        if self._use:
            self._use.missing.append(event[2])
            self._history.skills[index] = self._use

    def _result(self, index: int, event: Event) -> None:
        history, node = self._history, self._history.nodes[event[1]]
        use, self._ended = self._ended, None
        if use and use.name == node.name and use.node < 0:
            use.node, use.result = event[1], index
            history.skills[index] = use
            history.causes[use.begun] = history.causes[index]
        else:
            self._ended = use
        if node.name in _SWITCHES:
            history.switches[node.base].append(index)

    def _repeated(self, index: int, event: Event) -> None:
        """Count the events of a turn once more for each turn that was like it."""
        history = self._history
        history.counts[event[1]].append(index)
        for event_of_turn in history.turn_before(index):
            history.times[event_of_turn] *= 1 + event[2]

    def _gap(self, index: int, _: Event) -> None:
        self._history.gaps.append(index)


_TAKERS = {
    Op.CONDITION: _Reading._condition,  # noqa: SLF001 - a table of its own methods
    Op.WRITE: _Reading._write,  # noqa: SLF001
    Op.TURN: _Reading._turn,  # noqa: SLF001
    Op.CALLS: _Reading._calls,  # noqa: SLF001
    Op.ENTER: _Reading._enter,  # noqa: SLF001
    Op.LEAVE: _Reading._leave,  # noqa: SLF001
    Op.SKILL: _Reading._skill,  # noqa: SLF001
    Op.SKILL_END: _Reading._skill_end,  # noqa: SLF001
    Op.COMMAND: _Reading._command,  # noqa: SLF001
    Op.READING: _Reading._reading,  # noqa: SLF001
    Op.MISSING: _Reading._missing,  # noqa: SLF001
    Op.RESULT: _Reading._result,  # noqa: SLF001
    Op.REPEATED: _Reading._repeated,  # noqa: SLF001
    Op.GAP: _Reading._gap,  # noqa: SLF001
    Op.GONE: _Reading._gone,  # noqa: SLF001
    Op.CONTENTS: _Reading._contents,  # noqa: SLF001
    Op.VARIABLES: _Reading._variables,  # noqa: SLF001
}
