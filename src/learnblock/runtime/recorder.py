"""Records what one robot's program does, in the trace and for the report."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache, partial
from inspect import isroutine
from typing import Any

from learnblock.client import Client, Witness
from learnblock.client.reckoning import Reckoning
from learnblock.devices import Function, Pose
from learnblock.installation import version
from learnblock.runtime.log.events import QUESTIONS
from learnblock.runtime.log.sensing import keep_operations, keep_readings
from learnblock.runtime.trace import VERSION, VERSION_WITH_TURNS, Trace, encoded
from learnblock.runtime.trace_sinks import about
from learnblock.runtime.turns import CountedSteps
from learnblock.runtime.values import is_small, plain
from learnblock.scores import GameEvent

#: The most steps of a program that wait to be written together.
_NOTED_TOGETHER = 1000
#: The most collisions of a robot that are kept.
MOST_COLLISIONS = 1000


@dataclass(frozen=True, slots=True)
class PlacedEvent:
    """An event and its position, for the picture and the report."""

    time: float
    kind: str
    text: str
    pose: Pose | None


@dataclass(frozen=True, slots=True)
class Collision:
    """A robot bumped into something, or another robot into it.

    Args:
        time: when it began, in seconds of the robot's time.
        thing: the name of the other one.
    """

    time: float
    thing: str


@dataclass(slots=True)
class _LastCommand:
    """The last command to a function of a device.

    Args:
        kind: the type of the device.
        key: its key.
        name: the name of the function.
        lasts: whether a command stays in force until the next one.
        shows: whether the device shares what the robot shows.
        command: its arguments, as written.
        args: its arguments, if the same ones again change nothing and are quick to compare.
    """

    kind: str
    key: str
    name: str
    lasts: bool
    shows: bool
    command: list[object] | None = None
    args: tuple[object, ...] | None = None


@dataclass
class Recorder(Witness):
    """Records what one robot's program does, and keeps what the report needs.

    It is the `Observer` of the client, and `watch`es its devices.

    Args:
        trace: receives the lines; the robots of a world share it.
        time: returns the robot's time in seconds.
        where: returns the robot's current pose, if known.
        label: added to every line if a world has several robots.
        counts_turns: whether turns of a loop that are alike are counted, not written.
    """

    trace: Trace
    time: Callable[[], float]
    where: Callable[[], Pose | None]
    label: Mapping[str, str] = field(default_factory=dict)
    counts_turns: bool = False
    path: list[tuple[float, Pose]] = field(default_factory=list)
    marks: list[PlacedEvent] = field(default_factory=list)
    #: The first `MOST_COLLISIONS`.
    collisions: list[Collision] = field(default_factory=list)
    #: Skills without effect: (skill, device) -> number of calls.
    missed: dict[tuple[str, str], int] = field(default_factory=dict)
    #: When the program ended, in seconds of the robot's time; None while it runs.
    ended_at: float | None = None
    #: The time of `_framing`.
    _framed_at: float = -1.0
    _framing: tuple[str, str, str] = ("", "", "")
    _keys: tuple[str, ...] = ()
    #: The function that last changed what the robot shows.
    _shown_by: "_LastCommand | None" = None
    _turns: CountedSteps | None = None
    #: Steps that have been noted and not yet written.
    _noted: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        if self.counts_turns:
            self._turns = CountedSteps(self._write_step)

    def begin(self, run: Mapping[str, object]) -> None:
        """Write the first line: the program, the robot and the world."""
        self.trace.write({"run": run, **self.label})

    def watch(self, client: Client) -> None:
        """Record the commands to the client's devices from now on."""
        for key, device in client.devices():
            kind = type(device).__name__
            for name, function in device.functions.items():
                if name not in QUESTIONS:
                    last = _LastCommand(kind, key, name, name in _LASTING, kind in _SHOWING)
                    device.functions[name] = partial(self._command, last, function)

    def called(self, skill: str, args: Sequence[object], kwargs: Mapping[str, object]) -> None:
        self.write_noted()
        named = {"kwargs": {name: plain(value) for name, value in kwargs.items()}} if kwargs else {}
        call = {"call": skill, "args": [*map(plain, args)], **named}
        if self._turns:
            self._turns.step(self.time(), encoded(call)[1:-1].decode())
        else:
            self.trace.write({"t": round(self.time(), 6), **call, **self.label})

    def missing(self, skill: str, device: str) -> None:
        self.missed[skill, device] = self.missed.get((skill, device), 0) + 1

    def line(self, number: int) -> None:
        self.steps((number,))

    def steps(self, steps: Sequence[int | str]) -> None:
        """The lines that ran and the skills called without arguments, at this time of the robot."""
        for step in steps:
            self.note(step)
        self.write_noted()

    def note(self, step: int | str) -> None:
        """Note a step; it is written before anything else, or with `write_noted`."""
        self._noted.append(_step(step))
        if len(self._noted) >= _NOTED_TOGETHER:
            self.write_noted()

    def note_call(self, skill: str, args: Sequence[object]) -> None:
        """Note the call of a skill with arguments; see `note`."""
        if self.trace.log:
            # There it isn't a step, because its arguments are kept.
            self.called(skill, args, {})
        else:
            self._noted.append(_call(skill, args))

    def write_noted(self) -> None:
        """Write the steps that have been noted at this time of the robot."""
        if not self._noted:
            return
        # Most of a trace is these: they are written like `_write` does, in a tenth of its time.
        noted, self._noted = self._noted, []
        time = self.time()
        if self._turns:
            for step in noted:
                self._turns.step(time, step)
            return
        before, between, after = self._frame(time)
        text = f"{before}{between.join(noted)}{after}".encode()
        self.trace.write_steps(time, text, self._abouts(noted, after))

    def printed(self, text: str) -> None:
        self._write("print", text.removesuffix("\n"))

    def sent(self, name: str, value: object) -> None:
        """A message to the other robots of the run."""
        self._write("send", name, value=value)

    def keys(self, held: Sequence[str]) -> None:
        """The keys that the program finds held down, if others than before."""
        if (keys := tuple(held)) != self._keys:
            self._keys = keys
            self._write("keys", keys)

    def pose(self, time: float, pose: Pose) -> None:
        self.path.append((time, pose))
        self._write_at(time, "pose", _rounded(pose))

    def placed(self, time: float, pose: Pose) -> None:
        self._write_at(time, "placed", _rounded(pose))

    def handled(self, time: float, how: str) -> None:
        self._write_at(time, "handled", how)

    def goal(self, time: float, name: str, state: str) -> None:
        self._mark(time, "goal", f"{name}: {state}")
        self._write_at(time, "goal", name, state=state)

    def game(self, event: GameEvent) -> None:
        """What happened in the game; only what has changed is written."""
        counts = {
            "thing": event.thing or None,
            "score": event.score,
            "lives": event.lives,
            "lost": event.lost,
            "seconds": event.seconds,
            "winner": event.winner,
            "winning_team": event.team,
        }
        changed = {name: value for name, value in counts.items() if value is not None}
        self._write_at(event.time, "game", event.kind, **changed)

    def collision(self, time: float, thing: str) -> None:
        # Not in the trace, whose lines are those of earlier versions.
        if len(self.collisions) < MOST_COLLISIONS:
            self.collisions.append(Collision(round(time, 6), thing))
        if self.trace.log:
            self.trace.log.collided(time, thing)

    def stroke(
        self,
        time: float,
        points: Sequence[tuple[float, float]],
        color: tuple[int, int, int],
        width: float,
    ) -> None:
        self._write_at(time, "stroke", points, color=color, width=width)

    def drawing_full(self, time: float) -> None:
        self.missing("pen_down", "Pen:full")
        self._write_at(time, "drawing", "full")

    def end(self, how: str) -> None:
        self.ended_at = self.time()
        self._mark(self.ended_at, "end", how)
        self._write("end", how)

    @property
    def emotions(self) -> list[str]:
        """The emotions shown, in order."""
        return [mark.text for mark in self.marks if mark.kind == "emotion"]

    def _frame(self, time: float) -> tuple[str, str, str]:
        """What is before, between and after the steps of one time."""
        if time != self._framed_at:
            before = encoded({"t": round(time, 6)})[:-1].decode() + ","
            label = encoded(self.label).decode().replace("{", ",", 1) if self.label else "}"
            after = label + "\n"
            self._framed_at, self._framing = time, (before, after + before, after)
        return self._framing

    def _write_step(self, time: float, text: str) -> None:
        before, _, after = self._frame(time)
        line = f"{before}{text}{after}".encode()
        self.trace.write_steps(time, line, self._abouts([text], after))

    def _abouts(self, steps: Sequence[str], after: str) -> Sequence[Mapping[str, Any]]:
        """What the lines of steps are about, if the trace has anything that looks at them."""
        return [about(step, after) for step in steps] if self.trace.lines is not None else ()

    def _command(self, last: "_LastCommand", function: Function, *args: object) -> Any:
        # A loop may command the same speed a hundred times per second: only changes are recorded.
        if args != last.args or (last.shows and self._shown_by is not last):
            self._tell(last, args)
        return function(*args)

    def _tell(self, last: "_LastCommand", args: tuple[object, ...]) -> None:
        if self.trace.log:
            self.write_noted()
        kind, key, name, command = last.kind, last.key, last.name, [*map(plain, args)]
        if not last.lasts or last.command != command:
            last.command = command
            self._write("device", kind, key=key, do=name, args=command)
            if name == "show_emotion":
                self._mark(self.time(), "emotion", str(args[0]))
            elif name == "show_text" and args[0]:
                self._mark(self.time(), "text", str(args[0]))
        elif last.shows and self._shown_by is not last and self.trace.log:
            again = {"device": kind, "key": key, "do": name, "args": command}
            self.trace.write_again({"t": round(self.time(), 6), "again": again, **self.label})
        if last.shows:
            self._shown_by = last
        last.args = args if last.lasts and all(map(is_small, args)) else None

    def _mark(self, time: float, kind: str, text: str) -> None:
        self.marks.append(PlacedEvent(time, kind, text, self.where()))

    def _write(self, kind: str, what: object, **more: object) -> None:
        self._write_at(self.time(), kind, what, **more)

    def _write_at(self, time: float, kind: str, what: object, **more: object) -> None:
        self.write_noted()
        if self._turns:
            self._turns.end()
        self.trace.write({"t": round(time, 6), kind: what, **more, **self.label})


