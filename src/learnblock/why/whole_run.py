"""Answers about a run as a whole: why nothing happened, why it did not end, why it was so slow."""

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterator

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind, Node
from learnblock.why.actions import Actions
from learnblock.why.causes import Causes
from learnblock.why.history import CalledSkill, EventHistory
from learnblock.why.inquiry import Inquiry
from learnblock.why.omissions import Omissions
from learnblock.why.run_end import RunEnd
from learnblock.why.steering import movement_of
from learnblock.why.waits import Waits
from learnblock.why.wording import STAND, blocks

#: Skills that wait, or only begin or end something.
_QUIET = frozenset({"sleep", "wait_until", "activate", "deactivate", "Robot", "run", "when"})
_QUIET_STARTS = ("reset_", "look_", "when")
#: A floor that is darker than this, in percent, counts as missing.
_NO_FLOOR = 5
#: Pauses that take a smaller part of a run do not make it slow.
_MUCH = 0.2
#: The actions of this many seconds before an event led to it.
_BEFORE = 0.03
_LINE_NEEDS = ("black-line", "red-line", "blue-line", "ground-line")


class WholeRun:
    """Tells about a run as a whole.

    Args:
        inquiry: the question, and its answer so far.
        causes: tells why something happened.
        run_end: tells how the run ended.
        waits: tells what the program was busy with.
        omissions: tells why a statement was not reached.
        actions: tells why statements ran.
    """

    def __init__(
        self,
        inquiry: Inquiry,
        *,
        causes: Causes,
        run_end: RunEnd,
        waits: Waits,
        omissions: Omissions,
        actions: Actions,
    ) -> None:
        self._history: EventHistory = inquiry.history
        self._readings = inquiry.readings
        self._position = inquiry.position
        self._commands = inquiry.commands
        self._draft = inquiry.draft
        self._causes = causes
        self._run_end = run_end
        self._waits = waits
        self._omissions = omissions
        self._actions = actions

    # Nothing, and no end.

    def nothing(self, first: int, until: int) -> bool:
        """Tell why nothing happened between two events; False if something did."""
        acting = [number for number, node in enumerate(self._history.nodes) if _acts(node)]
        if not acting:
            self._draft.say_of_line("why-no-acts", 0, until)
            return True
        ran = {number: self._actions.results([number], until) for number in acting}
        recent = [number for number in acting if ran[number] and ran[number][-1] >= first]
        for number in recent:
            self._actions.without_effect(ran[number][-1])
        if self._waits.busy(until):
            self._told_to(until)
        for number in self._actions.nearest_first([n for n in acting if n not in recent], until):
            self._omissions.tell(number, until, first)
        return bool(len(self._draft))

    def _told_to(self, until: int) -> None:
        last = self._commands.last(until)
        if last >= 0:
            self._actions.say_moved(last)

    def not_end(self, until: int) -> bool:
        """Tell what kept a program from ending; False if it did end."""
        if self._history.recorded.ending.get("ended") in ("finished", "error"):
            return False
        if not self._omissions.in_loop(until) and not self._waits.busy(until):
            self._of_events(until)
        return True

    def came_to_end(self, last: int) -> None:
        """Tell what led a finished program to its end: the loops before its last line."""
        if self._history.recorded.ending.get("ended") != "finished":
            return
        for event in range(last, -1, -1):
            op, frame = self._history.op(event), self._history.frames[event]
            if op in (Op.RESULT, Op.CONDITION, Op.WRITE, Op.TURN) and frame.node < 0:
                self._causes.tell(event, names=())
                return

    def say_commands(self, first: int, until: int) -> None:
        """Tell the commands to the wheels between two events."""
        for command, _ in self._in_force(first, until):
            if self._commands.is_main(command):
                self._actions.say_moved(command)

    def _of_events(self, until: int) -> None:
        """A program with events runs as long as one of them can run."""
        history = self._history
        whens = [number for number, node in enumerate(history.nodes) if node.is_when]
        ran = [(history.last_of(history.of_node.get(when, []), until), when) for when in whens]
        last, number = max(ran, default=(-1, -1))
        if last >= 0:
            self._draft.say("why-when-goes-on", number, last, name=history.nodes[number].name)
            self._causes.tell(last, names=())
            self._actions.never_stopped(number)
        self._run_end.stop_reason(until)

    # How fast, and for how long.

    def speed(self, which: str, first: int, until: int) -> None:
        """Tell which line decided how fast the robot was."""
        spent = self._time_by_command(first, until)
        advancing = [
            command
            for command in spent
            if self._commands.movement(command) != STAND and self._advance(command)
        ]
        paused = self._longest_pause(first, until) if which == "slow" else None
        is_pause_first = (
            paused is not None and paused[1] > sum(spent[command] for command in advancing) / 2
        )
        if paused is not None and is_pause_first:
            self._say_pause(*paused)
        if advancing:
            fastest = max(advancing, key=self._advance)
            longest = max(advancing, key=lambda command: spent[command])
            self._actions.moved(longest if which == "slow" else fastest, until)
        if paused is not None:
            self._say_pause(*paused)

    def _say_pause(self, number: int, seconds: float, event: int) -> None:
        self._draft.say("why-paused", number, event, seconds=round(seconds, 2))

    def _longest_pause(self, first: int, until: int) -> tuple[int, float, int] | None:
        """The call that waited longest in all, for how long, in s, and its last event."""
        took: dict[int, float] = defaultdict(float)
        last: dict[int, int] = {}
        for use in self._history.own_uses:
            if use.name == "sleep" and first <= use.begun <= until and self._stands(use.begun):
                number = self._position.call_of(use)
                took[number] += self._lasted(use, until)
                last[number] = use.begun
        number = max(took, key=lambda call: took[call], default=-1)
        if number < 0 or took[number] < _MUCH * self._history.time(until):
            return None
        return number, took[number], last[number]

    def _stands(self, event: int) -> bool:
        last = self._commands.last(event)
        return last < 0 or self._commands.movement(last) == STAND

    def _lasted(self, use: CalledSkill, until: int) -> float:
        times = self._history.times[use.begun]
        end = min(self._position.end(use), max(self._run_end.moment(until), 0.0))
        return max(0.0, end - self._history.time(use.begun)) * times

    def _advance(self, command: int) -> float:
        return abs(self._commands.speeds(command)[0])

    def _time_by_command(self, first: int, until: int) -> dict[int, float]:
        """By the first command of its line, how long commands of that line were in force, in s."""
        history, spent = self._history, dict[int, float]()
        of_line: dict[int, int] = {}
        for command, lasted in self._in_force(first, until):
            use = self._history.own_use(command)
            number = self._position.call_of(use) if use else -1
            first_of_line = of_line.setdefault(number, command)
            spent[first_of_line] = spent.get(first_of_line, 0.0) + lasted * history.times[command]
        return spent

    def _in_force(self, first: int, until: int) -> Iterator[tuple[int, float]]:
        """The commands to the wheels that were in force between two events, and for how long."""
        history, commands = self._history, self._commands.all
        start = max(0, bisect_right(commands, first) - 1)
        mine = commands[start : bisect_right(commands, until)]
        for index, command in enumerate(mine):
            end = history.time(mine[index + 1]) if index + 1 < len(mine) else history.end
            yield command, max(0.0, end - max(history.time(command), history.time(first)))

    def long(self, name: str, first: int, until: int) -> bool:
        """Tell what kept the robot in a movement for long; False if it never moved so."""
        fitting = [
            (lasted, command)
            for command, lasted in self._in_force(first, until)
            if self._actions.is_movement(command, name)
        ]
        if not fitting:
            return False
        lasted, command = max(fitting)
        end = min(until, self._history.at(self._history.time(command) + lasted - _BEFORE))
        self._actions.say_moved(command)
        self._actions.lasting(command, end)
        self._actions.moved(command, command)
        return True

    # The line, and the floor.

    def lost(self, first: int, until: int) -> None:
        """Tell what the robot did when it last saw the line before it did not for longest."""
        answers = self._line_asked(until)
        sights = [event for event in answers if self._history.value(event) not in (None, False)]
        if not answers or not sights:
            code = "why-line-never-seen" if answers else "why-line-not-asked"
            number = self._history.number(answers[-1]) if answers else -1
            self._draft.say(code, number, answers[-1] if answers else until)
            self._told_by_last(until)
            return
        last = self._before_longest_gap(
            [event for event in sights if event >= first] or sights, until
        )
        self._draft.say("why-line-seen", self._history.number(last), last)
        for command in self._after_line(last, until):
            self._actions.moved(command, command)

    def _line_asked(self, until: int) -> list[int]:
        """The answers to questions for a line."""
        of_node = self._history.of_node
        events = (
            event
            for number, node in enumerate(self._history.nodes)
            if self._asks_for_line(node)
            for event in of_node.get(number, ())
        )
        is_result = self._history.events
        return sorted(
            event for event in events if event <= until and is_result[event][0] == Op.RESULT
        )

    def _before_longest_gap(self, sights: list[int], until: int) -> int:
        """The sight of the line before the longest time without one."""
        history = self._history
        ends = [*(history.time(event) for event in sights[1:]), self._run_end.moment(until)]
        gaps = [end - history.time(event) for event, end in zip(sights, ends, strict=True)]
        return sights[max(range(len(sights)), key=lambda index: gaps[index])]

    def _after_line(self, sight: int, until: int) -> list[int]:
        """What the sight of the line made the robot do, and what it did when it was gone."""
        commands = self._commands.all
        after = bisect_right(commands, sight)
        later = [
            command
            for command in commands[after : bisect_right(commands, until)]
            if self._commands.is_main(command)
        ]
        if not later:
            return commands[-1:]
        other = next(
            (
                command
                for command in later
                if self._commands.speeds(command) != self._commands.speeds(later[0])
            ),
            -1,
        )
        return [later[0], *([other] if other >= 0 else [])]

    def _asks_for_line(self, node: Node) -> bool:
        block = blocks().get(node.name) if node.base == "robot" else None
        return block is not None and any(need.startswith(_LINE_NEEDS) for need in block.needs)

    def _told_by_last(self, until: int) -> None:
        last = self._commands.last(until)
        if last >= 0:
            self._actions.moved(last, until)

    def fall(self, until: int) -> None:
        """Tell the robot's command when it lost the floor."""
        history = self._history
        gone = next((i for i in range(until + 1) if self._is_without_floor(i)), -1)
        event = history.at(max(0.0, history.time(gone) - _BEFORE)) if gone >= 0 else until
        if gone >= 0:
            self._draft.say_of_line("why-no-floor", 0, gone)
        last = self._commands.last(event)
        if last >= 0:
            self._actions.say_moved(last)
        self._waits.busy(event)
        if last >= 0:
            self._actions.moved(last, event)
        self._actions.not_prevented(event)

    def _is_without_floor(self, index: int) -> bool:
        event = self._history.events[index]
        if event[0] != Op.READING or not str(event[1]).startswith("GroundSensors"):
            return False
        values = self._readings.values(index)
        return bool(values) and min(values) < _NO_FLOOR


def _acts(node: Node) -> bool:
    """Whether a call does something that can be seen or heard."""
    if node.kind is not Kind.CALL:
        return False
    if node.name == "print" and not node.base:
        return True
    if node.base != "robot" or node.name in _QUIET or node.name.startswith(_QUIET_STARTS):
        return False
    block = blocks().get(node.name)
    return movement_of(node) is not None or block is None or not block.returns_value
