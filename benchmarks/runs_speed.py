"""Measure how much faster than real time whole programs run, by where program and host run.

    python benchmarks/runs_speed.py [--seconds 60] [--rounds 2] [--before PYTHON] [example ...]

With ``--before``, the interpreter of another checkout runs every example too, in turn with this
one, so that a busy machine slows both alike. The columns are of programs with a process of their
own; of those that share a contained process with their host, as `learnblock run` makes it for a
plain program; and of those that take turns with their host in one thread of this process. "ratio"
is the speed of the second by that of the third, for a second of processor. All traces should be the
same. Times are of the processors, for host and program together with its start, and of the wall
clock; the fastest round counts.
"""

import argparse
import os
import platform
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "helpers"))

from runs import EXAMPLES, TWINS, WORLDS  # noqa: E402 - found through the line above

#: Runs one example in another interpreter; its arguments: the way, the program's file, the world,
#: the seconds and the robots.
RUN = """
import os, sys, time
from pathlib import Path
from learnblock import robots, running
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.process import ProcessWorker
from learnblock.runtime.watcher import Watcher

way, path, world, seconds, *twins = sys.argv[1:]
source = running.read(Path(path))
entry = next(entry for entry in map(robots.find, twins) if not [
    one for one in running.check(source, entry) if one.severity == "error"
])
program = running.program(source, entry)

def made(job, way):
    if way == "shared":
        from learnblock.running.shared_run import SharedRun, can_share
        result = SharedRun(job, Watcher()).run() if can_share(job) else None
        if result:
            return result.report
    worker = InlineWorker if way == "thread" else ProcessWorker
    return ProgramRun(job, worker=worker).run()

def run(seconds, way=way):
    job = Job(program, entry, Options(world=world or None, seconds=seconds))
    began, used = time.perf_counter(), sum(os.times()[:4])
    report = made(job, way)
    return time.perf_counter() - began, sum(os.times()[:4]) - used, report

# The first run loads what all runs need, also in a process that is forked from this one.
run(0.1, "thread" if way == "shared" else way)
wall, processor, report = run(float(seconds))
print(entry.name, report.time, wall, processor, report.trace_sha256)
"""


class Measured(NamedTuple):
    """One run, in seconds.

    Args:
        robot: the twin that ran it.
        time: of the robot.
        wall: of the wall clock.
        processor: of the processors.
        sha256: the hash of the trace.
    """

    robot: str
    time: float
    wall: float
    processor: float
    sha256: str


#: The twin to begin with for examples that are meant for one in particular.
MEANT_FOR = {"line-thymio.bt": "sim-thymio"}


class Column(NamedTuple):
    """What runs the examples: an interpreter, and where it runs program and host."""

    title: str
    python: str
    way: str = "process"

    def run(self, example: Path, seconds: float) -> Measured:
        """Run an example once."""
        world = WORLDS.get(example.name, "")
        command = [self.python, "-c", RUN, self.way, str(example), world]
        command += [str(seconds), MEANT_FOR.get(example.name, TWINS[0]), *TWINS]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
        robot, time, wall, processor, sha256 = done.stdout.split()
        return Measured(robot, float(time), float(wall), float(processor), sha256)


def fastest(runs: Sequence[Measured]) -> Measured:
    """The best times of several runs, which must have left the same trace."""
    hashes = {run.sha256 for run in runs}
    if len(hashes) > 1:
        raise SystemExit(f"one program left {len(hashes)} different traces: {', '.join(hashes)}")
    wall, processor = min(run.wall for run in runs), min(run.processor for run in runs)
    return runs[0]._replace(wall=wall, processor=processor)


def compare(
    columns: Sequence[Column], example: Path, seconds: float, rounds: int
) -> list[Measured]:
    """Run an example in each way in turn."""
    runs = [[column.run(example, seconds) for column in columns] for _ in range(rounds)]
    return [fastest(each) for each in zip(*runs, strict=True)]


def row(example: Path, runs: Sequence[Measured]) -> str:
    figures = "".join(f"{x.time / x.processor:9.1f}{x.time / x.wall:8.1f}" for x in runs)
    verdict = "same trace" if len({x.sha256 for x in runs}) == 1 else "OTHER TRACE"
    shared, now = runs[-2:]
    ratio = now.processor / shared.processor
    return f"{example.stem:<13}{now.robot:<12}{figures}{ratio:7.0%}  {now.sha256[:12]} {verdict}"


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("examples", nargs="*", help="names such as avoid; all by default")
    parser.add_argument("--seconds", type=float, default=60.0, help="of the robot's time")
    parser.add_argument("--rounds", type=int, default=2)
    parser.add_argument("--before", help="the interpreter of another checkout")
    return parser.parse_args()


def main() -> None:
    given = arguments()
    columns = [
        *([Column("before", given.before)] if given.before else []),
        *(Column(way, sys.executable, way) for way in ("process", "shared", "thread")),
    ]
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors; times real time")
    titles = "".join(f"{column.title:>9}{'wall':>8}" for column in columns)
    print(f"{'':<25}{titles}{'ratio':>7}")
    for example in sorted(EXAMPLES.glob("*.bt")):
        if not given.examples or example.stem in given.examples:
            runs = compare(columns, example, given.seconds, given.rounds)
            print(row(example, runs), flush=True)


if __name__ == "__main__":
    main()