def record(
    client: Client,
    program: str,
    trace: Trace,
    label: Mapping[str, str] | None = None,
    *,
    recorder_type: type[Recorder] = Recorder,
    **more: object,
) -> Recorder:
    """Begin the trace of a client's program.

    Args:
        client: the robot.
        program: the program's identity.
        trace: the trace to write to.
        label: added to every line if a world has several robots.
        recorder_type: what records it.
        more: what else the first line says about the run.
    """
    is_real = client.clock.instant is None
    where = client.where
    recorder = recorder_type(trace, client.clock.time, where, label or {}, counts_turns=is_real)
    format_version = VERSION_WITH_TURNS if is_real else VERSION
    versions = {"learnblock": version(), "trace": format_version}
    if trace.log:
        trace.log.began({"drivers": _drivers(client), **client.surroundings()})
    recorder.begin({"program": program, **client.conditions(), "versions": versions, **more})
    recorder.watch(client)
    client.observe(recorder)
    if is_real and trace.log:
        keep_operations(client, trace.log)
        keep_readings(client, trace.log)
    return recorder


def _drivers(client: Client) -> dict[str, str]:
    """The driver's own function behind each function of a device, by ``Base:ROBOT.move``."""
    return {
        f"{type(device).__name__}:{key}.{name}": _named(function)
        for key, device in client.devices()
        for name, function in device.functions.items()
    }


