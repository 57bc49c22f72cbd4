"""Why something happened: its causes, the nearest and the least obvious first."""

from collections.abc import Iterable
from heapq import heappop, heappush

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import CONDITIONS, Kind, Node
from learnblock.why.camera_aim import CameraAim
from learnblock.why.decimals import ALL, FEW
from learnblock.why.history import EventHistory, Frame
from learnblock.why.inquiry import Inquiry
from learnblock.why.unused import NotUsed
from learnblock.why.wording import value_phrase

#: How far an event's causes are from it: those with a lower cost are told first.
_DATA, _CONTROL, _RETURNED, _CALLED, _LOOP_BEFORE, _OBVIOUS = 1.0, 1.2, 0.5, 1.1, 1.6, 2.5
#: The end of a variable's changes is nearer than the value before them.
_ENDED, _BEFORE = 0.02, 1.05
#: A sensor's reading is more obvious than a computed value.
_MEASURED = 0.3
#: In place of a variable, for a loop that has none.
_LOOP = "repeat"
#: In place of a variable, where a list got a second name.
_SAME = "same"
#: In place of a variable, for one that no line reads.
_UNUSED = "unused"
#: In place of a variable, for a `for` loop that is over.
_OVER = "over"
#: The most causes that are examined for one answer.
_MOST = 40


