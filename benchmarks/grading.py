"""A class graded: wall time, memory, and the hash of the table, on this computer and on a cluster.

    python benchmarks/grading.py [--lessons driving,line,camera,tag] [--programs 30] [--variants 9]
                                 [--seconds 60] [--jobs 2] [--dask] [--kill]
                                 [--one-run] [--likeness]

Each lesson's programs are its solution and mutants of it; all run for up to 60 s, in the world as
it is and in its variants. `--dask` grades again with two workers of a cluster on this computer, and
`--kill` with one of them killed when a third is done. The hashes have to be the same. The processor
time is that of all processes that this computer's own workers started.

How the time and memory of the grading process grow: `--programs 30 --one-run`, `300` and `3000`,
each in a process of its own; only one run is made, and its result is used for all others.
`--likeness` compares as many different programs, and does nothing else.
"""

import argparse
import hashlib
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import Executor, Future
from contextlib import ExitStack, contextmanager
from functools import partial
from importlib.metadata import version
from itertools import islice
from pathlib import Path
from random import Random
from time import perf_counter, sleep
from typing import Any

from msgspec import structs

from learnblock.lessons.grading.executors import OpenWorkers, Workers, cluster, local
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.likeness import Print, alike
from learnblock.lessons.grading.output import TABLE, write_results
from learnblock.lessons.grading.plan import Plan, graded_attempts
from learnblock.lessons.grading.values import HandedIn
from learnblock.lessons.mutants import mutants
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.reading import find_lesson
from learnblock.lessons.trying import attempts

#: The lesson, its step and the robot of each kind.
KINDS = {
    "driving": ("1-03-square", 5, "sim-ebo"),
    "line": ("2-02-follow-a-line", 5, "sim-thymio"),
    "camera": ("2-02-follow-a-line", 5, "sim-ebo"),
    "tag": ("2-04-tag", 5, "sim-ebo"),
}


def a_class(opened: OpenLesson, step: int, count: int) -> tuple[HandedIn, ...]:
    """The solution and mutants of it, of mutants too if there are not enough; all differ."""
    solution = opened.solution(step) or ""
    found = islice(_programs(solution), count)
    return tuple(HandedIn(f"pupil-{n:04}", f"{n}.bt", text) for n, text in enumerate(found))


def _programs(solution: str) -> Iterator[str]:
    yield solution
    seed = 0
    while True:
        for one in mutants(solution, seed):
            # A comment tells it from the same mutant of another seed: it is a program of its own.
            yield f"{one.source}# {seed}\n" if seed else one.source
        seed += 1


def planned(kind: str, programs: int, variants: int, seconds: float = 60.0) -> Plan:
    name, step, robot = KINDS[kind]
    opened = find_lesson(name)
    steps = [structs.replace(one, seconds=seconds) for one in opened.lesson.step]
    lesson = structs.replace(opened.lesson, step=tuple(steps))
    opened = OpenLesson(opened.name, lesson, opened.teacher, opened.files)
    wanted = attempts(opened, step, robots=[robot], variants=variants)
    whole_class = a_class(opened, step, programs)
    tried = graded_attempts(opened, step, wanted)
    return Plan(opened, step, whole_class, tried, version("learnblock-studio"))


def graded(plan: Plan, workers: OpenWorkers, kill: subprocess.Popen[bytes] | None = None) -> str:
    with tempfile.TemporaryDirectory() as folder, opened_journal(Path(folder)) as journal:
        grading = Grading(plan, journal)
        began, before = perf_counter(), processor_time()
        for progress in grading.run(workers):
            if kill and progress.done >= progress.total // 3:
                kill.send_signal(signal.SIGKILL)
                kill = None
        made = perf_counter() - began
        write_results(grading, Path(folder), "en", lesson=plan.opened.name)
        whole, used = perf_counter() - began, processor_time() - before
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        runs, driven, done = totals(grading)
        page = (Path(folder) / "results.html").stat().st_size
        digest = hashlib.sha256((Path(folder) / TABLE).read_bytes()).hexdigest()
    print(
        f"  {made:7.1f} s, with the page {whole:7.1f} s, processor {used:7.1f} s,"
        f" {driven / made:6.0f} times real time,"
        f" {runs} runs of {driven / runs:.0f} s, {done} done, {memory:.0f} MB,"
        f" page {page / 1e6:.1f} MB, load {os.getloadavg()[0]:.1f}, table {digest[:12]}",
        flush=True,
    )
    return digest


