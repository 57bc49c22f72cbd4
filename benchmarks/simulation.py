"""Measure the embedded world: microseconds per step, and the factor of real time.

    python benchmarks/simulation.py [seconds of simulated time]

Robots drive in circles in the world `obstacles`, bump into each other, and read their sensors at 20
Hz, like a program.
"""

import platform
import sys
import time
from dataclasses import dataclass

from learnblock.simulator import RobotBody, World, load_robot, load_world

STEPS_BETWEEN_READINGS = 5
ROBOTS = (1, 10, 30)


@dataclass(frozen=True, slots=True)
class Measured:
    """Return the wall time for a stretch of simulated time, both in seconds."""

    wall: float
    simulated: float

    @property
    def microseconds_a_step(self) -> float:
        return self.wall / (self.simulated * 100) * 1e6

    @property
    def times_real_time(self) -> float:
        return self.simulated / self.wall


def measure(robots: int, seconds: float, *, sensing: bool, camera: bool = False) -> Measured:
    world = World(load_world("obstacles"))
    bodies = [world.add_robot(load_robot("ebo"), f"robot {i}") for i in range(robots)]
    for number, body in enumerate(bodies):
        body.drive(60, 20 + number)
    steps = round(seconds / world.dt)
    began = time.perf_counter()
    for step in range(steps):
        world.step()
        if sensing and step % STEPS_BETWEEN_READINGS == 0:
            read(bodies, camera=camera)
    return Measured(time.perf_counter() - began, seconds)


def read(bodies: list[RobotBody], *, camera: bool) -> None:
    for body in bodies:
        body.distances()
        if camera:
            body.frame()


def loading() -> float:
    began = time.perf_counter()
    World(load_world("labyrinth")).add_robot(load_robot("thymio"))
    return time.perf_counter() - began


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 20.0
    print(f"Python {platform.python_version()}, {seconds:g} s of simulated time")
    print(f"a world and a robot from their files: {loading() * 1000:.1f} ms")
    print(f"{'robots':>6} {'reading':>22} {'µs a step':>10} {'times real time':>16}")
    for robots in ROBOTS:
        for reading in ("nothing", "distances at 20 Hz"):
            measured = measure(robots, seconds, sensing=reading != "nothing")
            report(robots, reading, measured)
    measured = measure(1, seconds / 4, sensing=True, camera=True)
    report(1, "camera at 20 Hz", measured)


def report(robots: int, reading: str, measured: Measured) -> None:
    print(
        f"{robots:>6} {reading:>22} {measured.microseconds_a_step:>10.1f} "
        f"{measured.times_real_time:>16.0f}"
    )


if __name__ == "__main__":
    main()
