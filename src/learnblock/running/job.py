"""A run that is asked for, and how a batch sends its runs to the process that makes them."""

from collections.abc import Sequence
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
        limits: the resources that the program may use.
        with_trace: whether its trace is wanted.
        isolated: whether the program gets a process of its own, even if it is plain.
    """

    program: Program
    robot: RobotEntry
    options: Options
    keys: RecordedKeys | None = None
    limits: Limits = Limits()  # noqa: RUF009 - it is frozen
    with_trace: bool = False
    isolated: bool = False


def packed(jobs: Sequence[Job], at_once: int) -> bytes:
    """Jobs as bytes, without the trees of the programs, which no run needs.

    Args:
        jobs: the runs.
        at_once: how many are made at the same time.
    """
    lean = tuple(map(_without_tree, jobs))
    return msgspec.msgpack.encode((lean, at_once), enc_hook=_encoded)


def unpacked(data: bytes) -> tuple[tuple[Job, ...], int]:
    """The jobs from bytes, and how many are made at the same time."""
    return msgspec.msgpack.decode(data, type=tuple[tuple[Job, ...], int], dec_hook=_decoded)


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
