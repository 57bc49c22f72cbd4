"""Running programs in tests: a file, a robot and a world, to a report and a recorder."""

import io
from dataclasses import dataclass
from pathlib import Path

import msgspec

from learnblock import robots, running
from learnblock.running import Options, Report, Session
from learnblock.runtime.process import ProcessWorker
from learnblock.runtime.trace import Recorder

EXAMPLES = Path(__file__).parents[1] / "examples"
TWINS = ("sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo")
#: The world in which an example makes sense; a robot's own where none is named.
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
    """A run that is over."""

    report: Report
    recorder: Recorder
    trace: bytes

    def entries(self, kind: str) -> list[dict[str, object]]:
        """The lines of the trace of one kind."""
        lines = (msgspec.json.decode(line) for line in self.trace.splitlines())
        return [line for line in lines if kind in line]


def run_file(path: Path, robot: str, *, worker=ProcessWorker, **options) -> Finished:
    """Run a program's file to its end."""
    source = running.read(path)
    entry = robots.find(robot)
    trace = io.BytesIO()
    session = Session(
        running.program(source, entry), entry, Options(**options), trace=trace, worker=worker
    )
    report = session.run()
    assert session.recorder is not None, report.error
    return Finished(report, session.recorder, trace.getvalue())


def run_example(name: str, robot: str, **options) -> Finished:
    """Run one of the examples."""
    return run_file(EXAMPLES / name, robot, **options)
