"""Measure what the log of a run costs: time, size and memory, beside the same run without one.

python benchmarks/logs.py [example ...]

Runs with a log and without take turns, and a ratio is the median of the ratios of neighbours, so
that other work on the computer slows both; "worked" is the ratio of processor times. A log needs as
much memory as its packed file is long; the column after the reading time is the memory needed to
read it. To measure another version of Python, run this file with it.
"""

import platform
import statistics
import sys
import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass
from os import cpu_count, getloadavg, times
from time import perf_counter

from learnblock import robots, running
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program
from learnblock.why import EventHistory
from learnblock.why.moments import Moments
from learnblock.why.recorded import Recorded
from learnblock.why.world_again import WorldAgain

EXAMPLES = (
    "avoid",
    "flower",
    "labyrinth",
    "line-states",
    "line-thymio",
    "patrol",
    "square",
    "tags",
    "watch-out",
)
SECONDS = 60
ROUNDS = 5
#: A calculation without a robot's time.
COMPUTING = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()


def fib(n):
    if n < 2:
        return n
    return fib(n - 1) + fib(n - 2)


total = 0
i = 0
while i < 300000:
    i += 1
    if i % 3 == 0 and total < 1000000:
        total = total + i % 7
print(total, fib(20))
"""
#: So many moments are shown again, in an order that jumps back and forth.
MOMENTS = 40


@dataclass(frozen=True)
class Case:
    """A program and its robot."""

    name: str
    program: Program
    robot: robots.RobotEntry


def example(name: str) -> Case:
    source = running.read(running.example(f"{name}.bt"))
    robot = running.choose_robot(source, None)
    return Case(name, running.program(source, robot), robot)


@dataclass(frozen=True)
class Taken:
    """What a run took.

    Args:
        seconds: by the wall clock.
        worked: seconds of processor time, of host and program.
        sha256: the hash of its trace.
    """

    seconds: float
    worked: float
    sha256: str


def run(case: Case, log: RunLog | None) -> Taken:
    options = Options(seed=0, pace="free", seconds=SECONDS)
    prepared = ProgramRun(Job(case.program, case.robot, options), log=log)
    began, worked = perf_counter(), processor_time()
    report = prepared.run()
    return Taken(perf_counter() - began, processor_time() - worked, report.trace_sha256)


def processor_time() -> float:
    """Return the seconds that this process and those it has waited for have worked."""
    return sum(times()[:4])


def measure(case: Case) -> None:
    without, logged, ratios, worked = [], [], [], []
    for _ in range(ROUNDS):
        plain = run(case, None)
        log = RunLog(case.program)
        told = run(case, log)
        if plain.sha256 != told.sha256:
            sys.exit(f"{case.name}: the trace is another one with a log")
        without.append(plain.seconds)
        logged.append(told.seconds)
        ratios.append(told.seconds / plain.seconds)
        worked.append(told.worked / plain.worked)
    blocks = log.blocks
    packed = sum(len(block.packed) for block in blocks)
    whole = sum(len(block.data) for block in blocks)
    began = perf_counter()
    recorded = Recorded.of(blocks)
    history = EventHistory(recorded)
    Moments(history)
    reading = perf_counter() - began
    memory = memory_of(lambda: Moments(EventHistory(Recorded.of(blocks))))
    print(
        f"{case.name:12} {statistics.median(without):8.2f} s {statistics.median(logged):8.2f} s"
        f" {statistics.median(ratios):6.2f} {statistics.median(worked):6.2f}"
        f" {len(history.events):9} {whole / 1000:8.0f} kB"
        f" {packed / 1000:7.0f} kB {reading:7.2f} s {memory / 1e6:7.1f} MB"
        f" {seeking(recorded):8.0f} ms",
        flush=True,
    )


def memory_of(make: Callable[[], object]) -> int:
    """Return the bytes that something takes in memory."""
    tracemalloc.start()
    made = make()
    size = tracemalloc.get_traced_memory()[0]
    tracemalloc.stop()
    del made
    return size


def seeking(recorded: Recorded) -> float:
    """Return the ms until a moment anywhere in the run is shown, 95 of 100 times."""
    world = WorldAgain(recorded)
    taken = []
    for step in range(MOMENTS):
        began = perf_counter()
        world.seek(SECONDS * (step * 17 % MOMENTS) / MOMENTS)
        taken.append(perf_counter() - began)
    return 1000 * sorted(taken)[int(0.95 * MOMENTS)]


def main() -> None:
    print(f"Python {platform.python_version()}, {cpu_count()} processors,", end=" ")
    print(f"load {getloadavg()[0]:.1f}; {SECONDS} s of the robot's time, medians of {ROUNDS}")
    print(
        "              without   with log   ratio worked    events     size   packed (kept)"
        " reading    read  any moment"
    )
    names = sys.argv[1:] or EXAMPLES
    for name in names:
        measure(example(name))
    if not sys.argv[1:]:
        program = Program("computing.py", COMPUTING, COMPUTING)
        measure(Case("computing", program, robots.find("sim-ebo")))


if __name__ == "__main__":
    main()
