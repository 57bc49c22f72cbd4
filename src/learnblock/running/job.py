"""A run that is asked for, alone, in a team or in a batch, and how a batch sends its runs."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import msgspec

from learnblock.devices import Pose
from learnblock.language.python.source_map import SourceMap
from learnblock.robots import RobotEntry
from learnblock.running.recorded_keys import RecordedKeys
from learnblock.runtime.limits import Limits
from learnblock.runtime.program import Program


@dataclass(frozen=True, slots=True)
class Options:
    """How to run; None leaves the choice to the program, the environment or the robot.

    Args:
        world: the name or path of the world.
        seed: the seed of all noise.
        pace: ``free``, ``real`` or a factor.
        seconds: the limit of the run, in the robot's time.
        variant: the number of the world's variant; 0 is the world as it is drawn.
        start: (x mm, y mm, heading in degrees) where a simulated robot starts.
        network: whether the program may use the network.
        anyway: whether it goes on where it asks for a sense or a device that the robot lacks.
    """

    world: str | None = None
    seed: int | None = None
    pace: str | None = None
    seconds: float | None = None
    variant: int | None = None
    start: Pose | None = None
    network: bool = False
    anyway: bool = False

    @property
    def wishes(self) -> dict[str, Any]:
        """The options for simulated robots only."""
        options = {
            "world": self.world,
            "seed": self.seed,
            "pace": self.pace,
            "variant": self.variant,
            "start": self.start,
        }
        return {name: value for name, value in options.items() if value is not None}


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
    options: Options = Options()
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
