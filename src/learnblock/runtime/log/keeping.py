"""The log of a run in its host: kept in memory up to a limit, and in a file if there is one."""

import threading
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import monotonic
from typing import Any, BinaryIO

import msgspec

from learnblock.installation import version
from learnblock.runtime.log.blocks import DETAIL, MAGIC, EventBlock, EventStream
from learnblock.runtime.log.instrumenting import instrument
from learnblock.runtime.log.nodes import Node
from learnblock.runtime.log.noting import TICK
from learnblock.runtime.program import Program

#: The most bytes that a log keeps, and the most before they are compressed, since reading them
#: takes seconds and thirty times as much memory; then the oldest detail goes.
MOST_BYTES, MOST_UNPACKED = 32 * 1024 * 1024, 32 * 1024 * 1024
#: The bytes and the seconds after which a block is closed.
BLOCK, LONGEST_WAIT = 64 * 1024, 1.0
#: What is given up in the end: also the world, which can then be shown only as it was recorded.
_WORLDS = frozenset({EventStream.WORLD, EventStream.TEAM})
_GIVEN_UP = DETAIL | _WORLDS

_encode = msgspec.msgpack.Encoder().encode


class RunLog:
    """The log of one run; its methods may be called from several threads.

    Args:
        program: the program that is run.
        path: the file to keep it in, besides memory; None for no file.

    Raises:
        OSError: the file cannot be written.
    """

    def __init__(self, program: Program, path: Path | None = None) -> None:
        self.program = program
        self._blocks: list[_Kept] = []
        #: The streams that have blocks.
        self._begun: set[EventStream] = set()
        #: Whether it says that some of what happened in the world has been given up.
        self._says_lost = False
        #: What the robots of a run share, if there are several.
        self._team: TeamLog | None = None
        self._bytes = self._unpacked = 0
        #: The oldest detail that is still kept, in ticks.
        self.complete_since = 0
        #: Why the file could not be written to its end; "" if it could.
        self.failure = ""
        self._open = {stream: _Open(stream) for stream in (EventStream.STEPS, EventStream.WORLD)}
        self._lock = threading.Lock()
        self._file: BinaryIO | None = None
        if path:
            self._file = path.open("wb")
            self._file.write(MAGIC)
        self._add(header(program, _nodes(program)))

    def noted(self, first: int, last: int, events: bytes) -> None:
        """Keep a batch of the program's events."""
        with self._lock:
            self._add(EventBlock.of(EventStream.PROGRAM, first, last, events), len(events))

    def stepped(self, time: float, lines: bytes) -> None:
        """Keep lines of the trace about the program's steps."""
        self._keep(EventStream.STEPS, time, lines)

    def happened(self, time: float, lines: bytes) -> None:
        """Keep other lines of the trace."""
        self._keep(EventStream.WORLD, time, lines)

    def began(self, robot: Mapping[str, object]) -> None:
        """Keep what is known of the robot once it is connected.

        Args:
            robot: the driver's own function behind each function of its devices, and the world it
                is in, if that is simulated.
        """
        self._keep(EventStream.WORLD, 0.0, msgspec.json.encode({"robot": robot}) + b"\n")

    def join(self, team: "TeamLog") -> None:
        """Also keep what all robots of a world do to it; called once, at the beginning."""
        self._team = team

    def shared(self, block: EventBlock, unpacked: int) -> None:
        """Keep a block of what the robots of a run share."""
        with self._lock:
            self._add(block, unpacked)

    def collided(self, time: float, thing: str) -> None:
        """Keep that the robot bumped into a thing of its world."""
        line = msgspec.json.encode({"t": round(time, 6), "bump": thing})
        self._keep(EventStream.WORLD, time, line + b"\n")

    def sensed(self, time: float, what: str, value: object) -> None:
        """Keep what a real robot has measured: its ``odometry``, or the reading of a device."""
        if what == "odometry":
            line = {"t": round(time, 6), what: value}
            self._keep(EventStream.WORLD, time, msgspec.json.encode(line) + b"\n")
        else:
            line = {"t": round(time, 6), "sensed": what, "value": value}
            self._keep(EventStream.STEPS, time, msgspec.json.encode(line) + b"\n")

    def operated(self, time: float, of: str, operation: str) -> None:
        """Keep that a function of a device has made the driver call an operation of the robot."""
        line = msgspec.json.encode({"t": round(time, 6), "operation": operation, "of": of})
        self._keep(EventStream.WORLD, time, line + b"\n")

    def end(self, ending: Mapping[str, Any]) -> None:
        """Keep how the run ended; this is the last call."""
        self.flush()
        with self._lock:
            self._add(EventBlock.of(EventStream.ENDING, 0, 0, _encode(ending)))
            if self._file:
                self._file.close()
                self._file = None

    @property
    def blocks(self) -> tuple[EventBlock, ...]:
        """What is kept now, oldest first."""
        self.flush()
        with self._lock:
            return tuple(entry.block for entry in self._blocks)

    def flush(self) -> None:
        """Close the blocks that are open."""
        if self._team:
            self._team.flush()
        with self._lock:
            for stream in self._open.values():
                self._close(stream)

    def _keep(self, stream: EventStream, time: float, lines: bytes) -> None:
        with self._lock:
            if self._open[stream].add(time, lines):
                self._close(self._open[stream])

    # These methods need the lock.

    def _close(self, stream: "_Open") -> None:
        unpacked = stream.bytes
        if block := stream.close():
            self._add(block, unpacked)

    def _add(self, block: EventBlock, unpacked: int = 0) -> None:
        """Keep a block with its length in bytes, unpacked."""
        # The first lines of the world say what run it is.
        is_first = block.stream in _WORLDS - self._begun
        self._begun.add(block.stream)
        self._blocks.append(_Kept(block, unpacked, is_first or block.stream not in _GIVEN_UP))
        self._bytes += len(block.packed)
        self._unpacked += unpacked
        if self._file:
            self._write(bytes(block))
        if self._bytes > MOST_BYTES or self._unpacked > MOST_UNPACKED:
            self._give_oldest_up()

    def _give_oldest_up(self) -> None:
        """Give up half of the log, so that it does not happen at every block."""
        self._drop(DETAIL)
        if self._is_half_full and self._drop(_WORLDS) and not self._says_lost:
            self._says_lost = True
            line = msgspec.json.encode({"t": 0.0, "lost": True}) + b"\n"
            lost = EventBlock.of(EventStream.WORLD, 0, 0, line)
            self._blocks.append(_Kept(lost, len(line), is_needed=True))
        if self._file:
            self._rewrite(self._file)

    @property
    def _is_half_full(self) -> bool:
        return 2 * self._bytes > MOST_BYTES or 2 * self._unpacked > MOST_UNPACKED

    def _drop(self, streams: Collection[EventStream]) -> bool:
        """Drop the oldest blocks of some streams; return whether there were any."""
        remaining: list[_Kept] = []
        for entry in self._blocks:
            if entry.is_needed or entry.block.stream not in streams or not self._is_half_full:
                remaining.append(entry)
                continue
            self._bytes -= len(entry.block.packed)
            self._unpacked -= entry.unpacked
            self.complete_since = max(self.complete_since, entry.block.last)
        has_dropped = len(remaining) < len(self._blocks)
        self._blocks = remaining
        return has_dropped

    def _write(self, data: bytes) -> None:
        try:
            if self._file:
                self._file.write(data)
                self._file.flush()
        except OSError as error:
            self._give_file_up(error)

    def _rewrite(self, file: BinaryIO) -> None:
        """Write the file again without what has been given up.

        In place: a driver's fence lets no other file be opened. Killed in between, the program
        leaves a file that can be read up to there.
        """
        try:
            file.seek(len(MAGIC))
            file.writelines(bytes(entry.block) for entry in self._blocks)
            file.truncate()
        except OSError as error:
            self._give_file_up(error)

    def _give_file_up(self, error: OSError) -> None:
        # A full disk, for example: the run continues.
        self.failure = error.strerror or str(error)
        if self._file:
            file, self._file = self._file, None
            try:
                file.close()
            except OSError as again:
                self.failure = again.strerror or str(again)


