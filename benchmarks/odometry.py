"""Errors of heading and position after ten squares: each twin, with and without its gyroscope.

At three levels of slip. `odometry.py --page` writes the table into the docs.
"""

import math
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from statistics import fmean
from unittest.mock import patch

from msgspec.structs import replace

from learnblock import robots, running
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.process import ThreadWorker

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from every_robot import write_part

TWINS = ("sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo")
SLIPS = (0.0, 0.005, 0.02)
SEEDS = range(5)
WORLD = "[floor]\nsize = [3000, 3000]\nslip = {slip}\n\n[[start]]\nx = -300\ny = 300\nheading = 0\n"
SQUARES = """\
main:
    repeat 40:
        function.move_straight(100)
        function.sleep(2)
        function.stop_bot()
        function.turn(90)
    end
end
"""


def errors(robot: str, slip: float, seed: int, folder: Path) -> tuple[float, float]:
    """Return the errors of a run: degrees of heading, and mm of position."""
    world, program = folder / "squares.toml", folder / "squares.bt"
    world.write_text(WORLD.format(slip=slip), "utf-8")
    program.write_text(SQUARES, "utf-8")
    entry = robots.find(robot)
    options = Options(world=str(world), seed=seed, seconds=600)
    ready = running.program(running.read(program), entry)
    report = ProgramRun(Job(ready, entry, options), worker=ThreadWorker).run()
    if report.pose is None:
        raise SystemExit(f"{robot} did not run: {report.error}")
    x, y, heading = report.pose
    return abs((heading + 180) % 360 - 180), math.hypot(x + 300, y - 300)


@contextmanager
def without_gyroscope(robot: str) -> Iterator[None]:
    """Take the gyroscope of a twin away."""
    kind = robots.find(robot).load()
    less = replace(kind.description(), gyroscope=None)  # type: ignore[attr-defined]
    with patch.object(kind, "description", classmethod(lambda _: less)):
        yield


def row(robot: str, served: str, folder: Path) -> str:
    """Return the line of a twin: the mean errors at each slip."""
    cells = []
    for slip in SLIPS:
        found = [errors(robot, slip, seed, folder) for seed in SEEDS]
        heading, place = map(fmean, zip(*found, strict=True))
        cells.append(f"{heading:.0f}°, {place:.0f} mm")
    return f"| `{robot}` | {served} | " + " | ".join(cells) + " |"


def table() -> Iterator[str]:
    """The lines of the table."""
    yield "| twin | heading by | " + " | ".join(f"slip {slip:.1%}" for slip in SLIPS) + " |"
    yield "|---|---|" + "---|" * len(SLIPS)
    with tempfile.TemporaryDirectory() as name:
        for robot in TWINS:
            if "Gyroscope" in robots.find(robot).load().known_equipment():
                yield row(robot, "gyroscope", Path(name))
                with without_gyroscope(robot):
                    yield row(robot, "wheels", Path(name))
            else:
                yield row(robot, "wheels", Path(name))


def main() -> None:
    lines = []
    for line in table():
        print(line, flush=True)
        lines.append(line)
    if "--page" in sys.argv:
        write_part("odometry", "\n".join(lines))


if __name__ == "__main__":
    main()
