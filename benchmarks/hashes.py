"""Compare the traces of the examples between versions of Python and conditions of the machine.

    python benchmarks/hashes.py [seconds of simulated time] [--twins] [--quiet]

Every supported Python on this computer runs every example in each way: in a process of its own, in
the thread of its host, and in a process forked from a warm one; quiet, and with two busy processes
for each processor, unless `--quiet` leaves that out. It runs on the first twin that is able to, or
with `--twins` on each, and the keys of `examples/remote-control.jsonl` are pressed meanwhile. A row
with two values is a failure. An example that ended with an error, such as one that asks a person
for input, has the code of the error, too.
"""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "helpers"))

from pythons import VERSIONS, interpreters  # noqa: E402 - found through the line above

CONDITIONS = ("quiet", "loaded")
WAYS = ("process", "thread", "warm")
RUN = """
import sys
from learnblock import robots, running
from learnblock.running import Job, Options, ProgramRun
from learnblock.running.batch import Batch
from learnblock.running.recorded_keys import read_keys
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.process import ProcessWorker
from runs import EXAMPLES, TASKS, TWINS, Presser

KEYS = read_keys(EXAMPLES / "remote-control.jsonl")

def able(name):
    source = running.read(EXAMPLES / name)
    return [twin for twin in TWINS if not [
        one for one in running.check(source, robots.find(twin)) if one.severity == "error"
    ]]

def job(name, twin):
    robot = robots.find(twin)
    options = Options(world=TASKS[name][0], seconds=float(sys.argv[1]))
    return Job(running.program(running.read(EXAMPLES / name), robot), robot, options, KEYS)

def reports(jobs):
    if sys.argv[2] == "warm":
        return [one.report for _, one in sorted(Batch(jobs).results(), key=lambda one: one[0])]
    worker = {"process": ProcessWorker, "thread": InlineWorker}[sys.argv[2]]
    return [ProgramRun(job, worker=worker, watcher=Presser(KEYS)).run() for job in jobs]

most = None if sys.argv[3] == "twins" else 1
pairs = [(name, twin) for name in sorted(TASKS) for twin in able(name)[:most]]
jobs = [job(*pair) for pair in pairs]
for (name, twin), report in zip(pairs, reports(jobs), strict=True):
    error = report.error["message"].code if report.error else ""
    print(f"{name}@{twin}", report.trace_sha256[:12], error)
"""


def installed(version: str, python: Path) -> Path:
    """Install LearnBlock for an interpreter, and return the interpreter with it."""
    folder = ROOT / "build" / "pythons" / version
    variables = {**os.environ, "UV_PROJECT_ENVIRONMENT": str(folder)}
    command = ["uv", "sync", "--quiet", "--no-dev", "--python", str(python)]
    subprocess.run(command, cwd=ROOT, env=variables, check=True)
    return folder / "bin" / "python"


def traces(python: Path, seconds: str, way: str, twins: str) -> dict[str, str]:
    """Run every example in one of the ways; return the hash of its trace, by example and twin."""
    variables = {**os.environ, "PYTHONPATH": str(ROOT / "tests" / "helpers")}
    command = [python, "-c", RUN, seconds, way, twins]
    done = subprocess.run(command, env=variables, stdout=subprocess.PIPE, text=True, check=True)
    lines = (line.partition(" ") for line in done.stdout.splitlines())
    return {name: value.strip() for name, _, value in lines}


@contextmanager
def machine(condition: str) -> Iterator[None]:
    """Keep the processors busy while the machine is loaded."""
    count = 0 if condition == "quiet" else 2 * (os.cpu_count() or 1)
    busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for process in busy:
            process.kill()
            process.wait()


def main() -> None:
    words = [word for word in sys.argv[1:] if not word.startswith("--")]
    seconds = words[0] if words else "8"
    twins = "twins" if "--twins" in sys.argv else "first"
    conditions = CONDITIONS[:1] if "--quiet" in sys.argv else CONDITIONS
    columns: dict[str, dict[str, str]] = {}
    found = interpreters()
    for version in VERSIONS:
        if not any(full.startswith(f"{version}.") for full in found):
            print(f"Python {version} is not on this computer")
    for version, interpreter in found.items():
        python = installed(version, interpreter)
        for condition in conditions:
            with machine(condition):
                for way in WAYS:
                    columns[f"{version} {condition} {way}"] = traces(python, seconds, way, twins)
    report(columns)


def report(columns: dict[str, dict[str, str]]) -> None:
    """Print the value of each example, and where others were found.

    Args:
        columns: the value of every example, by version, condition and way.
    """
    print(f"{len(columns)} columns: {', '.join(columns)}")
    different = []
    for name in next(iter(columns.values())):
        value, *others = _places(columns, name).items()
        print(f"{name:<36}{value[0]:<36}{len(value[1]):>3} the same", flush=True)
        for other, places in others:
            different.append(name)
            print(f"{'':<36}{other:<36}{len(places):>3} OTHERS: {', '.join(places)}")
    if different:
        sys.exit(f"more than one value: {', '.join(dict.fromkeys(different))}")
    print("one value each")


def _places(columns: dict[str, dict[str, str]], name: str) -> dict[str, list[str]]:
    """The columns with each value of an example."""
    places: dict[str, list[str]] = {}
    for column, values in columns.items():
        places.setdefault(values[name], []).append(column)
    return places


if __name__ == "__main__":
    main()
