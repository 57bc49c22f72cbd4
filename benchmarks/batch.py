"""A class's programs at once: half drive, a quarter follows a line by ground sensors, the rest by
camera.

    python benchmarks/batch.py [--runs 300] [--seconds 60]

Prints the seconds of the whole batch, its factor of real time, and the same for a part of the runs
made one after another, each with a process of its own. The seconds of processors are of the warm
process and all its runs; they hardly depend on what else the computer does.
"""

import argparse
import os
from dataclasses import replace
from itertools import cycle, islice
from operator import itemgetter
from pathlib import Path
from time import perf_counter

from learnblock import robots, running
from learnblock.running import Options, ProgramRun
from learnblock.running.batch import Batch
from learnblock.running.job import Job

EXAMPLES = Path(__file__).parents[1] / "examples"
#: Each program with its robot and its world.
CLASS = (
    ("polygons.bt", "sim-ebo", "polygons"),
    ("line-thymio.bt", "sim-thymio", "line"),
    ("avoid.bt", "sim-ebo", "arena"),
    ("line-ebo.bt", "sim-ebo", "line"),
)


def jobs(count: int, seconds: float) -> list[Job]:
    """The runs of a class, each with another seed."""
    made = []
    for seed, (name, robot, world) in enumerate(islice(cycle(CLASS), count)):
        entry = robots.find(robot)
        program = running.program(running.read(EXAMPLES / name), entry)
        made.append(Job(program, entry, Options(world=world, seed=seed, seconds=seconds)))
    return made


def _used() -> float:
    """Seconds of processors that ended children of this process have used."""
    return os.times().children_user + os.times().children_system


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--runs", type=int, default=300)
    parser.add_argument("--seconds", type=float, default=60.0, help="of the robots' time")
    given = parser.parse_args()
    wanted = jobs(given.runs, given.seconds)
    began, used = perf_counter(), _used()
    results = [result for _, result in sorted(Batch(wanted).results(), key=itemgetter(0))]
    batch, used = perf_counter() - began, _used() - used
    simulated = sum(one.report.time for one in results)
    together = simulated / batch
    print(f"{os.cpu_count()} processors, {len(results)} runs of {given.seconds:g} s")
    print(f"batch             {batch:8.1f} s, {together:7.1f} times real time")
    print(f"of processors     {used:8.1f} s, {simulated / used:7.1f} times real time")

    few = wanted[: len(CLASS)]
    began = perf_counter()
    reports = [ProgramRun(job).run() for job in few]
    alone = sum(one.time for one in reports) / (perf_counter() - began)
    print(f"one after another {'':>10} {alone:7.1f} times real time")
    print(f"ratio             {'':>10} {together / alone:7.1f}")
    same = [replace(one.report, output="") for one in results[: len(few)]] == reports
    print("same reports" if same else "OTHER REPORTS")


if __name__ == "__main__":
    main()
