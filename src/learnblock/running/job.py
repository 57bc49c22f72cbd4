"""A run of a batch, and how the batch sends its runs to the process that makes them."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import msgspec

from learnblock.language.python.source_map import SourceMap
from learnblock.robots import RobotEntry
from learnblock.running.program_run import Options
from learnblock.running.recorded_keys import RecordedKeys
from learnblock.runtime.limits import Limits
from learnblock.runtime.program import Program


@dataclass(frozen=True, slots=True)
class Job:
    """A run to be made.

    Args:
        program: the program.
        robot: the robot to run it on.
        options: the options of the run.
        keys: the keys that are pressed during the run.
        with_trace: whether its trace is wanted.
        isolated: whether the program gets a process of its own, even if it is plain.
    """

    program: Program
    robot: RobotEntry
    options: Options
    keys: RecordedKeys | None = None
    with_trace: bool = False
    isolated: bool = False


class Order(msgspec.Struct, frozen=True, array_like=True):
    """What a batch wants.

    Args:
        jobs: the runs.
        at_once: how many are made at the same time.
        limits: the resources that each program may use.
    """

    jobs: tuple[Job, ...]
    at_once: int
    limits: Limits

    def packed(self) -> bytes:
        """The order as bytes, without the trees of the programs, which no run needs."""
        lean = msgspec.structs.replace(self, jobs=tuple(map(_without_tree, self.jobs)))
        return msgspec.msgpack.encode(lean, enc_hook=_encoded)


def unpacked(data: bytes) -> Order:
    """The order from bytes."""
    return msgspec.msgpack.decode(data, type=Order, dec_hook=_decoded)


def _without_tree(job: Job) -> Job:
    program = job.program
    if program.source_map is None:
        return job
    lines = SourceMap(program.source_map.source_lines)
    return replace(job, program=replace(program, source_map=lines))


def _encoded(value: object) -> object:
    if isinstance(value, Path):
        return str(value)
    raise NotImplementedError(type(value))


def _decoded(kind: type, value: Any) -> object:
    return kind(value)
