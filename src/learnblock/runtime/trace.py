"""The trace of a run: JSON Lines that depend only on program, world and seed."""

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from importlib.metadata import version
from typing import Any, BinaryIO

import msgspec

from learnblock.client import Client
from learnblock.devices import Function, Pose
from learnblock.runtime.values import plain

#: The version of the trace format: since 2 a line is a statement that begins.
VERSION = 2
#: Functions of devices that only read; all others are commands.
QUESTIONS = frozenset({"read", "detect"})

_encode = msgspec.json.Encoder(enc_hook=plain).encode


class Trace:
    """Lines of JSON, written and hashed as events happen.

    Args:
        file: the file to write to, if any.
    """

    def __init__(self, file: BinaryIO | None = None) -> None:
        self._file = file
        self._hash = hashlib.sha256()

    def write(self, line: Mapping[str, object]) -> None:
        self.write_text(_encode(line) + b"\n")

    def write_text(self, text: bytes) -> None:
        """Write complete lines that are already JSON."""
        self._hash.update(text)
        if self._file:
            self._file.write(text)

    @property
    def sha256(self) -> str:
        """The hash of all lines so far, in hexadecimal."""
        return self._hash.hexdigest()


@dataclass(frozen=True, slots=True)
class Mark:
    """An event and its position, for the picture and the report."""

    time: float
    kind: str
    text: str
    pose: Pose | None


@dataclass
class Recorder:
    """Records what one robot's program does, and keeps what the report needs.

    It is the `Observer` of the client, and `watch`es its devices.

    Args:
        trace: receives the lines; the robots of a world share it.
        time: returns the robot's time in seconds.
        where: returns the robot's current pose, if known.
        label: added to every line if a world has several robots.
    """

    trace: Trace
    time: Callable[[], float]
    where: Callable[[], Pose | None]
    label: Mapping[str, str] = field(default_factory=dict)
    path: list[tuple[float, Pose]] = field(default_factory=list)
    marks: list[Mark] = field(default_factory=list)
    #: Skills without effect: (skill, device) -> number of calls.
    missed: dict[tuple[str, str], int] = field(default_factory=dict)
    _commands: dict[tuple[str, str, str], list[object]] = field(default_factory=dict)

    def begin(self, run: Mapping[str, object]) -> None:
        """Write the first line: the program, the robot and the world."""
        self.trace.write({"run": run})

    def watch(self, client: Client) -> None:
        """Record the commands to the client's devices from now on."""
        for key, device in client.devices():
            kind = type(device).__name__
            for name, function in device.functions.items():
                if name not in QUESTIONS:
                    device.functions[name] = partial(self._command, kind, key, name, function)

    def called(self, skill: str, args: Sequence[object], kwargs: Mapping[str, object]) -> None:
        named = {"kwargs": {name: plain(value) for name, value in kwargs.items()}} if kwargs else {}
        self._write("call", skill, args=[*map(plain, args)], **named)

    def missing(self, skill: str, device: str) -> None:
        self.missed[skill, device] = self.missed.get((skill, device), 0) + 1

    def line(self, number: int) -> None:
        self.lines((number,))

    def lines(self, numbers: Sequence[int]) -> None:
        """The lines that ran at this time of the robot, in order."""
        # Half of a trace is lines: they are written like `_write` does, in a tenth of its time.
        before = _encode({"t": round(self.time(), 6)})[:-1].decode() + ',"line":'
        after = (_encode(self.label).decode().replace("{", ",", 1) if self.label else "}") + "\n"
        text = (after + before).join(map(str, numbers))
        self.trace.write_text(f"{before}{text}{after}".encode())

    def printed(self, text: str) -> None:
        self._write("print", text.removesuffix("\n"))

    def pose(self, time: float, pose: Pose) -> None:
        self.path.append((time, pose))
        self._write_at(time, "pose", _rounded(pose))

    def placed(self, time: float, pose: Pose) -> None:
        self._write_at(time, "placed", _rounded(pose))

    def goal(self, time: float, name: str, state: str) -> None:
        self._mark(time, "goal", f"{name}: {state}")
        self._write_at(time, "goal", name, state=state)

    def end(self, how: str) -> None:
        self._mark(self.time(), "end", how)
        self._write("end", how)

    @property
    def emotions(self) -> list[str]:
        """The emotions shown, in order."""
        return [mark.text for mark in self.marks if mark.kind == "emotion"]

    def _command(self, kind: str, key: str, name: str, function: Function, *args: object) -> Any:
        # A loop may command the same speed a hundred times per second: only changes are recorded.
        command = [*map(plain, args)]
        if name not in _LASTING or self._commands.get((kind, key, name)) != command:
            self._commands[kind, key, name] = command
            self._write("device", kind, key=key, do=name, args=command)
            if name == "show_emotion":
                self._mark(self.time(), "emotion", str(args[0]))
        return function(*args)

    def _mark(self, time: float, kind: str, text: str) -> None:
        self.marks.append(Mark(time, kind, text, self.where()))

    def _write(self, kind: str, what: object, **more: object) -> None:
        self._write_at(self.time(), kind, what, **more)

    def _write_at(self, time: float, kind: str, what: object, **more: object) -> None:
        self.trace.write({"t": round(time, 6), kind: what, **more, **self.label})


def record(
    client: Client, program: str, trace: Trace, label: Mapping[str, str] | None = None
) -> Recorder:
    """Begin the trace of a client's program.

    Args:
        client: the robot.
        program: the program's identity.
        trace: the trace to write to.
        label: added to every line if a world has several robots.
    """
    recorder = Recorder(trace, client.clock.time, client.where, label or {})
    versions = {"learnblock": version("learnblock-studio"), "trace": VERSION}
    recorder.begin({"program": program, **client.conditions(), "versions": versions})
    recorder.watch(client)
    client.observe(recorder)
    return recorder


#: Commands that last until the next one, so repeating them changes nothing.
_LASTING = frozenset({"move", "show_emotion", "set", "set_color"})


def _rounded(pose: Pose) -> list[float]:
    # Rounding to a thousandth of a millimetre hides differences in arithmetic between machines.
    return [round(value, 3) + 0.0 for value in pose]