def _named(function: Any) -> str:
    """The name of a driver's function, such as ``Robot.drive``; of a lambda where it is."""
    while isinstance(function, partial):
        # One that watches a function has it as its last argument.
        watched = function.args[-1] if function.args else None
        function = watched if isroutine(watched) or isinstance(watched, partial) else function.func
    reckoning = getattr(function, "__self__", None)
    if isinstance(reckoning, Reckoning) and function == reckoning.move:
        return _named(reckoning.driver)
    name: str = getattr(function, "__qualname__", type(function).__name__)
    first, *inner = name.replace(".<lambda>", "").split(".<locals>")
    # A function in a method is reported as one of the class.
    return f"{first.rpartition('.')[0]}{inner[-1]}" if inner and inner[-1] else first


#: Devices that share what a robot shows: a face may colour its lights, and clear its text. So the
#: same command again may change something after another one of them.
_SHOWING = frozenset({"Display", "Led", "RGBLed", "Screen"})
#: Commands that last until the next one, so repeating them changes nothing.
_LASTING = frozenset({"move", "show_emotion", "show_text", "set", "set_color", "set_width"})


@lru_cache(maxsize=1000)
def _step(step: int | str) -> str:
    if isinstance(step, int):
        return f'"line":{step}'
    return f'"call":{encoded(step).decode()},"args":[]'


def _call(skill: str, args: Sequence[object]) -> str:
    return encoded({"call": skill, "args": [*map(plain, args)]})[1:-1].decode()


def _rounded(pose: Pose) -> list[float]:
    # Rounding to a thousandth of a millimetre hides differences in arithmetic between machines.
    return [round(value, 3) + 0.0 for value in pose]
