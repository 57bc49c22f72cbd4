"""Measure how long `learnblock run` takes until the program's first line has run, and to its end.

    python benchmarks/start.py [--rounds 9] [--before PYTHON]

With ``--before``, the interpreter of another checkout runs the program too, in turn with this one,
so that a busy machine slows both alike. Medians, of the wall clock and of the processors; without
the first round, in which Python compiles. The traces should be the same.
"""

import argparse
import os
import platform
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import NamedTuple

EXAMPLE = Path(__file__).parents[1] / "examples" / "first" / "square.bt"
#: Seconds until the first line has run.
AIM = 0.25


class Measured(NamedTuple):
    """One run, in seconds.

    Args:
        first: until the first line has run.
        whole: until the command has ended.
        processors: of host and program together.
        trace: the last line of the report.
    """

    first: float
    whole: float
    processors: float
    trace: str


def run(python: str, program: Path) -> Measured:
    """Run a program that prints first."""
    command = [python, "-m", "learnblock", "run", str(program)]
    # Otherwise every start would compile all modules.
    variables = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    began, used = perf_counter(), _used()
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=variables, text=True
    ) as process:
        assert process.stdout is not None  # noqa: S101 - pipes
        assert process.stderr is not None  # noqa: S101
        process.stdout.readline()
        first = perf_counter() - began
        report = process.stderr.read()
    whole = perf_counter() - began
    if process.returncode:
        raise SystemExit(report)
    return Measured(first, whole, _used() - used, report.splitlines()[-1])


def _used() -> float:
    """Seconds of processors that children of this process have used, once they have ended."""
    return os.times().children_user + os.times().children_system


def printing(folder: str) -> Path:
    """The example, with a print as its first line."""
    program = Path(folder, "square.bt")
    text = EXAMPLE.read_text("utf-8")
    program.write_text(text.replace("main:\n", 'main:\n    print("begun")\n', 1), "utf-8")
    return program


def report(title: str, runs: Sequence[Measured]) -> None:
    first, whole, processors = (median(one[part] for one in runs) for part in range(3))
    print(f"{title:<8} first line {first:6.3f} s   whole {whole:6.3f} s   {processors:6.3f} s used")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--before", help="the interpreter of another checkout")
    given = parser.parse_args()
    pythons = {"before": given.before, "now": sys.executable}
    columns: dict[str, list[Measured]] = {title: [] for title in pythons if pythons[title]}
    with tempfile.TemporaryDirectory() as folder:
        program = printing(folder)
        for _ in range(given.rounds + 1):
            for title, runs in columns.items():
                runs.append(run(pythons[title], program))
    print(f"Python {platform.python_version()}, {os.cpu_count()} processors, {given.rounds} rounds")
    for title, runs in columns.items():
        report(title, runs[1:])
    first = median(one.first for one in columns["now"][1:])
    print(f"aim {AIM:g} s: {'met' if first <= AIM else 'MISSED'}")
    traces = {one.trace for runs in columns.values() for one in runs}
    print("same trace" if len(traces) == 1 else "OTHER TRACE")


if __name__ == "__main__":
    main()