def totals(grading: Grading) -> tuple[int, float, int]:
    """The number of runs, the seconds of the robot's time in them, and how many met all checks."""
    runs, driven, done = 0, 0.0, 0
    for row in grading.rows():
        if row.result:
            runs += 1
            driven += row.result.seconds
            done += all(one.state == "met" for one in row.result.checks)
    return runs, driven, done


class OneRun(Executor):
    """Makes the first piece, and uses its result for all others."""

    def __init__(self) -> None:
        self._made: bytes | None = None

    def submit(self, function: Any, piece: Any, /) -> Any:  # type: ignore[override]
        self._made = self._made or function(piece)
        future: Future[bytes] = Future()
        future.set_result(self._made)
        return future


@contextmanager
def one_run() -> Iterator[Workers]:
    yield Workers(OneRun(), 8)


def processor_time() -> float:
    """Seconds that this process and those that it has waited for have used."""
    used = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(one.ru_utime + one.ru_stime for one in used)


def compare(count: int) -> None:
    """Time the search for programs that are alike among programs of a hundred parts each."""
    random = Random(1)  # noqa: S311 - the same programs each time
    given = [random.getrandbits(63) for _ in range(100)]
    prints = []
    for number in range(count):
        own = [random.getrandbits(63) for _ in range(random.randrange(40))]
        kept = random.sample(given, len(given) - len(own) // 2)
        prints.append(Print(f"{number}", f"{number}", frozenset({*kept, *own})))
    began = processor_time()
    found = alike(prints)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    used = processor_time() - began
    print(f"{count} programs: {found.total} pairs alike, {used:.2f} s, {memory:.0f} MB")


@contextmanager
def dask(workers: int) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    """A cluster on this computer: the address of its scheduler, and its workers."""
    with ExitStack() as stack:
        file = Path(stack.enter_context(tempfile.TemporaryDirectory())) / "scheduler.json"
        _started(stack, "dask_scheduler", "--port", "0", "--scheduler-file", str(file))
        while not (file.exists() and '"address"' in file.read_text()):
            sleep(0.1)
        one = ("dask_worker", "--nthreads", "1", "--no-nanny", "--scheduler-file", str(file))
        yield (
            json.loads(file.read_text())["address"],
            [_started(stack, *one) for _ in range(workers)],
        )


def _started(stack: ExitStack, name: str, *more: str) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", f"distributed.cli.{name}", "--host", "127.0.0.1"]
    process = stack.enter_context(
        subprocess.Popen(
            [*command, "--no-dashboard", *more],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
    )
    stack.callback(process.kill)
    return process


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--lessons", default=",".join(KINDS))
    parser.add_argument("--programs", type=int, default=30)
    parser.add_argument("--variants", type=int, default=9, help="besides the world as it is")
    parser.add_argument("--seconds", type=float, default=60.0, help="of a run, at most")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--one-run", action="store_true")
    parser.add_argument("--likeness", action="store_true")
    parser.add_argument("--dask", action="store_true")
    parser.add_argument("--kill", action="store_true")
    given = parser.parse_args()
    if given.likeness:
        compare(given.programs)
        return
    for kind in given.lessons.split(","):
        plan = planned(kind, given.programs, given.variants, given.seconds)
        print(f"{kind}: {len(plan.handed_in)} programs, {len(plan.attempts)} runs each", flush=True)
        found = {graded(plan, one_run if given.one_run else partial(local, given.jobs))}
        for kills in [False] * given.dask + [True] * given.kill:
            with dask(2) as (address, workers):
                found.add(graded(plan, partial(cluster, address), workers[0] if kills else None))
        print("  same tables" if len(found) == 1 else "  OTHER TABLES", flush=True)


if __name__ == "__main__":
    main()
