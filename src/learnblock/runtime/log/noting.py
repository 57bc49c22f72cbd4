"""Notes what a program does, in its own process: the other end of its instrumented calls.

The functions here run at every step of a pupil's program, so they do little: they append to a list.
"""

import sys
from collections.abc import Callable, Iterator
from time import monotonic
from types import FrameType
from typing import Any

import msgspec

from learnblock.client.clock import Clock
from learnblock.runtime.log import instrumenting as names
from learnblock.runtime.log.events import Event, Op
from learnblock.runtime.log.snapshots import snapshot
from learnblock.runtime.messages import LARGEST_LOGGED

#: The events kept of one moment of the robot; then nothing is noted until time passes.
MOST_AT_ONE_TIME = 2000
#: The events and the seconds after which a batch is sent.
BATCH, LONGEST_WAIT = 4000, 0.05
#: So many events cannot be halved any more.
LEAST_EVENTS = 2
#: Seconds per tick of a real robot's time.
TICK = 0.01
#: Turns of a loop with more events than that are not compared with one another.
LONGEST_TURN = 500

_encode = msgspec.msgpack.Encoder().encode
#: Passes through: called with a number and a value, it returns the value. No function of Python's
#: own is as fast, and the interpreter does not trace it.
THROUGH: Callable[..., Any] = {}.get
_LISTS = frozenset({list, dict, set})
#: Values that may have lists in them.
_HOLDERS = _LISTS | {tuple}
#: The most lists whose contents are watched, and variables of a call that are reported at once.
MOST_LISTS, MOST_VARIABLES = 50, 200
#: The number of innermost calls whose variables are reported.
MOST_CALLS = 20
#: The length of a wait, in ticks, before which a program sends what it has done.
LONG_WAIT = 100
#: The longest list that is watched, since that keeps it in memory for a moment longer.
LONGEST_LIST = 1000
#: Ticks after which all variables are sent again, for readers that lack what came before.
KEYFRAME = 500
#: The references to a list that only `Noting` still has: from its table and from the loop over it.
_OWN_REFERENCES = 4
#: Types of values that are not shown as variables.
_HIDDEN = frozenset({type(sys), type(lambda: None), type(print), type})