class Causes:
    """Tells the causes of events.

    Args:
        inquiry: the question, and its answer so far.
    """

    def __init__(self, inquiry: Inquiry) -> None:
        self._history: EventHistory = inquiry.history
        self._slices = inquiry.slices
        self._readings = inquiry.readings
        self._draft = inquiry.draft
        self._position = inquiry.position
        self._not_used = NotUsed(inquiry.unused, inquiry.slices, inquiry.draft)
        self._camera_aim = CameraAim(inquiry)
        self._whens = frozenset(node.name for node in inquiry.history.nodes if node.is_when)
        self._seen: set[tuple[str, int]] = set()
        self._order = 0
        self._waiting: list[tuple[float, int, int, str]] = []

    def tell(self, event: int, *, names: Iterable[str] | None = None) -> None:
        """Tell why an event happened.

        Args:
            event: one that has a node.
            names: the variables that mattered; None for all that its node reads.
        """
        self._add_causes(event, 0.0, names)
        self.finish()

    def tell_unfinished(self, call: int, start: int) -> None:
        """Tell why a call that has not ended yet is running: only its condition shows it.

        Args:
            call: its node.
            start: the event with which its skill began.
        """
        node, history = self._history.nodes[call], self._history
        for name in node.reads:
            if name != "robot":
                self.value(name, start, _DATA)
        frame = history.frames[start]
        decision = history.last_of(history.of_node.get(node.control, []), start)
        if node.control >= 0 and decision >= 0:
            self._wait(decision, "", _CONTROL)
        elif frame.entered >= 0:
            self._wait(frame.entered, "", _CALLED)
        for index, loop in enumerate(self._slices.loops_before(call, start)):
            self._add_loop(loop, start, _LOOP_BEFORE + 0.1 * index)
        self.finish()

    def finish(self) -> None:
        """Tell what is waiting, the nearest first."""
        for _ in range(_MOST):
            if not self._waiting:
                return
            cost, _, event, name = heappop(self._waiting)
            self._tell_one(event, name, cost)
        self._waiting.clear()

    def value(self, name: str, event: int, cost: float = 0.0) -> None:
        """Tell how a variable got the value that it has at an event, when `finish` is called."""
        write = self._slices.last_write(name, event)
        if write < 0:
            return
        if self._history.op(write) == Op.TURN:
            cost += _OBVIOUS - _DATA
        elif any(part in self._history.skills for part in self._slices.parts(write)):
            cost += _MEASURED
        change = self._slices.changed_through(write, event)
        if change >= 0:
            self._wait(change, name, cost)
            alias = self._slices.aliased(change, name)
            for other in (alias, *self._aliases_of(change)):
                if other >= 0:
                    self._wait(other, _SAME, cost + 0.1)
        else:
            self._wait(write, name, cost)

    def _aliases_of(self, change: int) -> tuple[int, ...]:
        return tuple(
            self._slices.aliased(change, name) for name in self._history.node(change).writes
        )

    def stopped_writing(self, name: str, event: int, cost: float) -> None:
        """Add what kept a variable from changing further: a loop that was left, a `when`."""
        write = self._slices.last_write(name, event)
        if write < 0:
            return
        history, number = self._history, self._history.number(write)
        for jump in self._slices.jumps_past(number, write, event):
            self._wait(jump, "", cost)
        for over in self._slices.loops_over(number, write, event):
            self._wait(over, "", _ENDED)
        function = history.nodes[number].function
        when = history.nodes[function].name if function >= 0 else ""
        switched = history.last_of(history.switches.get(when, []), event)
        if switched > write and history.node(switched).name == "deactivate":
            self._wait(switched, "", cost)

    def _number(self, event: int) -> int:
        return self._history.number(event)

    def state(self, when: str, event: int, cost: float = 0.0) -> None:
        """Tell what made a `when` active or not, when `finish` is called."""
        decision = self._history.last_of(self._conditions_of(when), event)
        switched = self._history.last_of(self._history.switches.get(when, []), event)
        if max(decision, switched) >= 0:
            self._wait(max(decision, switched), when, cost)

    def condition(self, event: int, cost: float = 0.0) -> None:
        """Add what made a condition true or not, without the condition itself."""
        self._add_data(event, cost, None)

    def around(self, event: int) -> None:
        """Tell what let a condition be asked: the one around it."""
        cause = self._slices.control(event)
        if cause >= 0 and self._history.op(cause) == Op.CONDITION:
            self._wait(cause, "", 0.0)
            self.finish()

    def _conditions_of(self, when: str) -> list[int]:
        history = self._history
        return [
            event
            for number, node in enumerate(history.nodes)
            if node.kind is Kind.WHEN and node.name == when
            for event in history.of_node.get(number, ())
        ]

    def also(self, event: int, cost: float) -> None:
        """Add another condition or turn of a loop, to be told when `finish` is called."""
        if self._history.op(event) == Op.TURN:
            self._wait_for_turn(event, cost - _OBVIOUS)
        else:
            self._wait(event, "", cost)

    def loop_over(self, turn: int, cost: float = 0.0) -> None:
        """Add that a `for` loop was over, to be told when `finish` is called.

        Args:
            turn: the event that began its last turn.
            cost: how far that is from the subject of the question.
        """
        self._wait(turn, _OVER, cost)

    def _wait(self, event: int, name: str, cost: float) -> None:
        if event >= 0:
            self._order += 1
            heappush(self._waiting, (cost, self._order, event, name))

    def _tell_one(self, event: int, name: str, cost: float) -> None:
        if (name, event) in self._seen:
            return
        self._seen.add((name, event))
        op = self._history.op(event)
        if op == Op.COMMAND:
            self._camera_aim.tell(event)
        elif name == _UNUSED:
            self._not_used.tell_never_read(event)
        elif name == _OVER:
            self._tell_over(event, cost)
        else:
            self._tell_cause(event, op, name, cost)

    def _tell_cause(self, event: int, op: int, name: str, cost: float) -> None:
        node = self._history.node(event)
        if op == Op.CONDITION:
            self._tell_condition(event, node, name, cost)
        elif op == Op.ENTER:
            self._tell_entered(event, node, name, cost)
        elif op in (Op.WRITE, Op.TURN):
            self._tell_written(event, node, name, cost)
        elif op == Op.RETURN:
            self._tell_returned(event, node, cost)
        elif op == Op.JUMP:
            self._say("why-left-loop", event)
            self._wait(self._slices.control(event), "", cost + 0.05)
        elif op == Op.CALLS:
            self._add_causes(event, cost, ())
        elif op == Op.RESULT and node.name in ("activate", "deactivate"):
            self._say(
                "why-switched", event, name=node.base, on=str(node.name == "activate").lower()
            )
            self._add_causes(event, cost, ())
        else:
            self._add_causes(event, cost, None)

    def _tell_condition(self, event: int, node: Node, name: str, cost: float) -> None:
        if _is_obvious(node):
            self._add_control(event, cost)
            return
        true = str(self._history.value(event)).lower()
        facts = self._readings.summary(event)
        if node.kind is Kind.WHEN:
            self._say("why-when-was", event, name=node.name, active=true, facts=facts)
        elif node.kind is Kind.WHILE and true == "false":
            self._say("why-loop-over", event, facts=facts)
        else:
            self._say("why-condition-was", event, true=true, facts=facts, inner=name)
        if self._readings.is_inexact(event):
            self._draft.say_of_line("why-decimals", 0, event)
        self._add_causes(event, cost, None)

    def _tell_entered(self, event: int, node: Node, name: str, cost: float) -> None:
        if name in node.parameters:
            value = self._history.value(event)[node.parameters.index(name)]
            self._tell_given(event, node, name, value, cost)
            return
        cause = self._slices.control(event)
        if cause < 0:
            return
        if node.is_when:
            self._wait(cause, node.name, cost)
            self._not_deactivated(cause, event, node)
        else:
            if not self._draft.has("why-given", self._history.line(self._number(cause))):
                # The code that passed an argument also made the call.
                self._say("why-called", cause, name=node.name)
            self._add_causes(cause, cost + 0.1, ())

    def _not_deactivated(self, cause: int, event: int, node: Node) -> None:
        """A statement that could have switched a `when` off is a cause as well."""
        if self._history.op(cause) == Op.CONDITION:
            return
        for number, other in enumerate(self._history.nodes):
            if other.kind is not Kind.CALL or (other.base, other.name) != (node.name, "deactivate"):
                continue
            decisions = self._history.of_node.get(other.control, ()) if other.control >= 0 else ()
            last = self._history.last_of([*decisions], event)
            if last > cause and number not in self._history.of_node:
                self._say(
                    "why-needs",
                    last,
                    inner=str(self._history.line(number)),
                    needed=str(other.branch).lower(),
                    facts=self._readings.summary(last),
                    closest="",
                )

    def _tell_given(self, event: int, node: Node, name: str, value: object, cost: float) -> None:
        call = self._slices.control(event)
        if call < 0:
            return
        self._say("why-given", call, name=name, function=node.name, value=value_phrase(value))
        reads = [
            name_read for name_read in self._history.node(call).reads if name_read != node.name
        ]
        self._add_causes(call, cost, reads)

    def _tell_written(self, event: int, node: Node, name: str, cost: float) -> None:
        # If exactness matters there, it matters here too.
        count = ALL if self._draft.has("why-decimals", 0) else FEW
        value = value_phrase(self._history.value(event), count)
        if name in node.writes:
            self._not_used.tell_not_changed(name, event)
            self._say("why-set", event, name=name, value=value)
            self._add_unused(event, name, cost)
        elif name == _SAME:
            self._say("why-same-list", event, name=node.writes[0])
        elif name == _LOOP:
            self._say("why-turn", event, count=self._turn(event))
        elif self._history.op(event) == Op.WRITE and name:
            self._say("why-set-through", event, name=name, other=node.writes[0], value=value)
        self._add_causes(event, cost, None)

    def _add_unused(self, event: int, name: str, cost: float) -> None:
        """Add a variable that was set by mistake instead of this one: a name that is never read."""
        if sum(name in node.writes for node in self._history.nodes) == 1:
            for write in self._not_used.instead_of(event, name):
                self._wait(write, _UNUSED, cost + _DATA)

    def _tell_returned(self, event: int, node: Node, cost: float) -> None:
        function = self._history.nodes[node.function].name if node.function >= 0 else ""
        value = value_phrase(self._history.value(event))
        self._say("why-returned", event, name=function, value=value)
        self._add_causes(event, cost, None)

    def _say(self, code: str, event: int, **values: object) -> None:
        self._draft.say(code, self._history.number(event), event, **values)  # type: ignore[arg-type] # values of a phrase

    # The causes of one event.

    def _add_causes(self, event: int, cost: float, names: Iterable[str] | None) -> None:
        self._add_data(event, cost, names)
        self._add_control(event, cost)
        for index, loop in enumerate(self._slices.loops_ended(event)):
            self._add_loop(loop, event, cost + _LOOP_BEFORE + 0.1 * index)

    def _add_data(self, event: int, cost: float, names: Iterable[str] | None) -> None:
        node = self._history.node(event)
        # What an assignment read is older than what it wrote.
        is_write = self._history.op(event) in (Op.WRITE, Op.TURN)
        reads = self._slices.reads(self._history.number(event))
        for name in reads if names is None else names:
            if name in self._whens or name == "robot":
                continue
            if is_write and name in node.writes:
                before = self._slices.write_before(event, name)
                self._wait(before, name, cost + _BEFORE) if before >= 0 else None
            else:
                self.value(name, event - is_write, cost + _DATA)
        self._wait(self._camera_aim.turned(event), "camera", cost + _DATA)
        for part in self._slices.parts(event):
            inner = self._history.node(part)
            if inner.kind is Kind.STATE and inner.name == "active":
                self.state(inner.base, part, cost + _DATA)
            elif inner.kind is Kind.CALL and not inner.base:
                self._add_returned(part, cost)

    def returned(self, result: int) -> None:
        """Add the result of one of the program's functions, to be told when `finish` is called."""
        self._add_returned(result, 0.0)

    def _add_returned(self, result: int, cost: float) -> None:
        frame = self._slices.called(result)
        if frame is None:
            return
        returned = self._slices.returned(result)
        if returned >= 0:
            self._wait(returned, "", cost + _RETURNED)
        elif self._history.value(result) is None and self._not_used.is_used(
            self._history.number(result)
        ):
            self._draft.say(
                "why-no-return", frame.node, result, name=self._history.nodes[frame.node].name
            )
            self._last_of(frame, result)

    def _last_of(self, frame: Frame, result: int) -> None:
        """Tell what a function did last instead of returning a value."""
        history = self._history
        for index in range(result - 1, frame.entered, -1):
            if history.frames[index] is not frame:
                continue
            if history.op(index) == Op.CONDITION:
                # It decided that nothing else was done.
                self._wait(index, "", _RETURNED)
                return
            if history.op(index) in (Op.RESULT, Op.WRITE):
                name = history.nodes[frame.node].name
                self._draft.say("why-last-line", history.number(index), index, name=name)
                return

    def _add_control(self, event: int, cost: float) -> None:
        cause = self._slices.control(event)
        if cause < 0 or cause == event:
            return
        kind = self._history.op(cause)
        if kind == Op.CONDITION:
            self._wait(cause, "", cost + _CONTROL)
        elif kind == Op.TURN:
            self._wait_for_turn(cause, cost)
        else:
            self._wait(cause, "", cost + _CALLED)

    def _wait_for_turn(self, turn: int, cost: float) -> None:
        node = self._history.node(turn)
        name = node.writes[0] if node.writes else ""
        self._wait(turn, name if name != "_" else _LOOP, cost + _OBVIOUS)

    def _turn(self, event: int) -> int:
        """The number of a turn of ``repeat``, from 1."""
        value = self._history.value(event)
        return value + 1 if isinstance(value, int) else 1

    def _add_loop(self, loop: int, event: int, cost: float) -> None:
        number = self._history.number(loop)
        jump = self._slices.jump_from(number, loop, event)
        if jump >= 0:
            self._wait(jump, "", cost)
        elif self._history.op(loop) == Op.CONDITION:
            self._wait(loop, "", cost)
        elif self._took_time(loop):
            self.loop_over(loop, cost)

    def _took_time(self, turn: int) -> bool:
        """Whether the turns of a `for` loop decided when the program reached the next statement."""
        first = self._history.time(self._slices.first_turn(turn))
        return self._history.time(self._over(turn)) > first

    def _over(self, turn: int) -> int:
        """The last event in a `for` loop that is over, by the event of its last turn."""
        over = self._position.over(turn, len(self._history.events) - 1)
        return over if over >= 0 else turn

    def _tell_over(self, turn: int, cost: float) -> None:
        number, count = self._history.number(turn), self._slices.turns(turn)
        self._draft.say("why-turns-over", number, self._over(turn), count=count)
        for name in self._history.nodes[number].reads:
            self.value(name, turn - 1, cost + _DATA)


def _is_obvious(node: Node) -> bool:
    return node.kind in CONDITIONS and node.text in ("True", "1")
