"""Runs of the examples that several tests make claims on, each made once for all of them.

A run depends only on program, robot, world and seed. So the first test that asks for it makes it,
on whichever worker, and it is kept in a file for all others.
"""

import hashlib
import pickle
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec
import pytest
from filelock import FileLock

from learnblock.devices import Pose
from learnblock.running import Report
from learnblock.runtime.recorder import PlacedEvent
from runs import TASKS, run_example


@dataclass(frozen=True)
class Made:
    """A finished run.

    Args:
        report: its report.
        trace: its trace.
        path: where the robot was, by time in seconds.
        marks: what it showed and said.
    """

    report: Report
    trace: bytes
    path: tuple[tuple[float, Pose], ...]
    marks: tuple[PlacedEvent, ...]

    def entries(self, kind: str) -> list[dict[str, Any]]:
        """Return the lines of the trace of one kind."""
        lines = (msgspec.json.decode(line) for line in self.trace.splitlines())
        return [line for line in lines if kind in line]


@dataclass(frozen=True)
class Runs:
    """Runs that have been made, in a folder.

    Args:
        folder: the folder, which the workers of a session share.
    """

    folder: Path

    def __call__(self, name: str, robot: str, **options: Any) -> Made:
        """Return the run of an example with its `person`; by default for its task."""
        world, seconds = TASKS[name]
        options = {"world": world, "seconds": seconds, **options}
        key = hashlib.sha256(repr((name, robot, sorted(options.items()))).encode()).hexdigest()
        file = self.folder / key
        with FileLock(file.with_suffix(".lock")):
            if not file.exists():
                # A test may be ended while it writes.
                part = file.with_suffix(".part")
                part.write_bytes(pickle.dumps(_make(name, robot, options)))
                part.replace(file)
        run = pickle.loads(file.read_bytes())  # noqa: S301 - our own file
        assert isinstance(run, Made)
        return run


def _make(name: str, robot: str, options: dict[str, Any]) -> Made:
    run = run_example(name, robot, **options)
    return Made(run.report, run.trace, tuple(run.recorder.path), tuple(run.recorder.marks))


@pytest.fixture(scope="session")
def made(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> Runs:
    """Return runs of the examples: ``made(name, robot)``."""
    own = tmp_path_factory.getbasetemp()
    folder = (own if worker_id == "master" else own.parent) / "made-runs"
    folder.mkdir(exist_ok=True)
    return Runs(folder)
