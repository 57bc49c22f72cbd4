"""The causes of an event: the data that it used, and the conditions that let it happen."""

import re
from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import LOOPS, Kind
from learnblock.why.history import EventHistory, Frame
from learnblock.why.scopes import globals_by_line

#: Nodes before the statement or condition, which are not part of it.
_STATEMENTS = frozenset({Op.CONDITION, Op.WRITE, Op.TURN, Op.ENTER, Op.JUMP, Op.RESULT})
#: Nodes whose events may leave a loop.
_LEAVING = frozenset({Kind.BREAK, Kind.RETURN})
#: A statement such as ``x += 1``.
_CHANGES = re.compile(r"\w+\s*(?:\+|-|\*{1,2}|/{1,2}|%)=")
#: The number of events before a condition that are searched for its operands.
_FAR = 4000


class Slices:
    """The causes of the events of one run.

    Args:
        history: of the run.
    """

    def __init__(self, history: EventHistory) -> None:
        self.history = history
        self._globals = globals_by_line(history.program.python)
        self._local_names = self._find_local_names()
        self._parts: dict[int, list[int]] = {}
        #: By the identity of a list: the writes of any name for it.
        self._of_list: dict[int, list[int]] = defaultdict(list)
        #: The events that turn the camera.
        self.of_camera: list[int] = []
        #: The commands to the wheels.
        self.of_base = list(movements(history))
        #: Every `break` and `return` that ran.
        self._jumps: list[int] = []
        for index, event in enumerate(history.events):
            if event[0] == Op.WRITE and event[3]:
                self._of_list[event[3]].append(index)
            elif event[0] == Op.COMMAND and event[1] == "JointMotor:CAMERA" and event[3]:
                self.of_camera.append(index)
            elif event[0] in (Op.JUMP, Op.RETURN) and history.node(index).kind in _LEAVING:
                self._jumps.append(index)

    # Data.

    def parts(self, event: int) -> list[int]:
        """The events of the operands and calls inside a condition, an assignment or a call."""
        if event not in self._parts:
            self._parts[event] = self._find_parts(event)
        return self._parts[event]

    def _find_parts(self, event: int) -> list[int]:
        history = self.history
        number = history.number(event)
        last, frame = history.nodes[number].last, history.frames[event]
        parts: dict[int, int] = {}
        for index in range(event - 1, max(-1, event - _FAR), -1):
            earlier = history.events[index]
            if history.frames[index] is not frame or earlier[0] == Op.LEAVE:
                continue
            if earlier[0] in (Op.OPERAND, Op.RESULT) and self._is_part(earlier[1], number, last):
                if earlier[1] in parts:
                    break
                parts[earlier[1]] = index
            elif earlier[0] in _STATEMENTS:
                break
        return [parts[number] for number in sorted(parts)]

    def _is_part(self, part: int, number: int, last: int) -> bool:
        """Whether a node is in another one's expression, and not in the block after it."""
        return number < part <= last and not self.is_inside(part, number)

    def reads(self, number: int) -> tuple[str, ...]:
        """The variables that a node reads, with the one that ``+=`` changes."""
        node = self.history.nodes[number]
        changes = node.kind is Kind.ASSIGN and _CHANGES.match(node.text)
        return (*node.writes, *node.reads) if changes else node.reads

    def write_before(self, write: int, name: str) -> int:
        """The last write of a variable before a write, by another statement; -1 if none."""
        number, before = self.history.number(write), write
        while before >= 0 and self.history.number(before) == number:
            before = self.last_write(name, before - 1) if before else -1
        return before

    def last_write(self, name: str, event: int) -> int:
        """The event that gave a variable the value that it has at `event`; -1 if none did."""
        history = self.history
        frame = history.frames[event] if event >= 0 else None
        local = frame is not None and self.is_local(name, frame.node)
        writes = history.writes.get(name, [])
        for index in range(bisect_right(writes, event) - 1, -1, -1):
            write = writes[index]
            if local:
                if history.frames[write] is frame:
                    return write
            elif not self.is_local(name, history.frames[write].node):
                return write
        return -1

    def changed_through(self, write: int, event: int) -> int:
        """The last change of a list between two events, by any of its names; -1 if none."""
        write_event = self.history.events[write]
        if write_event[0] != Op.WRITE or not write_event[3]:
            return -1
        after = [
            index
            for index in self._of_list[write_event[3]]
            if write < index <= event and self.history.value(index) != write_event[2]
        ]
        return after[-1] if after else -1

    def aliased(self, write: int, name: str) -> int:
        """The write that made `name` another name of a list; -1 if none."""
        _, _, _, identity, *_ = self.history.events[write]
        for index in reversed(self._of_list[identity]):
            node = self.history.node(index)
            is_other = len(node.reads) == 1 and name not in node.reads
            if index <= write and name in node.writes and is_other:
                return index
        return -1

    def returned(self, result: int) -> int:
        """The `return` that gave the result of a call of one of the program's own functions."""
        frame = self.called(result)
        if frame is None:
            return -1
        for index in range(result, frame.entered, -1):
            if self.history.op(index) == Op.RETURN and self.history.frames[index] is frame:
                return index
        return -1

    def called(self, result: int) -> Frame | None:
        """The call of one of the program's functions with this result; None if there was none."""
        history = self.history
        if not result or history.op(result - 1) != Op.LEAVE:
            return None
        frame = history.frames[result - 1]
        return frame if history.nodes[frame.node].name == history.node(result).name else None

    def is_local(self, name: str, function: int) -> bool:
        """Whether a name in a function is a different variable than outside it."""
        return function >= 0 and name in self._local_names[function]

    def _find_local_names(self) -> dict[int, set[str]]:
        nodes = self.history.nodes
        local: dict[int, set[str]] = {
            number: set(node.parameters)
            for number, node in enumerate(nodes)
            if node.kind is Kind.FUNCTION
        }
        for node in nodes:
            if node.function >= 0:
                shared = self._globals.get(nodes[node.function].line, frozenset())
                local[node.function].update(name for name in node.writes if name not in shared)
        return local

    # Control.

    def control(self, event: int) -> int:
        """The condition, loop, call or activation that let an event happen; -1 for none."""
        use = self.history.skills.get(event)
        if use is not None and self.history.causes[event] < 0:
            use = use.outermost
            event = use.result if use.result >= 0 else use.begun
        return self.history.causes[event]

    def loops_ended(self, event: int) -> Iterator[int]:
        """The last turns of the loops before an event's statement, nearest first."""
        return self.loops_before(self.history.number(event), event)

    def loops_before(self, number: int, event: int) -> Iterator[int]:
        """The last turns, up to an event, of the loops before a statement in its block."""
        history, node = self.history, self.history.nodes[number]
        for before in range(number - 1, -1, -1):
            ahead = history.nodes[before]
            if ahead.end >= node.line or ahead.control != node.control:
                continue
            ended = history.last_of(history.of_node.get(before, []), event)
            if ended < 0 or history.frames[ended] is not history.frames[event]:
                continue
            if ahead.kind in (*LOOPS, Kind.UNTIL):
                yield ended
            elif ahead.kind is Kind.CALL:
                yield from self._loops_in(ended)

    def _loops_in(self, result: int) -> Iterator[int]:
        """The last turns of the loops in one of the program's functions, by its result."""
        history, frame = self.history, self.called(result)
        if frame is None:
            return
        for number, node in enumerate(history.nodes):
            if node.kind in LOOPS and node.control < 0 and node.function == frame.node:
                ended = history.last_of(history.of_node.get(number, []), result)
                if ended >= 0 and history.frames[ended] is frame:
                    yield ended

    def turns(self, turn: int) -> int:
        """How many turns a `for` loop had made with this one since it began; 0 if unknown."""
        history = self.history
        _, number, value, *_ = history.events[turn]
        if history.nodes[number].writes == ("_",) and isinstance(value, int):
            return value + 1
        turns = self._turns_until(turn)
        between = [history.events[index] for index in range(turns[0], turn)]
        if any(event[0] == Op.GAP for event in between):
            return 0
        more = sum(inner[2] for inner in between if inner[0] == Op.REPEATED and inner[1] == number)
        return int(more) + len(turns)

    def first_turn(self, turn: int) -> int:
        """The event that began the first of the turns of a loop that this one belongs to."""
        return self._turns_until(turn)[0]

    def _turns_until(self, turn: int) -> list[int]:
        """The turns of a `for` loop since its program came to it, up to this one."""
        history, frame = self.history, self.history.frames[turn]
        number = history.number(turn)
        turns = history.of_node[number]
        since = bisect_right(turns, self._loop_began(number, turn))
        mine = turns[since : bisect_right(turns, turn)]
        return [index for index in mine if history.frames[index] is frame]

    def _loop_began(self, number: int, event: int) -> int:
        """The event before a turn that led the program to the loop; -1 for its start."""
        history, frame = self.history, self.history.frames[event]
        outer = history.nodes[number].control
        if outer < 0:
            return frame.entered
        decisions = history.of_node.get(outer, [])
        before = reversed(decisions[: bisect_right(decisions, event)])
        return next((index for index in before if history.frames[index] is frame), -1)

    def jump_from(self, loop: int, after: int, before: int) -> int:
        """The `break` or `return` that left a loop between two events; -1 if it was none."""
        jumps, history = self._jumps, self.history
        between = jumps[bisect_right(jumps, after) : bisect_left(jumps, before)]
        leaving = (jump for jump in between[::-1] if self.is_inside(history.number(jump), loop))
        return next(leaving, -1)

    def jumps_past(self, number: int, after: int, before: int) -> Iterator[int]:
        """The jumps between two events that left the loops around a statement."""
        control = self.history.nodes[number].control if number >= 0 else -1
        while control >= 0:
            if self.history.nodes[control].kind in LOOPS:
                jump = self.jump_from(control, after, before)
                if jump >= 0:
                    yield jump
            control = self.history.nodes[control].control

    def loops_over(self, number: int, after: int, before: int) -> Iterator[int]:
        """The conditions between two events that ended the loops around a statement."""
        control = self.loop_around(number) if number >= 0 else -1
        while control >= 0:
            decision = self.history.last_of(self.history.of_node.get(control, []), before)
            if decision > after and self.history.value(decision) is False:
                yield decision
            control = self.loop_around(control)

    def loop_around(self, number: int) -> int:
        """The innermost loop around a statement; -1 if there is none."""
        control = self.history.nodes[number].control
        while control >= 0 and self.history.nodes[control].kind not in LOOPS:
            control = self.history.nodes[control].control
        return control

    def is_inside(self, node: int, outer: int) -> bool:
        """Whether a node is controlled by another one, directly or not."""
        while node >= 0:
            node = self.history.nodes[node].control
            if node == outer:
                return True
        return False


def movements(history: EventHistory) -> Iterator[int]:
    """The commands to the wheels."""
    for index, event in enumerate(history.events):
        if event[0] == Op.COMMAND and event[2] == "move" and event[1].startswith("Base"):
            args = event[3]
            if len(args) > 1 and all(isinstance(arg, int | float) for arg in args[:2]):
                yield index