class TeamLog:
    """What several robots do to the world that they share; each of their logs keeps all of it.

    Args:
        logs: of the robots.
        roster: for each robot of the world, in the order in which they were added to it: its name,
            its kind, and where it starts, as plain data.
    """

    def __init__(self, logs: Sequence[RunLog], roster: Sequence[Mapping[str, object]]) -> None:
        self._logs = logs
        self._lock = threading.Lock()
        self._open = _Open(EventStream.TEAM)
        for log in logs:
            log.join(self)
        self.happened(0.0, msgspec.json.encode({"team": roster}) + b"\n")

    def happened(self, time: float, lines: bytes) -> None:
        """Keep lines of the trace."""
        with self._lock:
            if self._open.add(time, lines):
                self._close()

    def flush(self) -> None:
        """Close the block that is open."""
        with self._lock:
            self._close()

    def _close(self) -> None:
        unpacked = self._open.bytes
        if block := self._open.close():
            for log in self._logs:
                log.shared(block, unpacked)


@dataclass(frozen=True, slots=True, eq=False)
class _Kept:
    """A block in memory.

    Args:
        block: the block.
        unpacked: its bytes before they were compressed.
        is_needed: whether it is never given up.
    """

    block: EventBlock
    unpacked: int
    is_needed: bool


class _Open:
    """A block to which lines are still added."""

    def __init__(self, stream: EventStream) -> None:
        self._stream = stream
        self._first = self._last = 0.0
        self._lines: list[bytes] = []
        self.bytes = 0
        self._since = 0.0

    def add(self, time: float, lines: bytes) -> bool:
        """Add lines of a time in s; return whether the block is full."""
        if not self._lines:
            self._first, self._since = time, monotonic()
        self._last = time
        self._lines.append(lines)
        self.bytes += len(lines)
        return self.bytes > BLOCK or monotonic() - self._since > LONGEST_WAIT

    def close(self) -> EventBlock | None:
        """The block, which is then empty; None if it already is."""
        if not self._lines:
            return None
        first, last = round(self._first / TICK), round(self._last / TICK)
        block = EventBlock.of(self._stream, first, last, b"".join(self._lines))
        self._lines.clear()
        self.bytes = 0
        return block


def header(program: Program, nodes: Sequence[Node]) -> EventBlock:
    """The first block of a log, which says what program it is of.

    Args:
        program: the program.
        nodes: the places in it that the log tells about.
    """
    contents = {
        "learnblock": version(),
        "name": program.name,
        "program": program.identity,
        "python": program.python,
        "written": program.written,
        "lines": program.source_map.source_lines if program.source_map else None,
        "nodes": nodes,
    }
    return EventBlock.of(EventStream.HEADER, 0, 0, _encode(contents))


def _nodes(program: Program) -> Sequence[Node]:
    try:
        return instrument(program.python).nodes
    except (SyntaxError, ValueError, RecursionError):
        # The run itself reports what is wrong with it.
        return ()
