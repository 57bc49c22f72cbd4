"""What the robot did or did not do: the statements that caused it, or would have."""

from collections.abc import Iterable
from typing import Any

from learnblock.language.check.robots import need_phrase
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind
from learnblock.why.causes import Causes
from learnblock.why.history import CalledSkill, EventHistory
from learnblock.why.inquiry import Inquiry
from learnblock.why.omissions import Omissions
from learnblock.why.position import LONG
from learnblock.why.steering import may_do, movement_of
from learnblock.why.waits import Waits
from learnblock.why.wording import (
    FORWARD,
    STAND,
    movement,
    movement_phrase,
    skill_phrase,
    thing_phrase,
)

#: The time in a question may be this many seconds off: people round it.
ABOUT = 0.06
#: A statement that ran this long before a moment, in s, counts as run at it.
LONG_AGO = 1.0
#: A command that another one replaces within this many seconds had no effect.
_SOON = 0.15
#: A pause of this many seconds may be too long.
_LONG_PAUSE = 5.0
#: With more sentences than this, earlier events are too far away.
_FEW = 2


class Actions:
    """Tells why statements ran, why not, and why they had no effect.

    Args:
        inquiry: the question, and its answer so far.
        causes: tells why something happened.
        waits: tells what the program was busy with.
        omissions: tells why a statement was not reached.
    """

    def __init__(
        self, inquiry: Inquiry, *, causes: Causes, waits: Waits, omissions: Omissions
    ) -> None:
        self._history: EventHistory = inquiry.history
        self._slices = inquiry.slices
        self._position = inquiry.position
        self._commands = inquiry.commands
        self._draft = inquiry.draft
        self._start = inquiry.since
        self._causes = causes
        self._waits = waits
        self._omissions = omissions
        #: The first event of the time in question.
        self.first = 0 if self._start is None else max(0, self._history.at(self._start - ABOUT) + 1)

    def is_moment(self, time: float | None) -> bool:
        """Whether a question is about one moment, rather than a time or the whole run."""
        return time is not None and self._start is None

    def in_span(self, event: int) -> bool:
        """Whether what an event began happened in the time in question, at least in part."""
        use = self._history.skills.get(event)
        return event >= self.first or (use is not None and not 0 <= use.ended < self.first)

    def not_happened(self, until: int, time: float | None) -> None:
        """Tell that the subject of the question had not happened."""
        at = round(self._history.end if time is None else min(time, self._history.end), 2)
        if self._start is None:
            self._draft.say_of_line("why-not-happened", 0, until, time=at)
        else:
            since = round(self._start, 2)
            self._draft.say_of_line("why-not-between", 0, until, since=since, time=at)

    def since(self, time: float | None) -> int:
        """The first event that counts for a question about a moment or a time."""
        if self._start is not None:
            return self.first
        if time is None or time >= self._history.end:
            return 0
        # The last event may be long before the moment: it began a wait.
        return max(0, self._history.at(max(0.0, time - LONG_AGO)))

    def results(self, numbers: Iterable[int], until: int) -> list[int]:
        """The runs of some calls up to an event, in order, including one that still lasts."""
        history = self._history
        ran = {
            event
            for number in numbers
            for event in history.of_node.get(number, ())
            if event <= until and history.op(event) != Op.CALLS
        }
        ran |= {
            use.begun
            for use in history.uses
            if use.within is None
            and use.begun <= until
            and not 0 <= use.result <= until
            and self._position.call_of(use) in numbers
        }
        return sorted(ran)

    # It did.

    def moved(self, command: int, until: int) -> None:
        """Tell why the wheels got such a command."""
        use = self.say_moved(command)
        if use is None:
            return
        call = self._position.call_of(use)
        if use.name == "slow_down":
            self._slowed(use)
        if self._position.waiting(until) > command:
            # There was no other command since, because the program still waits for something.
            self._waits.busy(until)
        self._long_pause(command, until)
        self._tell_causes_of(use, call)
        self._after(use, call)
        self._not_stopped(use, until)
        if self._position.running(until) not in (None, use):
            # There was no other command since, because the program did something else.
            self._waits.busy(until)

    def say_moved(self, command: int) -> CalledSkill | None:
        """Tell which line gave the wheels such a command; return its skill, None if none did."""
        use, command = self._history.own_use(command), self._commands.first_alike(command)
        motion = movement_phrase(self._commands.movement(command))
        if use is None:
            self._draft.say_of_line("why-moved-alone", 0, command, motion=motion)
        else:
            self._draft.say("why-moved", self._position.call_of(use), command, motion=motion)
        return use

    def is_movement(self, command: int, name: str) -> bool:
        """Whether a command makes a movement; a question need not tell a turn from a curve."""
        name_made = self._commands.movement(command)
        return name in (name_made, name_made.replace("curve", "spin")) or (
            not name and "-" in name_made
        )

    def lasting(self, command: int, until: int) -> None:
        """Tell what the program was busy with since a command, for the longest time."""
        history = self._history
        uses = [
            use
            for use in history.uses_back_from(until)
            if command < use.begun and self._position.end(use) - history.time(use.begun) > LONG
        ]
        if uses:
            longest = max(uses, key=lambda use: self._position.end(use) - history.time(use.begun))
            self._waits.say_busy(longest)
        elif not self._waits.busy(until):
            self._omissions.in_loop(until)

    def _tell_causes_of(self, use: CalledSkill, call: int) -> None:
        if use.result >= 0:
            self._causes.tell(use.result)
        elif call >= 0:
            self._causes.tell_unfinished(call, use.begun)

    def _not_stopped(self, use: CalledSkill, until: int) -> None:
        """Tell why no line has stopped the `when` that makes the robot do this."""
        history, node = self._history, use.frame.node
        when = history.nodes[node].name if node >= 0 and history.nodes[node].is_when else ""
        started = history.last_of(history.switches.get(when, []), until)
        if started < 0 or history.node(started).name != "activate":
            return
        for number, call in enumerate(history.nodes):
            if call.kind is Kind.CALL and (call.base, call.name) == (when, "deactivate"):
                self._omissions.tell(number, until, started)

    def _long_pause(self, command: int, until: int) -> None:
        """Tell that one pause made a movement last long; a robot may well stand still for long."""
        if self._commands.movement(command) == STAND:
            return
        for pause in self._history.uses_back_from(until):
            if pause.begun < command:
                return
            lasted = self._position.end(pause) - self._history.time(pause.begun)
            if pause.name == "sleep" and lasted > _LONG_PAUSE:
                self._waits.say_busy(pause)
                return

    def never_stopped(self, function: int) -> None:
        """Tell that no line stops a `when` that a line has started, if that is so."""
        history = self._history
        if function < 0 or not history.nodes[function].is_when:
            return
        name = history.nodes[function].name
        calls = {
            node.name for node in history.nodes if node.base == name and node.kind is Kind.CALL
        }
        if "activate" in calls and "deactivate" not in calls:
            self._draft.say("why-never-stopped", function, name=name)

    def _after(self, use: CalledSkill, call: int) -> None:
        """Tell how long the statement before lasted: it determines the time."""
        before = self._position.lasted_before(use, call)
        if before is not None and len(self._draft) <= _FEW:
            self._after_pause(before)

    def _after_pause(self, before: CalledSkill) -> None:
        since = round(self._history.time(before.begun), 2)
        number = self._position.call_of(before)
        self._draft.say("why-after", number, before.ended, since=since)

    def _slowed(self, use: CalledSkill) -> None:
        """`slow_down` only slows what another statement began."""
        before = [
            index
            for index in self._commands.all
            if index < use.begun
            and (skill := self._history.own_use(index))
            and skill.name != "slow_down"
        ]
        if before:
            self.moved(before[-1], before[-1])

    def ran(self, event: int, until: int) -> None:
        """Tell why a statement ran."""
        use = self._history.own_use(event) if self._history.op(event) == Op.SKILL else None
        if use is not None:
            call = self._position.call_of(use)
            self._draft.say("why-ran", call, event)
            self._tell_causes_of(use, call)
            return
        start = self._history.skills[event].begun if event in self._history.skills else event
        self._draft.say("why-ran", self._history.number(event), start)
        self._causes.tell(event)
        self.never_stopped(self._history.frames[event].node)
        if until:
            self.without_effect(event)

    # It did not.

    def not_moved(self, name: str, until: int, time: float | None) -> None:
        """Tell why the robot did not make a movement."""
        fitting = [
            number
            for number, node in enumerate(self._history.nodes)
            if node.kind is Kind.CALL and node.base == "robot" and may_do(node, name)
        ]
        self.not_done(fitting, "", until, time, movement_name=name)

    def not_moving(self, until: int, time: float | None) -> None:
        """Tell why no line had commanded the robot to move."""
        moving = [
            number
            for number, node in enumerate(self._history.nodes)
            if node.kind is Kind.CALL and movement_of(node) not in (None, STAND)
        ]
        at = self._history.end if time is None else min(time, self._history.end)
        possible = str(bool(moving)).lower()
        self._draft.say_of_line("why-never-told", 0, until, time=round(at, 2), possible=possible)
        if moving:
            self.not_done(moving, "", until, time)
        else:
            self._waits.busy(until)

    def not_done(
        self,
        numbers: list[int],
        skill: str,
        until: int,
        time: float | None,
        movement_name: str = "",
    ) -> None:
        """Tell why none of some statements ran, or why it had no effect."""
        if not numbers:
            self._not_in_program(skill, movement_name, until)
            if movement_name and self._commands.last(until) < 0:
                self.not_moving(until, time)
            return
        since = self.since(time)
        ran = {number: self.results([number], until) for number in numbers}
        recent = [number for number in numbers if ran[number] and ran[number][-1] >= since]
        for number in recent:
            self._did(number, ran[number][-1], until)
        for number in self.nearest_first(
            [number for number in numbers if number not in recent], until
        ):
            if ran[number]:
                self._did_before(number, ran[number][-1], until)
            else:
                self._omissions.tell(number, until)

    def _did_before(self, number: int, last: int, until: int) -> None:
        """Tell when a statement last ran, long ago, and why it did not run again."""
        if self.without_effect(last):
            return
        if self._start is not None:
            # An earlier run does not answer the question.
            self._omissions.tell(number, until, self.first)
            return
        self._say_it_did(number, last, until)
        overriding = self._overridden(last, until)
        if overriding:
            self._tell_overriding(last, overriding, with_causes=False)
        self._omissions.tell(number, until, last + 1)
        if overriding:
            self._tell_overriding(last, overriding)

    def _not_in_program(self, skill: str, name: str, until: int) -> None:
        if name:
            self._draft.say_of_line("why-no-such-movement", 0, until, motion=movement_phrase(name))
        elif skill:
            self._draft.say_of_line("why-no-such-skill", 0, until, skill=skill_phrase(skill, []))
        last = self._commands.last(until)
        if last >= 0:
            self.moved(last, until)
        self._waits.busy(until)
        if name == STAND:
            # Another movement would have done as well.
            self.not_prevented(until)

    def nearest_first(self, numbers: list[int], until: int) -> list[int]:
        """Sort statements: those with the condition that was asked last come first."""

        def last_decision(number: int) -> int:
            control = self._history.nodes[number].control
            events = self._history.of_node.get(control, []) if control >= 0 else []
            return -self._history.last_of(events, until)

        return sorted(numbers, key=last_decision)

    def _did(self, number: int, event: int, until: int) -> None:
        if self.without_effect(event):
            return
        self._say_it_did(number, event, until)
        overriding = self._overridden(event, until)
        if overriding:
            self._tell_overriding(event, overriding)
        if self._history.op(event) != Op.SKILL:
            self._causes.tell(event)

    def _say_it_did(self, number: int, event: int, until: int) -> None:
        """Tell when a statement ran: from its beginning, if it took time."""
        history, use = self._history, self._history.skills.get(event)
        if use is None or self._position.end(use) - history.time(use.begun) < _SOON:
            self._draft.say("why-it-did", number, event, lasted="no")
            return
        lasted = "over" if self._position.end(use) <= history.time(until) + _SOON else "still"
        end = round(self._position.end(use), 2)
        self._draft.say("why-it-did", number, use.begun, lasted=lasted, until=end)

    def without_effect(self, event: int) -> bool:
        """Tell if a skill found its device missing."""
        use = self._history.skills.get(event)
        if use is None or not use.missing:
            return False
        device = need_phrase(use.missing[0])
        self._draft.say(
            "why-no-effect",
            self._position.call_of(use),
            event,
            device=device,
            skill=skill_phrase(use.name, use.args),
        )
        return True

    def _overridden(self, event: int, until: int) -> int:
        """The command that replaced those of a skill; 0 if none did."""
        history = self._history
        use = history.skills.get(event)
        mine = [index for index in use.commands if history.function(index) != "pose"] if use else []
        if not use or not mine:
            return 0
        first = history.events[mine[-1]]
        # A command of the same moment replaced it as well, but no later one did.
        last = history.at(history.time(until))
        for index in range(mine[-1] + 1, last + 1):
            other = history.events[index]
            if other[0] != Op.COMMAND or other[1] != first[1] or other[2] != first[2]:
                continue
            if other[3] != first[3] and self._history.own_use(index) is not use:
                return index
        return 0

    def _tell_overriding(self, event: int, command: int, *, with_causes: bool = True) -> None:
        history = self._history
        use = self._history.own_use(command)
        if use is None:
            return
        delay = history.time(command) - history.time(event)
        other = history.events[command]
        values: dict[str, Any] = {"seconds": round(delay, 2)}
        if other[1].startswith("Base") and other[2] == "move":
            values["motion"] = movement_phrase(movement(*other[3][:2]))
        else:
            values["motion"] = skill_phrase(use.name, use.args)
        code = "why-overridden-soon" if delay <= _SOON else "why-overridden-later"
        self._draft.say(code, self._position.call_of(use), command, **values)
        pause = next(self._history.uses_back_from(use.begun - 1), None)
        if pause is not None and self._is_pause(pause, use) and pause.begun > event:
            self._after_pause(pause)
        if with_causes:
            self._tell_causes_of(use, self._position.call_of(use))

    def _is_pause(self, before: CalledSkill, use: CalledSkill) -> bool:
        """Whether a wait decided when another skill began: in a loop ahead, its turns did, too."""
        here, there = (self._position.call_of(skill) for skill in (before, use))
        if before.name != "sleep" or min(here, there) < 0:
            return False
        return self._history.nodes[here].control == self._history.nodes[there].control

    # Other things.

    def bumped(self, line: dict[str, Any], until: int) -> None:
        """Tell the robot's command when it bumped into something."""
        event = max(0, self._history.at(line.get("t", 0.0)))
        thing = str(line["bump"])
        last = self._commands.last(event)
        at = round(line.get("t", 0.0), 2)
        self._draft.say_of_line("why-bumped", 0, event, name=thing_phrase(thing), time=at)
        if last >= 0:
            self.moved(last, until)
        self._waits.busy(event)
        self.not_prevented(event)

    def not_prevented(self, event: int) -> None:
        """Tell why there was no command to stop or to go elsewhere."""
        others = [
            number
            for number, node in enumerate(self._history.nodes)
            if node.kind is Kind.CALL
            and node.base == "robot"
            and (node.control >= 0 or node.function >= 0 or not self.results([number], event))
            and movement_of(node) not in (None, FORWARD)
        ]
        recent = self.since(self._history.time(event))
        for number in self.nearest_first(others, event):
            ran = self.results([number], event)
            if not ran or ran[-1] < recent:
                self._omissions.tell(number, event, recent)

    def not_written_again(self, name: str, until: int) -> None:
        """Tell what kept a variable from changing further: a loop that was left, a condition."""
        write = self._slices.last_write(name, until)
        for number, node in enumerate(self._history.nodes):
            if name not in node.writes or node.kind is Kind.FUNCTION:
                continue
            decision = self._history.last_of(self._history.of_node.get(node.control, []), until)
            if node.control >= 0 and decision > write:
                self._omissions.tell(number, until, write + 1)