class Noting:
    """The log of one program, until it is sent.

    Args:
        send: sends a batch: the time of its first and of its last event, in ticks, and the events,
            encoded with msgpack.
        filename: the file of the program's code.
    """

    def __init__(
        self, send: Callable[[int, int, bytes], object], filename: str = "program.py"
    ) -> None:
        self._send = send
        self._filename = filename
        #: The clock of a real robot, which runs by itself.
        self._clock: Clock | None = None
        self._events: list[Event] = [(Op.AT, 0)]
        self._sent_at = monotonic()
        #: The time of the last event, in ticks.
        self._ticks = 0
        #: Whether turns of loops are equal only if they take equally long.
        self._exact = True
        #: Where in `_events` the present moment began.
        self._began = 0
        #: By loop: the batch, where its last two turns began, and the event that counts its turns.
        self._turns: dict[int, tuple[int, int, int, list[Any] | None]] = {}
        self._batch = 0
        self._builtins: dict[str, Any] = {}
        self._passes_through = False
        #: By identity, the lists of the program's variables, and what was last reported of each.
        self._lists: dict[int, tuple[Any, Any]] = {}
        #: Whether one of them may have changed since.
        self._may_differ = False
        self._next_keyframe = KEYFRAME

    def install(self, builtins: dict[str, Any]) -> None:
        """Put the noting functions among the program's builtins."""
        self._builtins = builtins
        builtins.update(self._functions())

    def use_clock(self, clock: Clock) -> None:
        """Take the time from the robot's clock; the clock of a world calls `woke` instead."""
        # Whatever the time of a robot before it was: that has been sent.
        self._ticks = clock.instant or 0
        self._events = [(Op.AT, self._ticks)]
        if clock.instant is None:
            self._clock, self._exact = clock, False

    # Called by the robot in the child.

    def pass_time(self) -> None:
        """Note the time of a real robot, if it has passed."""
        if self._clock is not None:
            self.woke(round(self._clock.time() / TICK))

    def woke(self, ticks: int) -> None:
        """Note the time, if it has passed."""
        if ticks <= self._ticks:
            # Of two threads of a program, one may be late.
            return
        if self._passes_through:
            self._resume()
            self._tell_variables()
        elif self._may_differ:
            self._tell_contents()
        if len(self._events) >= BATCH or monotonic() - self._sent_at > LONGEST_WAIT:
            self.flush()
            # Only here, because it makes a turn of a loop unlike the others.
            if ticks >= self._next_keyframe:
                self._tell_variables()
        self._events.append((Op.PASSED, ticks - self._ticks))
        self._ticks = ticks
        self._began = len(self._events)

    def skill(self, name: str, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
        if self._clock is not None:
            self.pass_time()
        values = [snapshot(value) for value in (*args, *kwargs.values())]
        self._events.append((Op.SKILL, name, values))

    def skill_end(self, name: str) -> None:
        if self._clock is not None:
            self.pass_time()
        self._events.append((Op.SKILL_END, name))

    def command(self, device: str, function: str, args: tuple[Any, ...]) -> None:
        self.pass_time()
        self._events.append((Op.COMMAND, device, function, [snapshot(value) for value in args]))

    def reading(self, device: str, value: Any) -> None:
        self.pass_time()
        self._events.append((Op.READING, device, snapshot(_builtin(value))))

    def missing(self, skill: str, device: str) -> None:
        self._events.append((Op.MISSING, skill, device))

    def sent(self, name: str, value: Any) -> None:
        self._events.append((Op.SENT, name, snapshot(value)))

    def wait(self, steps: int) -> None:
        """Send what has happened so far before a long wait, in which it may be asked for."""
        if steps >= LONG_WAIT:
            self.flush()

    def flush(self) -> None:
        """Send what has happened so far."""
        if self._may_differ:
            self._tell_contents()
        events, self._events = self._events, []
        self._batch += 1
        self._sent_at = monotonic()
        self._began = 0
        if len(events) > 1:
            self._send_some(events, self._ticks)
        self._events.append((Op.AT, self._ticks))

    def _send_some(self, events: list[Event], last: int) -> None:
        """Send events, the first of which says when they begin; too many in several batches."""
        batch = _encode(events)
        if len(batch) <= LARGEST_LOGGED:
            self._send(events[0][1], last, batch)
            return
        half = len(events) // 2
        if half < LEAST_EVENTS:
            # A single one with more lists than anybody reads.
            self._send(events[0][1], last, _encode([events[0], (Op.GAP,)]))
            return
        middle = events[0][1] + sum(map(_duration, events[1:half]))
        self._send_some(events[:half], middle)
        self._send_some([(Op.AT, middle), *events[half:]], last)

    def end(self) -> None:
        """Send what has happened so far, and nothing from now on."""
        self.flush()
        self._send = _ignore

    # What the program calls.

    def _functions(self) -> dict[str, Callable[..., Any]]:
        return {
            names.CONDITION: self._condition,
            names.LOOP: self._loop,
            names.TURN: self._turn,
            names.OPERAND: self._operand,
            names.RESULT: self._result,
            names.CHANGER: self._changer,
            names.GONE: self._gone,
            names.WRITE: self._write,
            names.CALLS: self._calls,
            names.ENTER: self._enter,
            names.LEAVE: self._leave,
            names.RETURN: self._return,
            names.JUMP: self._jump,
        }

    def _condition(self, node: int, value: object) -> bool:
        # Asked once, because the value may be an object of the program's own.
        answer = bool(value)
        self._events.append((Op.CONDITION, node, answer))
        return answer

    def _loop(self, node: int, value: object) -> bool:
        answer = bool(value)
        self._events.append((Op.CONDITION, node, answer))
        self._end_turn(node)
        return answer

    def _turn(self, node: int, value: object) -> None:
        lists = self._lists_of(value) if type(value) in _HOLDERS else None
        event = (Op.TURN, node, snapshot(value))
        self._events.append((*event, lists) if lists else event)
        self._end_turn(node)

    def _operand(self, node: int, value: Any) -> Any:
        self._events.append((Op.OPERAND, node, snapshot(value)))
        return value

    def _result(self, node: int, value: Any) -> Any:
        if value is None:
            self._events.append((Op.RESULT, node, None))
            return None
        contents = snapshot(value)
        self._events.append((Op.RESULT, node, contents))
        if type(contents) is list:
            self._weigh(contents)
        return value

    def _changer(self, node: int, value: Any) -> Any:
        """As `_result`, of a call that may have changed a list."""
        self._may_differ = True
        self._events.append((Op.RESULT, node, snapshot(value)))
        return value

    def _gone(self, node: int, _: None) -> None:
        self._events.append((Op.GONE, node))

    def _write(self, node: int, value: Any) -> Any:
        kind = type(value)
        if kind not in _HOLDERS:
            self._events.append((Op.WRITE, node, snapshot(value), 0))
        elif kind is tuple:
            event = (Op.WRITE, node, snapshot(value), 0)
            lists = self._lists_of(value)
            self._events.append((*event, lists) if lists else event)
            self._may_differ = True
        else:
            # A list is known by its address: two variables that share one now have the same.
            contents = snapshot(value)
            self._watch(value, contents)
            self._events.append((Op.WRITE, node, contents, id(value)))
            self._may_differ = True
            self._weigh(contents)
        return value

    def _calls(self, node: int, function: Any) -> Any:
        self._events.append((Op.CALLS, node))
        return function

    def _enter(self, node: int, values: tuple[Any, ...]) -> None:
        event = (Op.ENTER, node, [snapshot(value) for value in values])
        lists = self._lists_of(values)
        self._events.append((*event, lists) if lists else event)
        if len(self._events) - self._began > MOST_AT_ONE_TIME:
            self._pass_through()

    def _leave(self, node: int, _: None) -> None:
        self._events.append((Op.LEAVE, node))

    def _return(self, node: int, value: Any) -> Any:
        self._events.append((Op.RETURN, node, snapshot(value)))
        return value

    def _jump(self, node: int, _: None) -> None:
        self._events.append((Op.JUMP, node))

    # Lists, which several variables may share.

    def _watch(self, value: Any, contents: Any) -> None:
        """Watch the contents of a list, because it may change without an event."""
        if len(value) > LONGEST_LIST:
            return
        self._lists[id(value)] = value, contents
        if len(self._lists) > MOST_LISTS:
            del self._lists[next(iter(self._lists))]

    def _weigh(self, contents: Any) -> None:
        """Let a list count as much as its items, in what is kept of one moment."""
        each = contents if type(contents) is list else ()
        self._began -= len(each) + sum(len(value) for value in each if type(value) is list)

    def _lists_of(self, values: Any) -> list[int] | None:
        """The identities of the lists among some values, or of a list; None if there are none."""
        each = values if type(values) is tuple else (values,)
        if _LISTS.isdisjoint(map(type, each)):
            return None
        for value in each:
            if type(value) in _LISTS:
                self._watch(value, snapshot(value))
        return [id(value) if type(value) in _LISTS else 0 for value in each]

    def _tell_contents(self) -> None:
        self._may_differ = False
        for identity in [*self._lists]:
            value, contents = self._lists[identity]
            if sys.getrefcount(value) < _OWN_REFERENCES:
                # The program has forgotten it.
                del self._lists[identity]
                continue
            now = snapshot(value)
            if now != contents:
                self._lists[identity] = value, now
                self._events.append((Op.CONTENTS, identity, now))

    def _tell_variables(self) -> None:
        self._next_keyframe = self._ticks + KEYFRAME
        self._tell_contents()
        frames = [*_frames(sys._getframe(), self._filename)]  # noqa: SLF001 - the documented way
        if not frames or frames[-1].f_code.co_name != "<module>":
            # Another thread of the program.
            return
        for depth, frame in enumerate(reversed(frames)):
            if 0 < depth < len(frames) - MOST_CALLS:
                continue
            line = frame.f_code.co_firstlineno if depth else 0
            variables = [*_variables(frame.f_locals)]
            lists = self._lists_of(tuple(value for _, value in variables)) or []
            pairs = [[snapshot(name), snapshot(value)] for name, value in variables]
            is_innermost = depth == len(frames) - 1
            self._events.append((Op.VARIABLES, depth, line, pairs, lists, is_innermost))

    # Loops.

    def _end_turn(self, node: int) -> None:
        """Count a turn that was as the one before, instead of keeping it."""
        events = self._events
        end = len(events)
        batch, before, began, counted = self._turns.get(node, (-1, 0, 0, None))
        if batch != self._batch:
            # Its last turn began before this batch: there is nothing to compare.
            self._turns[node] = (self._batch, end, end, None)
        elif self._is_as_before(before, began, end, is_counted=counted is not None):
            self._count(node, before, began, counted)
        else:
            self._turns[node] = (self._batch, began + (counted is not None), end, None)
        if end - self._began > MOST_AT_ONE_TIME:
            self._pass_through()

    def _is_as_before(self, before: int, began: int, end: int, *, is_counted: bool) -> bool:
        start = began + is_counted
        length = began - before
        if not 0 < length <= LONGEST_TURN:
            return False
        if self._exact:
            return end - start == length and self._events[start:end] == self._events[before:began]
        return _timeless(self._events[start:end]) == _timeless(self._events[before:began])

    def _count(self, node: int, before: int, began: int, counted: list[Any] | None) -> None:
        events = self._events
        start = began + (counted is not None)
        ticks = sum(event[1] for event in events[start:] if event[0] == Op.PASSED)
        del events[start:]
        if counted is None:
            counted = [Op.REPEATED, node, 0, 0]
            # A list, because it still counts; the batch turns it into an array as well.
            events.append(counted)  # type: ignore[arg-type]
        counted[2] += 1
        counted[3] += ticks
        if not ticks and counted[2] >= MOST_AT_ONE_TIME:
            self._pass_through()
        self._turns[node] = (self._batch, before, began, counted)
        self._began = min(self._began, len(events)) if not ticks else len(events)

    # Too much at one moment.

    def _pass_through(self) -> None:
        self._events.append((Op.GAP,))
        self._passes_through = True
        self._builtins.update(dict.fromkeys(names.NOTING, THROUGH))

    def _resume(self) -> None:
        self._passes_through = False
        self._builtins.update(self._functions())


def _frames(frame: FrameType | None, filename: str) -> Iterator[FrameType]:
    """The calls of the program's own functions, innermost first."""
    while frame:
        code = frame.f_code
        if code.co_filename == filename and (code.co_name == "<module>" or code.co_name[0] != "<"):
            yield frame
        frame = frame.f_back


def _variables(names: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    seen = 0
    # Another thread may change them at the same time, and a program may give them any key.
    for name, value in [*names.items()]:
        if (
            type(name) is str
            and name[:2] != "__"
            and type(value) not in _HIDDEN
            and not callable(value)
        ):
            yield name, value
            seen += 1
            if seen == MOST_VARIABLES:
                return


def _ignore(first: int, last: int, events: bytes) -> None:
    """Do nothing with a batch."""


def _duration(event: Event) -> int:
    """The ticks in which an event happened."""
    if event[0] == Op.PASSED:
        return int(event[1])
    return int(event[3]) if event[0] == Op.REPEATED else 0


def _timeless(events: list[Event]) -> list[Event]:
    return [event for event in events if event[0] != Op.PASSED]


def _builtin(value: Any) -> Any:
    """A reading, which may be a structure, as dicts and lists."""
    return (
        value
        if isinstance(value, dict | list | tuple | int | float | str) or value is None
        else msgspec.to_builtins(value)
    )
