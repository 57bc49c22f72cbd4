"""Compare the traces of the examples between versions of Python and conditions of the machine.

    python benchmarks/hashes.py [seconds of simulated time]

Every version of Python that uv finds on this computer runs every example in each way: in a process
of its own, in the thread of its host, and in a process forked from a warm one; quiet, and with two
busy processes for each processor. A row with two values is a failure.
"""

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "helpers"))

from pythons import VERSIONS, interpreter  # noqa: E402 - found through the line above

CONDITIONS = ("quiet", "loaded")
WAYS = ("process", "thread", "warm")
RUN = """
import sys
from learnblock import robots, running
from learnblock.running import Options, ProgramRun
from learnblock.running.batch import Batch
from learnblock.running.job import Job
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.process import ProcessWorker
from runs import EXAMPLES, TWINS, WORLDS

def job(path):
    source = running.read(path)
    robot = next(robot for robot in map(robots.find, TWINS) if not [
        one for one in running.check(source, robot) if one.severity == "error"
    ])
    options = Options(world=WORLDS.get(path.name), seconds=float(sys.argv[1]))
    return Job(running.program(source, robot), robot, options)

def reports(jobs):
    if sys.argv[2] == "warm":
        return [one.report for one in sorted(Batch(jobs).results(), key=lambda one: one.job)]
    worker = {"process": ProcessWorker, "thread": InlineWorker}[sys.argv[2]]
    runs = (ProgramRun(one.program, one.robot, one.options, worker=worker) for one in jobs)
    return [run.run() for run in runs]

paths = sorted(EXAMPLES.glob("*.bt"))
for path, report in zip(paths, reports([*map(job, paths)]), strict=True):
    print(path.name, report.trace_sha256 if report.error is None else report.error["message"])
"""


def installed(version: str, python: Path) -> Path:
    """Install LearnBlock for an interpreter, and return the interpreter with it."""
    folder = ROOT / "build" / "pythons" / version
    variables = {**os.environ, "UV_PROJECT_ENVIRONMENT": str(folder)}
    command = ["uv", "sync", "--quiet", "--no-dev", "--python", str(python)]
    subprocess.run(command, cwd=ROOT, env=variables, check=True)
    return folder / "bin" / "python"


def traces(python: Path, seconds: str, way: str) -> dict[str, str]:
    """Run every example in one of the ways; return the hash of its trace."""
    variables = {**os.environ, "PYTHONPATH": str(ROOT / "tests" / "helpers")}
    command = [python, "-c", RUN, seconds, way]
    done = subprocess.run(command, env=variables, stdout=subprocess.PIPE, text=True, check=True)
    return {name: value for name, _, value in (x.partition(" ") for x in done.stdout.splitlines())}


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
    seconds = sys.argv[1] if len(sys.argv) > 1 else "8"
    columns: dict[str, dict[str, str]] = {}
    for version in VERSIONS:
        python = interpreter(version)
        if python is None:
            print(f"Python {version} is not on this computer")
            continue
        python = installed(version, python)
        for condition in CONDITIONS:
            with machine(condition):
                for way in WAYS:
                    columns[f"{version} {condition} {way}"] = traces(python, seconds, way)
    report(columns)


def report(columns: dict[str, dict[str, str]]) -> None:
    for part in zip(*(column.split() for column in columns), strict=True):
        print(f"{'':<16}" + "".join(f"{name:<14}" for name in part))
    examples = {name for column in columns.values() for name in column}
    rows = {name: [column.get(name, "-") for column in columns.values()] for name in examples}
    for name, values in sorted(rows.items()):
        print(f"{name:<16}" + "".join(f"{value[:12]:<14}" for value in values))
    different = sorted(name for name, values in rows.items() if len(set(values)) > 1)
    print(f"{len(rows)} examples, {len(different)} with more than one value")
    if different:
        sys.exit(f"more than one value: {', '.join(different)}")


if __name__ == "__main__":
    main()
