"""Run programs in tests: from a file, a robot and a world to a report and a recorder."""

import io
from dataclasses import dataclass
from pathlib import Path

import msgspec

from learnblock import robots, running
from learnblock.running import Options, ProgramRun, Report
from learnblock.runtime.process import ThreadWorker
from learnblock.runtime.trace import Recorder
from places import ROOT

EXAMPLES = ROOT / "examples"
TWINS = ("sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo")
#: The world for which an example is meant; by default the robot's own.
WORLDS = {
    "avoid.bt": "obstacles",
    "imitate.bt": "faces",
    "labyrinth.bt": "labyrinth",
    "line-ebo.bt": "line",
    "line-states.bt": "line",
    "line-thymio.bt": "line",
    "tag-tour.bt": "tags",
    "tags.bt": "tags",
    "wall.bt": "walls",
}


@dataclass(frozen=True)
class Finished:
    """A finished run."""

    report: Report
    recorder: Recorder
    trace: bytes

    def entries(self, kind: str) -> list[dict[str, object]]:
        """Return the lines of the trace of one kind."""
        lines = (msgspec.json.decode(line) for line in self.trace.splitlines())
        return [line for line in lines if kind in line]


def run_file(path: Path, robot: str, *, worker=ThreadWorker, **options) -> Finished:
    """Run a program's file to its end; the kind of worker does not change its trace."""
    source = running.read(path)
    entry = robots.find(robot)
    trace = io.BytesIO()
    session = ProgramRun(
        running.program(source, entry), entry, Options(**options), trace=trace, worker=worker
    )
    report = session.run()
    assert session.recorder is not None, report.error
    return Finished(report, session.recorder, trace.getvalue())


def run_example(name: str, robot: str, **options) -> Finished:
    """Run one of the examples."""
    return run_file(EXAMPLES / name, robot, **options)
