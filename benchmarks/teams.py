"""Several robots in one world, each with its own program: speed, one hash, and one that is lost."""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import cycle, islice
from pathlib import Path
from time import perf_counter

from learnblock import robots, running
from learnblock.running import Job, Options
from learnblock.running.team import TeamReport, TeamRun
from learnblock.runtime.ending import How
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.process import ProcessWorker, Worker
from learnblock.runtime.program import Program

EXAMPLES = Path(__file__).parents[1] / "examples"
#: Programs and robots that a team takes in turn.
PARTS = (
    ("avoid.bt", "sim-ebo"),
    ("wall.bt", "sim-thymio"),
    ("polygons.bt", "sim-ev3"),
    ("patrol.bt", "sim-cozmo"),
    ("several/keeper.bt", "sim-ebo"),
)
TEAMS = (2, 10, 30)
#: Seconds of the world.
SHORT, LONG = 2.0, 12.0
REPEATS = 10
LOST = """\
import signal

from learnblock.robots.sim_ebo import Robot

robot = Robot()
robot.sleep(1)
signal.raise_signal(signal.SIGKILL)
"""


def team(count: int, seconds: float) -> dict[str, Job]:
    """The runs of a team, each with a program of its own, for some seconds of the world."""
    jobs = {}
    for number, (name, robot) in enumerate(islice(cycle(PARTS), count), 1):
        entry = robots.find(robot)
        source = running.read(EXAMPLES / name)
        jobs[f"robot-{number}"] = Job(running.program(source, entry), entry, options(seconds))
    return jobs


def options(seconds: float) -> Options:
    return Options(world="swarm", seconds=seconds)


def run(jobs: dict[str, Job], worker: type[Worker] = ProcessWorker) -> TeamReport:
    """Run a team."""
    return TeamRun(jobs, worker=worker).run()


def factors(count: int, worker: type[Worker]) -> tuple[float, float]:
    """The seconds of the world for one second of real time, and of one processor's time."""
    moments = [_now()]
    for seconds in (SHORT, LONG):
        run(team(count, seconds), worker)
        moments.append(_now())
    # The difference of the two runs is free of the programs' start.
    (real, used), (middle, middle_used), (end, end_used) = moments
    whole = LONG - SHORT
    return (
        whole / ((end - middle) - (middle - real)),
        whole / ((end_used - middle_used) - (middle_used - used)),
    )


def _now() -> tuple[float, float]:
    """Real time, and processor time of this process and of those that have ended."""
    used = os.times()
    return perf_counter(), sum(used[:4])


@contextmanager
def busy(*, is_busy: bool) -> Iterator[None]:
    """Keep a processor busy meanwhile."""
    if not is_busy:
        yield
        return
    with subprocess.Popen([sys.executable, "-c", "while True: pass"]) as process:
        try:
            yield
        finally:
            process.kill()


def hashes(count: int) -> set[str | None]:
    """The different hashes of ten runs in processes, half of them on a busy machine, and of one
    in a thread.
    """
    found = {run(team(count, SHORT), InlineWorker).trace_sha256}
    for number in range(REPEATS):
        with busy(is_busy=number % 2 == 1):
            found.add(run(team(count, SHORT)).trace_sha256)
    return found


def lost(count: int) -> tuple[int, int]:
    """How many programs were killed, and how many others reached the end of the run."""
    first = Job(Program("lost.py", LOST, LOST), robots.find("sim-ebo"), options(SHORT))
    report = run({"lost": first, **team(count - 1, SHORT)})
    endings = [own.ended for own in report.robots.values()]
    return endings.count(How.KILLED), endings.count(How.TIME_LIMIT)


def main() -> None:
    print(f"{os.cpu_count()} processors; seconds of the world for a second")
    for count in TEAMS:
        for title, worker in (("processes", ProcessWorker), ("one thread", InlineWorker)):
            real, used = factors(count, worker)
            row = f"{count:>3} robots in {title:<10} {real:7.1f}   of one processor {used:7.1f}"
            print(row, flush=True)
    for count in TEAMS:
        print(f"{count:>3} robots, {REPEATS + 1} runs: {len(hashes(count))} hash", flush=True)
    for count in TEAMS:
        killed, others = lost(count)
        print(f"{count:>3} robots, {killed} killed: {others} others went on to the end")


if __name__ == "__main__":
    main()
