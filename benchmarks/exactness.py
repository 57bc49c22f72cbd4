"""Compare what logs show of random moments with what the runs were like then, byte for byte.

python benchmarks/exactness.py [random programs] [moments of each run]

Each run is remembered independently of its log: poses, sensors, joints, lights, goals, drawings,
pictures, and the program's line, functions, variables, `when`s and output. Every third random
program is disturbed by hands that place, tilt and shake its robot.
"""

import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from os import cpu_count
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from learnblock.running import Options
from learnblock.runtime.watcher import Watcher
from runs import EXAMPLES, TASKS, person
from truths import Job, differences, random_job, remembered

PROGRAMS, MOMENTS = 500, 100
#: Seconds of the robot's time for an example; what comes later is more of the same.
LONGEST = 60


@dataclass(frozen=True)
class Compared:
    """The comparison of one run.

    Args:
        name: of the program.
        moments: how many were compared.
        found: what differs.
    """

    name: str
    moments: int
    found: tuple[str, ...]


def example(name: str, moments: int) -> Compared:
    world, seconds = TASKS[name]
    options = Options(world=world, seconds=min(seconds, LONGEST), seed=1, anyway=True)
    return compared(name, Job(EXAMPLES / name, "sim-ebo", options), moments, partial(person, name))


def random_program(seed: int, moments: int) -> Compared:
    with tempfile.TemporaryDirectory() as folder:
        return compared(f"random {seed}", random_job(Path(folder), seed), moments, Watcher, seed)


def compared(
    name: str, job: Job, moments: int, watcher: Callable[[], Watcher], seed: int = 1
) -> Compared:
    run = remembered(job, moments, seed, watcher)
    return Compared(name, len(run.truths), tuple(differences(run, seed)))


def looked_at(job: tuple[str | int, int]) -> Compared:
    subject, moments = job
    if isinstance(subject, str):
        return example(subject, moments)
    return random_program(subject, moments)


def told(one: Compared) -> Compared:
    if one.found:
        print(f"{one.name}: {len(one.found)} differences, such as {one.found[0]}", flush=True)
    return one


def main() -> None:
    programs, moments = (*map(int, sys.argv[1:]), *(PROGRAMS, MOMENTS)[len(sys.argv) - 1 :])
    began = perf_counter()
    jobs = [(name, moments) for name in TASKS] + [(seed, moments) for seed in range(programs)]
    # Each process is replaced after a while: many worlds with cameras need gigabytes of memory.
    with get_context("spawn").Pool(cpu_count(), maxtasksperchild=20) as pool:
        done = [told(one) for one in pool.imap_unordered(looked_at, jobs)]
    wrong = sum(bool(one.found) for one in done)
    print(
        f"{len(TASKS)} examples and {programs} random programs, "
        f"{sum(one.moments for one in done)} moments: {wrong} runs differ "
        f"({perf_counter() - began:.0f} s)"
    )
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
