"""Where the program was at a moment: in which statement, loop or function."""

from bisect import bisect_right

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import LOOPS, Kind, Node
from learnblock.runtime.log.noting import TICK
from learnblock.why.history import CalledSkill, EventHistory, Frame
from learnblock.why.shapes import OF_NODES
from learnblock.why.slices import Slices

#: A skill that takes longer, in s, holds a program up.
LONG = 0.3
#: A question of `wait until` within this many events counts as the current one.
_RECENT = 50
_OF_STATEMENTS = frozenset({Op.CONDITION, Op.TURN, Op.RESULT, Op.WRITE, Op.CALLS, Op.REPEATED})


class Position:
    """Finds where the program of one run was.

    Args:
        slices: of the run.
    """

    def __init__(self, slices: Slices) -> None:
        self._history: EventHistory = slices.history
        self._slices = slices

    def jump_before(self, number: int, frame: Frame | None, since: int, until: int) -> int:
        """The `break`, `continue` or `return` between two events that skipped a statement.

        Args:
            number: the node of the statement.
            frame: the call of a function it would have run in; None for any.
            since: the first event.
            until: the last one.

        Returns:
            its event; -1 if there was none.
        """
        history = self._history
        for index in range(since + 1, min(until + 1, len(history.events))):
            if history.op(index) not in (Op.JUMP, Op.RETURN):
                continue
            if frame is not None and history.frames[index] is not frame:
                continue
            if self._leaves_out(history.node(index), number):
                return index
        return -1

    def _leaves_out(self, jump: Node, number: int) -> bool:
        nodes = self._history.nodes
        if jump.function != nodes[number].function or jump.line >= nodes[number].line:
            return False
        if jump.kind is Kind.RETURN:
            return True
        control = jump.control
        while control >= 0 and nodes[control].kind not in LOOPS:
            control = nodes[control].control
        is_same = control >= 0 and self._slices.is_inside(number, control)
        return jump.kind is not Kind.PASS and is_same

    def loop(self, number: int, until: int) -> int:
        """The loop, not around a statement, in which the program was; -1 if it was in none.

        Of loops in each other, the outermost that began another turn: those in it have ended.
        """
        for frame in self._stack(until):
            outermost, loop = -1, self._innermost(frame, until)
            while loop >= 0:
                node = self._history.nodes[loop]
                is_around = number == loop or self._slices.is_inside(number, loop)
                if node.kind in LOOPS and not is_around and self._is_open(loop, frame, until):
                    outermost = (
                        loop if outermost < 0 or self._turns(loop, frame, until) > 1 else outermost
                    )
                loop = node.control
            if outermost >= 0:
                return outermost
        return -1

    def over(self, turn: int, until: int) -> int:
        """The last event in a `for` loop that was over; -1 if it was still running.

        A log does not report the end of such a loop; only the program's next step shows it.

        Args:
            turn: the event that began its last turn.
            until: the event by which it has to be over.
        """
        history, last = self._history, turn
        loop, frame = history.number(turn), history.frames[turn]
        for index in range(turn + 1, min(until + 1, len(history.events))):
            if history.frames[index] is not frame:
                continue
            number = self._number_at(index)
            if history.op(index) == Op.LEAVE or not self._is_of(number, loop):
                return last
            last = index
        is_end = until >= len(history.events) - 1
        return last if is_end and history.recorded.ending.get("ended") == "finished" else -1

    def _number_at(self, index: int) -> int:
        """The node of an event of the program itself; -1 if it tells none."""
        event, use = self._history.events[index], self._history.skills.get(index)
        if event[0] == Op.SKILL and use is not None and use.within is None:
            return self.call_of(use)
        return int(event[1]) if event[0] in OF_NODES else -1

    def _is_of(self, number: int, loop: int) -> bool:
        return number < 0 or number == loop or self._slices.is_inside(number, loop)

    def _turns(self, loop: int, frame: Frame, until: int) -> int:
        events = self._history.of_node.get(loop, ())
        return sum(event <= until and self._history.frames[event] is frame for event in events)

    def _stack(self, until: int) -> list[Frame]:
        """The calls of functions at an event, the innermost last."""
        frame: Frame | None = self._history.frames[until]
        stack: list[Frame] = []
        while frame is not None:
            stack.append(frame)
            frame = frame.caller
        return stack[::-1]

    def _innermost(self, frame: Frame, until: int) -> int:
        """The loop or condition of the last statement in a call, or that itself if it is one."""
        history = self._history
        for index in range(until, -1, -1):
            event = history.events[index]
            if history.frames[index] is frame and event[0] in _OF_STATEMENTS:
                node = history.nodes[event[1]]
                return int(event[1]) if node.kind in LOOPS else node.control
        return -1

    def _is_open(self, loop: int, frame: Frame, until: int) -> bool:
        decision = self._history.last_of(self._history.of_node.get(loop, []), until)
        if decision < 0 or self._history.frames[decision] is not frame:
            return False
        return self._history.value(decision) is not False

    def running(self, until: int) -> CalledSkill | None:
        """The skill in which a program had been for long at an event; None if there was none."""
        for use in self._history.uses_back_from(until):
            if self.is_over(use) and use.ended <= until:
                return None
            took = self.end(use) - self._history.time(use.begun)
            return use if took > LONG else None
        return None

    def lasted_before(self, use: CalledSkill, call: int) -> CalledSkill | None:
        """The use of a skill that ended when another began, and took time; None if none did.

        Only one before the other in the same block: it decides when the other one begins.
        """
        nodes = self._history.nodes
        for before in self._history.uses_back_from(use.begun - 1):
            if self._history.ticks[use.begun] != self._history.ticks[max(before.ended, 0)]:
                return None
            number = self.call_of(before)
            if number < 0 or call < 0 or self.end(before) == self._history.time(before.begun):
                continue
            is_beside = nodes[number].control == nodes[call].control
            is_ahead = nodes[number].line < nodes[call].line
            return before if is_beside and is_ahead and before.frame is use.frame else None
        return None

    def is_over(self, use: CalledSkill) -> bool:
        """Whether a skill ended, and not the run before it."""
        return use.result >= 0 and use.ended >= 0

    def end(self, use: CalledSkill) -> float:
        """When a skill ended, in s; if it did not, the end of the run."""
        return self._history.time(use.ended) if self.is_over(use) else self._history.end

    def call_of(self, use: CalledSkill) -> int:
        """The node of a skill's call, also while it lasts; -1 if it is unknown."""
        if use.node >= 0:
            return use.node
        calls = [
            number
            for number, node in enumerate(self._history.nodes)
            if node.kind is Kind.CALL and node.name == use.name and node.function == use.frame.node
        ]
        likely = [number for number in calls if self._is_likely(number, use)]
        lasting = self._line_of_last(calls, use) if not self.is_over(use) else []
        return next(iter([*lasting, *likely, *calls]), -1)

    def _line_of_last(self, calls: list[int], use: CalledSkill) -> list[int]:
        """The calls in the line that a skill began in: no line has begun since, as it lasts."""
        ran = self._history.recorded.ran
        count = bisect_right(ran, (self._history.time(use.begun) + TICK, 0))
        line = ran[count - 1][1] if count else 0
        return [call for call in calls if self._is_in(line, self._history.nodes[call])]

    @staticmethod
    def _is_in(line: int, node: Node) -> bool:
        return node.line <= line <= node.end

    def _is_likely(self, number: int, use: CalledSkill) -> bool:
        """Whether the condition of a call held when a skill began."""
        history, node = self._history, self._history.nodes[number]
        if node.control < 0:
            ran = any(event < use.begun for event in history.of_node.get(number, ()))
            return node.function >= 0 or not ran
        decision = history.last_of(history.of_node.get(node.control, []), use.begun)
        return decision >= 0 and self.took(decision, node)

    def took(self, decision: int, node: Node) -> bool:
        """Whether a condition or loop had the result with which a statement in it runs."""
        event = self._history.events[decision]
        return event[0] == Op.TURN or bool(event[2] == node.branch)

    def waiting(self, until: int) -> int:
        """The last question of a `wait until` that lasts at an event; -1 if none does."""
        for index in range(until, max(-1, until - _RECENT), -1):
            if self._history.op(index) == Op.CONDITION:
                is_until = self._history.node(index).kind is Kind.UNTIL
                return index if is_until and not self._history.value(index) else -1
        return -1
