"""Errors of distances and angles over ten runs, by twin, surface and speed.

    python benchmarks/ways.py

`drive_distance(500, v)` and `turn(180, w)` are compared with where the robot truly is. Of each
twin and surface the table has the largest error of ten runs at the usual speed, and the fastest
speed, of those that its wheels can turn at, that keeps it within 2 %.
"""

import math
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from learnblock import robots, running
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.process import ThreadWorker
from learnblock.simulator.robot_description import load_robot

TWINS = ("sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo")
#: The part of their rotation that wheels lose.
SURFACES = {"slip 0 %": 0.0, "0.5 %, as usual": 0.005, "1 %": 0.01, "2 %": 0.02}
RUNS = range(10)
WITHIN = 0.02
WORLD = "[floor]\nsize = [3000, 3000]\nslip = {slip}\n\n[[start]]\nx = 0\ny = 0\nheading = 0\n"

Pose = tuple[float, float, float]


class Way(NamedTuple):
    """A movement.

    Args:
        call: its call, with ``{}`` for the speed.
        usual: the speed without an argument.
        speeds: the speeds to try, the fastest first.
        unit: of the speeds.
        rim: returns the mm/s of a wheel's rim at a speed, from the mm between the wheels.
        error: returns the error of a pose after it, as a part of the whole.
    """

    call: str
    usual: int
    speeds: tuple[int, ...]
    unit: str
    rim: Callable[[float, float], float]
    error: Callable[[Pose], float]


DISTANCE = Way(
    "drive_distance(500, {})",
    80,
    (500, 400, 300, 200, 160, 120, 80, 40),
    "mm/s",
    lambda speed, _: speed,
    lambda pose: abs(math.hypot(pose[0], pose[1]) - 500) / 500,
)
ANGLE = Way(
    "turn(180, {})",
    120,
    (360, 270, 180, 120, 90, 60, 30, 15),
    "°/s",
    lambda speed, track: math.radians(speed) * track / 2,
    lambda pose: abs((pose[2] % 360) - 180) / 180,
)


def largest_error(way: Way, speed: int, robot: str, world: Path) -> float:
    """Return the largest error of ten runs, each with its own seed; infinite if one fails."""
    entry = robots.find(robot)
    program = world.with_suffix(".bt")
    program.write_text(f"main:\n    function.{way.call.format(speed)}\nend\n", "utf-8")
    ready = running.program(running.read(program), entry)
    errors = []
    for seed in RUNS:
        options = Options(world=str(world), seed=seed, seconds=120)
        report = ProgramRun(Job(ready, entry, options), worker=ThreadWorker).run()
        ended = report.error is None and report.pose is not None
        errors.append(way.error(report.pose) if ended and report.pose else math.inf)
    return max(errors)


def cell(way: Way, robot: str, world: Path) -> str:
    wheels = load_robot(robot.removeprefix("sim-")).wheels
    possible = [one for one in way.speeds if way.rim(one, wheels.track) <= wheels.maximum_speed]
    usual = largest_error(way, way.usual, robot, world)
    fastest = next(
        (one for one in possible if largest_error(way, one, robot, world) <= WITHIN), None
    )
    found = "none" if fastest is None else f"{fastest} {way.unit}"
    return f"{usual:.1%}; {found}"


def main() -> None:
    for name, way in (("500 mm", DISTANCE), ("180°", ANGLE)):
        print(f"{name}: largest error of {len(RUNS)} runs at {way.usual} {way.unit}; ", end="")
        print(f"fastest speed within {WITHIN:.0%}\n")
        print("| twin | " + " | ".join(SURFACES) + " |")
        print("|---|" + "---|" * len(SURFACES))
        with tempfile.TemporaryDirectory() as folder:
            world = Path(folder) / "floor.toml"
            for robot in TWINS:
                cells = []
                for slip in SURFACES.values():
                    world.write_text(WORLD.format(slip=slip), "utf-8")
                    cells.append(cell(way, robot, world))
                print(f"| `{robot}` | " + " | ".join(cells) + " |", flush=True)
        print()


if __name__ == "__main__":
    main()
