"""Errors of heading and position after ten squares: each twin, at three levels of slip."""

import math
import tempfile
from pathlib import Path
from statistics import fmean

from learnblock import robots, running
from learnblock.running import Options, ProgramRun
from learnblock.runtime.process import ThreadWorker

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
    report = ProgramRun(ready, entry, options, worker=ThreadWorker).run()
    if report.pose is None:
        raise SystemExit(f"{robot} did not run: {report.error}")
    x, y, heading = report.pose
    return abs((heading + 180) % 360 - 180), math.hypot(x + 300, y - 300)


def main() -> None:
    print("| twin | " + " | ".join(f"slip {slip:.1%}" for slip in SLIPS) + " |")
    print("|---|" + "---|" * len(SLIPS))
    with tempfile.TemporaryDirectory() as name:
        for robot in TWINS:
            cells = []
            for slip in SLIPS:
                found = [errors(robot, slip, seed, Path(name)) for seed in SEEDS]
                heading, place = map(fmean, zip(*found, strict=True))
                cells.append(f"{heading:.0f}°, {place:.0f} mm")
            print(f"| `{robot}` | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
