"""Why a statement was not reached: what led the program elsewhere, or held it up."""

from collections import Counter

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import LOOPS, Kind, Node
from learnblock.why.causes import Causes
from learnblock.why.history import EventHistory
from learnblock.why.inquiry import Inquiry
from learnblock.why.position import LONG
from learnblock.why.run_end import RunEnd
from learnblock.why.waits import Waits
from learnblock.why.wording import movement_phrase

#: The number of statements examined that had to be reached before.
_DEEPEST = 8
#: With more sentences, the robot's actions during that time add nothing.
_ENOUGH = 2
#: A condition of a `when` that has not been asked for this long, in s, was held up.
_LONG_UNASKED = 1.0
#: The `when` that runs once.
_START = "start"


class Omissions:
    """Tells why statements did not run.

    Args:
        inquiry: the question, and its answer so far.
        causes: tells why something happened.
        run_end: tells how the run ended.
        waits: tells what the program was busy with.
    """

    def __init__(self, inquiry: Inquiry, *, causes: Causes, run_end: RunEnd, waits: Waits) -> None:
        self._history: EventHistory = inquiry.history
        self._slices = inquiry.slices
        self._readings = inquiry.readings
        self._position = inquiry.position
        self._commands = inquiry.commands
        self._draft = inquiry.draft
        self._causes = causes
        self._run_end = run_end
        self._waits = waits
        self._seen: set[int] = set()

    def tell(self, number: int, until: int, since: int = 0) -> None:
        """Tell why a statement did not run between two events.

        Args:
            number: its node.
            until: the last event that counts.
            since: the first one.
        """
        if number in self._seen or len(self._seen) > _DEEPEST:
            return
        self._seen.add(number)
        node = self._history.nodes[number]
        if node.kind is Kind.WHEN:
            self._held_up(number, since, until)
        elif node.control >= 0:
            self._controlled(number, node, until, since)
        elif node.function >= 0:
            self._in_function(number, node, until, since)
        else:
            self._held_up(number, since, until)

    # In a condition or loop.

    def _controlled(self, number: int, node: Node, until: int, since: int) -> None:
        control = self._history.nodes[node.control]
        decisions = [
            event
            for event in self._history.events_of(node.control, since, until)
            if self._history.op(event) in (Op.CONDITION, Op.TURN)
        ]
        if not decisions:
            self._never_asked(number, node, until, since)
            return
        good = [event for event in decisions if self._position.took(event, node)]
        if good and control.kind in LOOPS and self._skipped(number, decisions, good[-1], until):
            return
        if good and good[-1] == decisions[-1]:
            held_up = self._went_through if control.kind is Kind.FOR else self._held_up
            held_up(number, good[-1], until)
        else:
            self._hidden_now(node.control, decisions[-1], until)
            self._never_right(number, node, control, decisions, until)

    def _skipped(self, number: int, decisions: list[int], turn: int, until: int) -> bool:
        """Tell what skipped a statement in the last turn of its loop, if something did."""
        later = (event for event in decisions if event > turn)
        end = next(later, until)
        if self._history.events_of(number, turn, end):
            return False
        jump = self._position.jump_before(number, self._history.frames[turn], turn, end)
        if jump >= 0:
            self._held_up(number, turn, end)
        return jump >= 0

    def _never_asked(self, number: int, node: Node, until: int, since: int) -> None:
        control = self._history.nodes[node.control]
        came = self._came_to(node.control, until, since) if control.kind is Kind.FOR else -1
        turns = self._history.events_of(node.control, came, until) if came >= 0 else []
        if turns:
            self._went_through(number, turns[-1], until)
        elif came >= 0 and self._passed(node.control, came, until):
            self._draft.say("why-nothing-to-repeat", node.control, inner=self._line(number))
            for name in control.reads:
                self._causes.value(name, until)
            self._causes.finish()
        else:
            self.tell(node.control, until, since)

    def _came_to(self, loop: int, until: int, since: int) -> int:
        """The last event that let the program come to a loop; -1 if it has left there since."""
        node = self._history.nodes[loop]
        around = node.function if node.control < 0 else node.control
        if around < 0:
            return 0
        events = self._history.events_of(around, 0, until)
        came = [event for event in events if self._lets_come(event, node)]
        is_there = came and (came[-1] == events[-1] or came[-1] >= since)
        return came[-1] if is_there else -1

    def _lets_come(self, event: int, node: Node) -> bool:
        op = self._history.op(event)
        is_asked = op in (Op.CONDITION, Op.TURN)
        return op == Op.ENTER or (is_asked and self._position.took(event, node))

    def _went_through(self, number: int, turn: int, until: int) -> None:
        """Tell that the loop around a statement was over, or what its last turn was busy with."""
        over, frame = self._position.over(turn, until), self._history.frames[turn]
        if over < 0 or self._position.jump_before(number, frame, turn, until) >= 0:
            self._held_up(number, turn, until)
            return
        loop = self._history.number(turn)
        jump = self._slices.jump_from(loop, turn, over + 1)
        if jump >= 0:
            self._draft.say("why-left-loop", self._history.number(jump), jump)
            self._causes.tell(jump, names=())
        else:
            self._causes.loop_over(turn)
            self._causes.finish()
        self._held_up(loop, over, until)

    def _passed(self, loop: int, since: int, until: int) -> bool:
        """Whether the program reached the statement after a loop, between two events."""
        node = self._history.nodes[loop]
        return any(
            self._history.events_of(number, since, until)
            for number, other in enumerate(self._history.nodes)
            if other.line > node.end
            and (other.function, other.control) == (node.function, node.control)
        )

    def _never_right(
        self, number: int, node: Node, control: Node, decisions: list[int], until: int
    ) -> None:
        last = decisions[-1]
        self._draft.say(
            "why-needs",
            node.control,
            last,
            inner=self._line(number),
            needed=str(node.branch).lower(),
            facts=self._readings.summary(last),
            loop=str(control.kind in LOOPS).lower(),
            closest=self._waits.closest(decisions),
        )
        if self._readings.is_inexact(last):
            self._draft.say_of_line("why-decimals", 0, last)
        for jump in self._slices.jumps_past(node.control, last, until):
            self._draft.say("why-left-loop", self._history.number(jump), jump)
            self._causes.tell(jump, names=())
        self._causes.condition(last)
        self._causes.finish()
        self._causes.around(last)
        self._hidden_now(node.control, last, until)
        self._asked_once(node.control, control, decisions, until)
        self._meanwhile(last)

    def _asked_once(self, number: int, control: Node, decisions: list[int], until: int) -> None:
        """Tell that a condition was asked only once, because no loop is around it."""
        history, function = self._history, control.function
        is_once = function < 0 or history.nodes[function].name == _START
        is_last = until >= len(history.events) - 1
        is_over = is_last and history.recorded.ending.get("ended") == "finished"
        now = history.end if is_last else history.time(until)
        is_long_ago = is_over or now - history.time(decisions[-1]) > LONG
        in_loop = control.kind in LOOPS or self._slices.loop_around(number) >= 0
        if is_once and not in_loop and len(decisions) == 1 and is_long_ago:
            self._draft.say("why-asked-once", number, decisions[0])
            if function >= 0:
                self._started(function, until)

    def _meanwhile(self, event: int) -> None:
        """The robot's actions decide what its sensors see: tell them after everything else."""
        asks = any(self._history.skills.get(part) for part in self._slices.parts(event))
        if not asks or len(self._draft) > _ENOUGH:
            return
        command = self._commands.last(event)
        if use := self._history.own_use(command):
            motion = movement_phrase(self._commands.movement(command))
            self._draft.say("why-meanwhile", self._position.call_of(use), command, motion=motion)

    def _hidden_now(self, condition: int, last: int, until: int) -> None:
        """Tell if an earlier `if` was true instead, so that this condition was not even asked."""
        node = self._history.nodes[condition]
        if node.control < 0 or node.kind is not Kind.IF or node.branch:
            return
        earlier = self._history.events_of(node.control, last, until)
        if earlier and self._history.value(earlier[-1]) is True:
            self._hidden(condition, node.control, earlier[-1])

    def _hidden(self, condition: int, earlier: int, event: int) -> None:
        self._draft.say(
            "why-hidden",
            earlier,
            event,
            inner=self._line(condition),
            facts=self._readings.summary(event),
        )

    # In a function or `when`.

    def _in_function(self, number: int, node: Node, until: int, since: int) -> None:
        function = self._history.nodes[node.function]
        entered = [
            event
            for event in self._history.events_of(node.function, since, until)
            if self._history.op(event) == Op.ENTER
        ]
        if entered:
            self._held_up(number, entered[-1], until)
        elif function.is_when:
            self.inactive(node.function, until, since)
        else:
            self._never_called(number, node.function, function, until, since)

    def _never_called(self, number: int, at: int, function: Node, until: int, since: int) -> None:
        calls = [
            index
            for index, node in enumerate(self._history.nodes)
            if node.kind is Kind.CALL and not node.base and node.name == function.name
        ]
        if not calls:
            self._draft.say("why-never-called", at, name=function.name, inner=self._line(number))
        for call in calls:
            before = len(self._draft)
            self.tell(call, until, since)
            if len(self._draft) == before:
                self._draft.say("why-not-called", call, name=function.name)

    def inactive(self, function: int, until: int, since: int = 0) -> None:
        """Tell why a `when` was not active."""
        node = self._history.nodes[function]
        conditions = [
            index
            for index, other in enumerate(self._history.nodes)
            if other.kind is Kind.WHEN and other.name == node.name
        ]
        for condition in conditions:
            decisions = self._history.events_of(condition, since, until)
            if not decisions:
                self._held_up(condition, since, until)
                continue
            last = decisions[-1]
            if self._run_end.moment(until) - self._history.time(last) > _LONG_UNASKED:
                # Something else held it up: one statement keeps all other events waiting.
                self._waits.busy(until)
            self._draft.say(
                "why-when-never",
                condition,
                last,
                name=node.name,
                facts=self._readings.summary(last),
                closest=self._waits.closest(decisions),
            )
            self._causes.condition(last)
            self._causes.finish()
        if not conditions and node.name == _START:
            self._started(function, until)
        elif not conditions:
            self._not_switched_on(function, node, until, since)

    def busy(self, until: int) -> None:
        """Tell what the program was busy with; without any answer, why no `when` was active."""
        if self._waits.busy(until) or len(self._draft):
            return
        # A program of events alone waits for the first of them.
        for function, node in enumerate(self._history.nodes):
            if node.kind is Kind.FUNCTION and node.is_when:
                self.inactive(function, until)

    def _started(self, function: int, until: int) -> None:
        """Tell when `when start` ran, or what kept it from running."""
        exits = [
            event
            for event in self._history.events_of(function, 0, until)
            if self._history.op(event) == Op.LEAVE
        ]
        if exits:
            self._draft.say("why-start-over", function, exits[0])
        elif not self._history.events_of(function, 0, until):
            self._held_up(function, 0, until)

    def _not_switched_on(self, function: int, node: Node, until: int, since: int) -> None:
        switched = self._history.last_of(self._history.switches.get(node.name, []), until)
        if switched >= 0 and self._history.node(switched).name == "deactivate":
            self._draft.say(
                "why-switched",
                self._history.number(switched),
                switched,
                name=node.name,
                on="false",
            )
            self._causes.tell(switched)
            return
        if switched >= 0:
            self._held_up(function, switched, until)
            return
        switches = [
            index
            for index, other in enumerate(self._history.nodes)
            if other.kind is Kind.CALL and (other.base, other.name) == (node.name, "activate")
        ]
        if switches and self._only_each_other(node.name, until):
            self._draft.say("why-only-each-other", function, until, name=node.name)
        for switch in switches:
            self._draft.say("why-activate-not-run", switch, name=node.name)
            self.tell(switch, until, since)
        if not switches:
            self._draft.say("why-never-activated", function, name=node.name)
            self._others_activated(node.name)

    def _only_each_other(self, name: str, until: int) -> bool:
        """Whether a `when` is started only by events that wait for it themselves."""
        nodes, waiting, new = self._history.nodes, set[str](), {name}
        conditional = {node.name for node in nodes if node.kind is Kind.WHEN}
        is_circle = False
        while new:
            waiting |= new
            functions = [
                node.function
                for node in nodes
                if node.kind is Kind.CALL and node.name == "activate" and node.base in new
            ]
            if any(function < 0 or not nodes[function].is_when for function in functions):
                return False
            if any(self._history.events_of(function, 0, until) for function in functions):
                return False
            names = {nodes[function].name for function in functions}
            is_circle = is_circle or name in names
            new = names - waiting
        return is_circle and _START not in waiting and waiting.isdisjoint(conditional)

    def _others_activated(self, name: str) -> None:
        """Tell what was switched on instead: perhaps the wrong `when`."""
        nodes = self._history.nodes
        others = [
            number
            for number, node in enumerate(nodes)
            if node.kind is Kind.CALL and node.name == "activate" and node.base != name
        ]
        often = Counter(nodes[number].base for number in others)
        # One of several lines that start the same is the most likely to be wrong.
        for number in sorted(others, key=lambda number: -often[nodes[number].base]):
            self._draft.say("why-activates-other", number, name=nodes[number].base, inner=name)

    # Elsewhere.

    def _held_up(self, number: int, since: int, until: int) -> None:
        """Tell what the program did after an event instead of coming to a statement."""
        history, node = self._history, self._history.nodes[number]
        frame = history.frames[since] if since < len(history.frames) else None
        own = frame if frame and frame.node == node.function else None
        jump = self._position.jump_before(number, own, since, until)
        if jump >= 0:
            at = history.number(jump)
            self._draft.say("why-left", at, jump, inner=self._line(number))
            self._causes.tell(jump, names=())
        elif not (
            self._run_end.failed(until) or self._in_loop(number, until) or self._waits.busy(until)
        ):
            self._run_end.stop_reason(until)

    def in_loop(self, until: int) -> bool:
        """Tell which loop kept the program from its end, if it was in one."""
        loop = self._position.loop(-1, until)
        if loop >= 0:
            self._say_loop("why-loop-goes-on", loop, until)
        return loop >= 0

    def _in_loop(self, number: int, until: int) -> bool:
        """Tell which loop ahead of a statement the program was still in, if it was in one."""
        loop = self._position.loop(number, until)
        if loop >= 0:
            self._say_loop("why-in-loop", loop, until, inner=self._line(number))
        return loop >= 0

    def _say_loop(self, code: str, loop: int, until: int, **values: str) -> None:
        """Tell which loop was still running, and what kept it running."""
        decisions = self._history.events_of(loop, 0, until)
        last = decisions[-1]
        is_endless = self._history.nodes[loop].text == "True"
        self._draft.say(
            code,
            loop,
            last,
            endless=str(is_endless).lower(),
            time=round(self._run_end.moment(until), 2),
            facts="" if is_endless else self._readings.summary(last),
            closest="" if is_endless else self._waits.closest(decisions),
            **values,
        )
        self._causes.condition(last)
        self._causes.finish()
        self._no_break(loop, until)
        self._waits.busy(until)

    def _no_break(self, loop: int, until: int) -> None:
        """Tell why no `break` left a loop."""
        for number, node in enumerate(self._history.nodes):
            if node.kind is not Kind.BREAK or not self._slices.is_inside(number, loop):
                continue
            inner = self._slices.loop_around(number)
            ran = self._history.last_of(self._history.of_node.get(number, []), until)
            if inner == loop or ran < 0:
                self.tell(number, until)
            else:
                self._draft.say("why-break-inner", number, ran, inner=self._line(inner))

    def _line(self, number: int) -> str:
        return str(self._history.line(number))
