"""Why a statement was not reached: what let the program go elsewhere, or held it up."""

from collections import Counter

from learnblock.i18n import Phrase
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import LOOPS, Kind, Node
from learnblock.why.because import Because
from learnblock.why.ending import Ending
from learnblock.why.history import History, SkillUse
from learnblock.why.readings import Readings
from learnblock.why.sentences import Telling
from learnblock.why.slicing import Slices
from learnblock.why.standing import LONG, Standing
from learnblock.why.wording import movement, movement_phrase

#: So many statements are looked at that had to be reached before.
_DEEPEST = 8
#: With more sentences, what the robot did meanwhile is no news.
_ENOUGH = 2
#: A condition of a `when` that has not been asked for so long, in s, was held up.
_LONG_UNASKED = 1.0
#: The `when` that runs once.
_START = "start"


class Reaching:
    """Tells why statements did not run.

    Args:
        slices: of the run.
        readings: of the run.
        because: tells why something happened.
        telling: the answer.
        ending: tells how the run ended.
    """

    def __init__(
        self,
        slices: Slices,
        readings: Readings,
        because: Because,
        telling: Telling,
        ending: Ending,
    ) -> None:
        self._history: History = slices.history
        self._slices = slices
        self._readings = readings
        self._because = because
        self._telling = telling
        self._standing = Standing(slices)
        self._ending = ending
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

    def _events(self, number: int, since: int, until: int) -> list[int]:
        return [event for event in self._history.of_node.get(number, ()) if since <= event <= until]

    # In a condition or loop.

    def _controlled(self, number: int, node: Node, until: int, since: int) -> None:
        control = self._history.nodes[node.control]
        decisions = [
            event
            for event in self._events(node.control, since, until)
            if self._history.events[event][0] in (Op.CONDITION, Op.TURN)
        ]
        if not decisions:
            self._never_asked(number, node, until, since)
            return
        good = [event for event in decisions if self._standing.took(event, node)]
        if good and control.kind in LOOPS and self._skipped(number, decisions, good[-1], until):
            return
        if good and good[-1] == decisions[-1]:
            held_up = self._went_through if control.kind is Kind.FOR else self._held_up
            held_up(number, good[-1], until)
        else:
            self._hidden_now(node.control, decisions[-1], until)
            self._never_right(number, node, control, decisions, until)

    def _skipped(self, number: int, decisions: list[int], turn: int, until: int) -> bool:
        """Tell what left out a statement in the last turn of its loop, if something did."""
        later = (event for event in decisions if event > turn)
        end = next(later, until)
        if self._events(number, turn, end):
            return False
        jump = self._standing.jump_before(number, self._history.frames[turn], turn, end)
        if jump >= 0:
            self._held_up(number, turn, end)
        return jump >= 0

    def _never_asked(self, number: int, node: Node, until: int, since: int) -> None:
        control = self._history.nodes[node.control]
        came = self._came_to(node.control, until, since) if control.kind is Kind.FOR else -1
        turns = self._events(node.control, came, until) if came >= 0 else []
        if turns:
            self._went_through(number, turns[-1], until)
        elif came >= 0 and self._passed(node.control, came, until):
            self._telling.say("why-nothing-to-repeat", node.control, inner=self._line(number))
            for name in control.reads:
                self._because.value(name, until)
            self._because.finish()
        else:
            self.tell(node.control, until, since)

    def _came_to(self, loop: int, until: int, since: int) -> int:
        """The last event that let the program come to a loop; -1 if it has left there since."""
        node = self._history.nodes[loop]
        around = node.function if node.control < 0 else node.control
        if around < 0:
            return 0
        events = self._events(around, 0, until)
        came = [event for event in events if self._lets_come(event, node)]
        is_there = came and (came[-1] == events[-1] or came[-1] >= since)
        return came[-1] if is_there else -1

    def _lets_come(self, event: int, node: Node) -> bool:
        op = self._history.events[event][0]
        is_asked = op in (Op.CONDITION, Op.TURN)
        return op == Op.ENTER or (is_asked and self._standing.took(event, node))

    def _went_through(self, number: int, turn: int, until: int) -> None:
        """Tell that the loop around a statement was over, or what its last turn was busy with."""
        over, frame = self._standing.over(turn, until), self._history.frames[turn]
        if over < 0 or self._standing.jump_before(number, frame, turn, until) >= 0:
            self._held_up(number, turn, until)
            return
        loop = self._history.events[turn][1]
        jump = self._slices.jump_from(loop, turn, over + 1)
        if jump >= 0:
            self._telling.say("why-left-loop", self._history.events[jump][1], jump)
            self._because.tell(jump, names=())
        else:
            self._because.loop_over(turn)
            self._because.finish()
        self._held_up(loop, over, until)

    def _passed(self, loop: int, since: int, until: int) -> bool:
        """Whether the program came to what is behind a loop, between two events."""
        node = self._history.nodes[loop]
        return any(
            self._events(number, since, until)
            for number, other in enumerate(self._history.nodes)
            if other.line > node.end
            and (other.function, other.control) == (node.function, node.control)
        )

    def _never_right(
        self, number: int, node: Node, control: Node, decisions: list[int], until: int
    ) -> None:
        last = decisions[-1]
        self._telling.say(
            "why-needs",
            node.control,
            last,
            inner=self._line(number),
            needed=str(node.branch).lower(),
            facts=self._readings.summary(last),
            loop=str(control.kind in LOOPS).lower(),
            closest=self._closest(decisions),
        )
        if self._readings.is_inexact(last):
            self._telling.say_of_line("why-decimals", 0, last)
        for jump in self._slices.jumps_past(node.control, last, until):
            self._telling.say("why-left-loop", self._history.events[jump][1], jump)
            self._because.tell(jump, names=())
        self._because.condition(last)
        self._because.finish()
        self._because.around(last)
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
            self._telling.say("why-asked-once", number, decisions[0])
            if function >= 0:
                self._started(function, until)

    def _meanwhile(self, event: int) -> None:
        """What the robot did decides what its sensors see: tell it behind everything else."""
        asks = any(self._history.skills.get(part) for part in self._slices.parts(event))
        if not asks or len(self._telling) > _ENOUGH:
            return
        index = self._history.last_of(self._slices.of_base, event)
        use = self._history.skills.get(index)
        while use and use.within:
            use = use.within
        if use:
            name = movement(*self._history.events[index][3][:2])
            self._telling.say(
                "why-meanwhile", self._standing.call_of(use), index, motion=movement_phrase(name)
            )

    def _closest(self, decisions: list[int]) -> Phrase | str:
        near = self._readings.closest(decisions[-400:])
        if near is None:
            return ""
        return Phrase("why-closest", mm=round(near[0]), time=round(self._history.time(near[2]), 2))

    def _hidden_now(self, condition: int, last: int, until: int) -> None:
        """Tell if an earlier `if` was true instead, so that this condition was not even asked."""
        node = self._history.nodes[condition]
        if node.control < 0 or node.kind is not Kind.IF or node.branch:
            return
        earlier = self._events(node.control, last, until)
        if earlier and self._history.events[earlier[-1]][2] is True:
            self._hidden(condition, node.control, earlier[-1])

    def _hidden(self, condition: int, earlier: int, event: int) -> None:
        self._telling.say(
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
            for event in self._events(node.function, since, until)
            if self._history.events[event][0] == Op.ENTER
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
            self._telling.say("why-never-called", at, name=function.name, inner=self._line(number))
        for call in calls:
            before = len(self._telling)
            self.tell(call, until, since)
            if len(self._telling) == before:
                self._telling.say("why-not-called", call, name=function.name)

    def inactive(self, function: int, until: int, since: int = 0) -> None:
        """Tell why a `when` was not active."""
        node = self._history.nodes[function]
        conditions = [
            index
            for index, other in enumerate(self._history.nodes)
            if other.kind is Kind.WHEN and other.name == node.name
        ]
        for condition in conditions:
            decisions = self._events(condition, since, until)
            if not decisions:
                self._held_up(condition, since, until)
                continue
            last = decisions[-1]
            if self._ending.moment(until) - self._history.time(last) > _LONG_UNASKED:
                # Something else held it up: one statement keeps all other events waiting.
                self.busy(until)
            self._telling.say(
                "why-when-never",
                condition,
                last,
                name=node.name,
                facts=self._readings.summary(last),
                closest=self._closest(decisions),
            )
            self._because.condition(last)
            self._because.finish()
        if not conditions and node.name == _START:
            self._started(function, until)
        elif not conditions:
            self._not_switched_on(function, node, until, since)

    def _started(self, function: int, until: int) -> None:
        """Tell when `when start` ran, or what kept it from running."""
        left = [
            event
            for event in self._events(function, 0, until)
            if self._history.events[event][0] == Op.LEAVE
        ]
        if left:
            self._telling.say("why-start-over", function, left[0])
        elif not self._events(function, 0, until):
            self._held_up(function, 0, until)

    def _not_switched_on(self, function: int, node: Node, until: int, since: int) -> None:
        switched = self._history.last_of(self._history.switches.get(node.name, []), until)
        if switched >= 0 and self._history.node(switched).name == "deactivate":
            self._telling.say(
                "why-switched",
                self._history.events[switched][1],
                switched,
                name=node.name,
                on="false",
            )
            self._because.tell(switched)
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
            self._telling.say("why-only-each-other", function, until, name=node.name)
        for switch in switches:
            self._telling.say("why-activate-not-run", switch, name=node.name)
            self.tell(switch, until, since)
        if not switches:
            self._telling.say("why-never-activated", function, name=node.name)
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
            if any(self._events(function, 0, until) for function in functions):
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
            self._telling.say("why-activates-other", number, name=nodes[number].base, inner=name)

    # Elsewhere.

    def _held_up(self, number: int, since: int, until: int) -> None:
        """Tell what the program did after an event instead of coming to a statement."""
        history, node = self._history, self._history.nodes[number]
        frame = history.frames[since] if since < len(history.frames) else None
        own = frame if frame and frame.node == node.function else None
        jump = self._standing.jump_before(number, own, since, until)
        if jump >= 0:
            at = history.events[jump][1]
            self._telling.say("why-left", at, jump, inner=self._line(number))
            self._because.tell(jump, names=())
        elif not (self._ending.failed(until) or self._in_loop(number, until) or self.busy(until)):
            self._ending.stop_reason(until)

    def in_loop(self, until: int) -> bool:
        """Tell which loop kept the program from its end, if it was in one."""
        loop = self._standing.loop(-1, until)
        if loop >= 0:
            self._say_loop("why-loop-goes-on", loop, until)
        return loop >= 0

    def _in_loop(self, number: int, until: int) -> bool:
        """Tell which loop ahead of a statement the program was still in, if it was in one."""
        loop = self._standing.loop(number, until)
        if loop >= 0:
            self._say_loop("why-in-loop", loop, until, inner=self._line(number))
        return loop >= 0

    def _say_loop(self, code: str, loop: int, until: int, **values: str) -> None:
        """Tell of a loop that was still going on, and what kept it going."""
        decisions = self._events(loop, 0, until)
        last = decisions[-1]
        is_endless = self._history.nodes[loop].text == "True"
        self._telling.say(
            code,
            loop,
            last,
            endless=str(is_endless).lower(),
            time=round(self._ending.moment(until), 2),
            facts="" if is_endless else self._readings.summary(last),
            closest="" if is_endless else self._closest(decisions),
            **values,
        )
        self._because.condition(last)
        self._because.finish()
        self._no_break(loop, until)
        self.busy(until)

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
                self._telling.say("why-break-inner", number, ran, inner=self._line(inner))

    def busy(self, until: int) -> bool:
        """Tell which long statement the program was in, if it was in one."""
        use = self._standing.running(until)
        if use is None:
            return self._waited(until)
        self.say_busy(use)
        return True

    def say_busy(self, use: SkillUse) -> None:
        """Tell how long a statement kept the program from doing anything else."""
        since = round(self._history.time(use.begun), 2)
        end = round(self._standing.end(use), 2)
        call = self._standing.call_of(use)
        self._telling.say("why-busy", call, use.begun, since=since, until=end)

    def _waited(self, until: int) -> bool:
        """Tell which `wait until` the program was in, if it was in one."""
        question = self._standing.waiting(until)
        if question < 0:
            return False
        number = self._history.events[question][1]
        self._telling.say(
            "why-waiting",
            number,
            question,
            facts=self._readings.summary(question),
            closest=self._closest(self._events(number, 0, until)),
        )
        self._because.condition(question)
        self._because.finish()
        return True

    def _line(self, number: int) -> str:
        return str(self._history.line(number))
