"""The log of a run, as it was kept or stored."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import msgspec

from learnblock.errors import LearnBlockError
from learnblock.language.python.source_map import SourceMap
from learnblock.runtime.log.blocks import MAGIC, EventBlock, EventStream, stored
from learnblock.runtime.log.events import Event
from learnblock.runtime.log.nodes import Node
from learnblock.runtime.program import Program

#: The largest file that is read; ours are half as large at most.
LARGEST = 128 * 1024 * 1024
#: The most bytes that are read from one, unpacked; ours have a third of that, and their program.
MOST_UNPACKED = 96 * 1024 * 1024
#: The name of the program's own steps in a trace.
_STEPS = frozenset({"line", "call", "repeated"})


class _Header(msgspec.Struct):
    """What a log says about its program."""

    learnblock: str
    name: str
    program: str
    python: str
    written: str
    lines: tuple[int, ...] | None
    nodes: tuple[Node, ...]


@dataclass(frozen=True)
class Recorded:
    """The log of a run.

    Args:
        program: the program that ran.
        nodes: its places that occur in the log.
        batches: what it did: each batch begins with its time.
        lines: the lines of the trace, and collisions, in order of time.
        ending: the report of the run, as plain data; empty while it runs, and if it was cut off.
        team: the lines that decide about a world of several robots, in order.
    """

    program: Program
    nodes: tuple[Node, ...]
    batches: tuple[tuple[Event, ...], ...]
    lines: tuple[dict[str, Any], ...]
    ending: dict[str, Any] = field(default_factory=dict)
    team: tuple[dict[str, Any], ...] = ()

    @classmethod
    def of(cls, blocks: Iterable[EventBlock]) -> "Recorded":
        """The log in some blocks.

        Raises:
            LearnBlockError: they are not those of a log.
        """
        by_stream: dict[EventStream, list[bytes]] = {stream: [] for stream in EventStream}
        try:
            for stream, data in _unpacked(blocks):
                by_stream[stream].append(data)
            header = msgspec.msgpack.decode(by_stream[EventStream.HEADER][0], type=_Header)
            return cls(
                _program(header),
                header.nodes,
                tuple(_batches(by_stream[EventStream.PROGRAM])),
                lines_in([*by_stream[EventStream.WORLD], *by_stream[EventStream.STEPS]]),
                _ending(by_stream[EventStream.ENDING]),
                lines_in(by_stream[EventStream.TEAM]),
            )
        except (IndexError, TypeError, ValueError, msgspec.DecodeError) as error:
            raise LearnBlockError("log-not-a-log") from error

    @cached_property
    def conditions(self) -> dict[str, Any]:
        """The robot, its world and the seed, as in the first line of the trace; {} without one."""
        return self._first("run")

    @cached_property
    def robot(self) -> dict[str, Any]:
        """The functions of its driver, and its world if that is simulated; {} without a robot."""
        return self._first("robot")

    def _first(self, kind: str) -> dict[str, Any]:
        # A line of one robot among several has its name as "robot".
        lines = (line[kind] for line in self.lines if isinstance(line.get(kind), dict))
        contents: dict[str, Any] = next(lines, {})
        return contents

    @cached_property
    def ran(self) -> tuple[tuple[float, int], ...]:
        """When a line of the program's Python ran, in s, and which one, in order.

        Of counted turns, the first and the last.
        """
        return tuple(_ran(self.lines))

    @cached_property
    def name(self) -> str:
        """The robot's name among those of its world."""
        names = (line.get("robot", "robot") for line in self.lines if "run" in line)
        return str(next(names, "robot"))

    @cached_property
    def roster(self) -> tuple[dict[str, Any], ...]:
        """All robots of its world, in their order, with kind and start; () if it was alone."""
        return tuple(next((line["team"] for line in self.team if "team" in line), ()))


def read(path: Path | str) -> Recorded:
    """The log in a file, up to its first damaged part.

    Raises:
        OSError: the file cannot be read.
        LearnBlockError: it is not a log, or too large.
    """
    path = Path(path)
    if path.stat().st_size > LARGEST:
        raise LearnBlockError("log-too-large", file=str(path), most=LARGEST // 2**20)
    data = path.read_bytes()
    if not data.startswith(MAGIC):
        raise LearnBlockError("log-not-a-file", file=str(path))
    return Recorded.of(stored(data[len(MAGIC) :]))


def _program(header: _Header) -> Program:
    source_map = None if header.lines is None else SourceMap(header.lines)
    return Program(header.name, header.python, header.written, source_map)


def _unpacked(blocks: Iterable[EventBlock]) -> Iterator[tuple[EventStream, bytes]]:
    """What some blocks contain.

    Raises:
        ValueError: that is not compressed data, or far more than a log has.
    """
    remaining = MOST_UNPACKED
    for block in blocks:
        data = block.unpacked(remaining)
        remaining -= len(data)
        yield block.stream, data


def _batches(blocks: Iterable[bytes]) -> Iterator[tuple[Event, ...]]:
    decode = msgspec.msgpack.Decoder(tuple[tuple[Any, ...], ...]).decode
    return map(decode, blocks)


def lines_in(blocks: Iterable[bytes]) -> tuple[dict[str, Any], ...]:
    """The lines of both streams, in order of time; within one moment those of the world first."""
    decode = msgspec.json.Decoder(dict[str, Any]).decode_lines
    lines = [line for block in blocks for line in decode(block)]
    return tuple(sorted(lines, key=lambda line: line.get("t", 0.0)))


def _ran(lines: Iterable[Mapping[str, Any]]) -> Iterator[tuple[float, int]]:
    steps: list[Mapping[str, Any]] = []
    for line in lines:
        if "line" in line:
            yield line["t"], line["line"]
        elif "repeated" in line:
            turn = steps[-line["repeated"] :]
            yield from ((line["t"], step["line"]) for step in turn if "line" in step)
        if not _STEPS.isdisjoint(line):
            steps.append(line)


def _ending(blocks: list[bytes]) -> dict[str, Any]:
    ending: dict[str, Any] = msgspec.msgpack.decode(blocks[0]) if blocks else {}
    return ending
