"""The trace of a run: JSON Lines that depend only on program, world and seed."""

import hashlib
import threading
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import msgspec

from learnblock.runtime.log.keeping import RunLog, TeamLog
from learnblock.runtime.trace_sinks import LineSink, TraceSink
from learnblock.runtime.values import plain

#: The version of the trace: since 2 a line is a statement that begins, since 4 a repeated question
#: waits for the next reading, and since 5 a reckoned pose is that of wheels that need time to speed
#: up and to stop. Version 3 is that of a real robot, in which turns of a loop that are alike are
#: counted.
VERSION, VERSION_WITH_TURNS = 5, 3
#: The hash of a trace without a line.
_NOTHING = hashlib.sha256().digest()
#: The most pieces of a trace that wait to be hashed together.
_HASHED_TOGETHER = 1000

#: A line as JSON, or a part of it.
encoded = msgspec.json.Encoder(enc_hook=plain).encode


class Trace:
    """Lines of JSON, written and hashed as events happen.

    Args:
        file: where the lines are written to, if anywhere.
        log: the log of the run, if there is one; it keeps the same lines.
        lines: takes the lines themselves, if anything looks at the run.
    """

    def __init__(
        self,
        file: TraceSink | None = None,
        log: RunLog | None = None,
        lines: LineSink | None = None,
    ) -> None:
        self._file = file
        self.log = log
        self.lines = lines
        self._hash = hashlib.sha256()
        #: Lines to be hashed together: that takes a tenth of the time.
        self._unhashed: list[bytes] = []
        #: Real robots of one run are each served by a thread.
        self._writing = threading.Lock()

    def write(self, line: Mapping[str, Any]) -> None:
        text = encoded(line) + b"\n"
        self._write_text(text, lambda lines: lines.keep(line))
        if self.log:
            self.log.happened(line.get("t", 0.0), text)

    def write_again(self, line: Mapping[str, Any]) -> None:
        """Keep a command in the log that is not in the trace, as it is the same as before."""
        if self.log:
            self.log.happened(line["t"], encoded(line) + b"\n")

    def write_steps(self, time: float, text: bytes, steps: Sequence[Mapping[str, Any]]) -> None:
        """Write lines about the program's steps, which are already JSON.

        Args:
            time: their time.
            text: the lines.
            steps: the same, if `lines` wants them.
        """
        self._write_text(text, lambda lines: lines.keep_steps(time, steps))
        if self.log:
            self.log.stepped(time, text)

    def _write_text(self, text: bytes, keep: Callable[[LineSink], object]) -> None:
        with self._writing:
            self._unhashed.append(text)
            if len(self._unhashed) >= _HASHED_TOGETHER:
                self._hash_lines()
            if self._file:
                self._file.write(text)
            # One that holds no lines yet may be false.
            if self.lines is not None:
                keep(self.lines)

    @property
    def sha256(self) -> str:
        """The hash of all lines so far, in hexadecimal; empty if there are none."""
        with self._writing:
            self._hash_lines()
            return "" if self._hash.digest() == _NOTHING else self._hash.hexdigest()

    def _hash_lines(self) -> None:
        self._hash.update(b"".join(self._unhashed))
        self._unhashed.clear()


#: What decides about a world, by the name of its line.
_DECISIVE = frozenset({"again", "device", "end", "game", "handled", "placed"})


class MemberTrace(Trace):
    """The lines of one robot in the trace of several.

    Args:
        shared: the trace.
        log: the log of the robot's program.
        team: the log of the world that it shares; None for a real robot.
    """

    def __init__(self, shared: Trace, log: RunLog, team: TeamLog | None) -> None:
        super().__init__(log=log, lines=shared.lines)
        self._shared = shared
        self._team = team

    def write(self, line: Mapping[str, Any]) -> None:
        super().write(line)
        self._share(line)

    def write_again(self, line: Mapping[str, Any]) -> None:
        super().write_again(line)
        self._share(line)

    def _share(self, line: Mapping[str, Any]) -> None:
        if self._team and not _DECISIVE.isdisjoint(line):
            self._team.happened(line["t"], encoded(line) + b"\n")

    def _write_text(self, text: bytes, keep: Callable[[LineSink], object]) -> None:
        self._shared._write_text(text, keep)  # noqa: SLF001 - of the same class
