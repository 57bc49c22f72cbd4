"""Measure the Thymio in Aseba's playground: its units, its update rate, the cost of a call.

Run it with ``python benchmarks/robots_thymio.py``; it needs Debian's packages aseba,
dbus-daemon and libglib2.0-bin, and prints

- the speed of a wheel at motor speed 1 and the distance between the wheels, by driving and turning;
- a distance sensor's readings at known distances from a wall, and our table's results for them;
- how often readings are updated, compared with the playground's step of 30 ms;
- the cost of a motor command through our layers, compared with `thymiodirect`'s own connection.
"""

import math
import socket
import statistics
import sys
import threading
from collections.abc import Callable
from contextlib import closing
from itertools import cycle
from pathlib import Path
from time import monotonic, perf_counter, sleep

from thymiodirect.connection import RemoteNode
from thymiodirect.message import Message

from learnblock.devices import Base, DistanceSensors
from learnblock.robots.thymio import Robot, units
from learnblock.simulator.geometry import Pose

TESTS = Path(__file__).parents[1] / "tests" / "helpers"
sys.path.insert(0, str(TESTS))

from playground import Playground, missing  # noqa: E402 - found through the line above

#: Distance from the robot's middle to its front sensor in mm.
FRONT = 79.5
SAMPLES = 12


def speed(ground: Playground, robot: Robot) -> tuple[float, float]:
    """Return (mm/s at motor speed 1, wheel distance in mm), measured over about two seconds."""
    motors = robot._motors  # noqa: SLF001 - needs raw motor units
    ground.pose = Pose(-800, 0, 0)
    begin, end, seconds = driven(ground, lambda: motors.drive(300, 300), lambda: motors.drive(0, 0))
    unit = math.hypot(end.x - begin.x, end.y - begin.y) / seconds / 300
    begin, end, seconds = driven(
        ground, lambda: motors.drive(100, -100), lambda: motors.drive(0, 0)
    )
    turned = math.radians(end.heading - begin.heading)
    return unit, 2 * 100 * unit * seconds / turned


def driven(
    ground: Playground, begin: Callable[[], None], end: Callable[[], None]
) -> tuple[Pose, Pose, float]:
    """Return its position at two moments of a steady drive, and the seconds between them."""
    begin()
    sleep(0.5)
    first, began = ground.pose, monotonic()
    sleep(2)
    second, seconds = ground.pose, monotonic() - began
    end()
    sleep(0.3)
    return first, second, seconds


def proximity(ground: Playground, robot: Robot, distance: float) -> list[int]:
    """Return the front sensor's reading this many mm from the border."""
    border = ground.world.floor.size[0] / 2
    ground.pose = Pose(border - FRONT - distance, 0, 0)
    sleep(0.15)
    link = robot._link  # noqa: SLF001
    readings = []
    for _ in range(SAMPLES):
        sleep(0.035)
        readings.append(link.read("prox.horizontal")[2])
    return readings


def renewals(robot: Robot) -> float:
    """Return the number of updates of the readings per second."""
    link = robot._link  # noqa: SLF001
    seen, began = 0, monotonic()
    last = None
    while monotonic() - began < 3:
        values = link._values  # noqa: SLF001
        if values is not last:
            seen, last = seen + 1, values
        sleep(0.001)
    return seen / 3


def cost(work: Callable[[], object], times: int = 2000) -> float:
    """Return the microseconds of one call, the best of five rounds."""
    rounds = []
    for _ in range(5):
        began = perf_counter()
        for _ in range(times // 5):
            work()
        rounds.append((perf_counter() - began) / (times // 5) * 1e6)
        sleep(0.5)
    return min(rounds)


def bare(port: int) -> tuple[float, float]:
    """Return the microseconds of setting both motors and reading a variable by `thymiodirect`.

    Only its messages and its description of a node are used: its own TCP connection mistakes half a
    message for a whole one, and soon fails.
    """
    node = RemoteNode(1)
    for name in units.SOUNDS:
        node.add_var(name, 7)
    node.reset_var_data()
    lock = threading.Lock()

    def read() -> list[int]:
        with lock:
            return node.get_var_array("collision")

    with socket.create_connection(("127.0.0.1", port)) as wire:

        def drive() -> None:
            for place in (57, 58):
                payload = Message.uint16array_to_bytes([1, place, 0])
                wire.sendall(Message(Message.ID_SET_VARIABLES, 1, payload).serialize())

        return cost(drive), cost(read)


def main() -> None:
    """Measure and print everything."""
    with closing(Playground("empty")) as ground:
        with Robot(**ground.settings) as robot:
            unit, track = speed(ground, robot)
            print(f"a wheel at motor speed 1: {unit:.4f} mm/s; between the wheels: {track:.1f} mm")
            print("\nmm to a wall   sensor reads (least, median, most)   as mm by our table")
            for distance in (0, 5, 10, 15, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120, 130, 140):
                readings = proximity(ground, robot, distance)
                median = round(statistics.median(readings))
                made = units.distance(median)
                spread = f"{min(readings):>10} {median:>6} {max(readings):>6}"
                print(f"{distance:>12} {spread} {made:>20.0f}")
            print(f"\nreadings renewed {renewals(robot):.1f} times a second; the playground's 33.3")
            base = robot.device(Base)
            # The driver does not send the same speeds again.
            speeds = cycle((10, 20))
            ours = (
                cost(lambda: base.move(next(speeds), 0)),
                cost(robot.device(DistanceSensors).read),
            )
        library = bare(ground.settings["port"])
        print(f"\nmove: {ours[0]:.1f} us, by thymiodirect alone {library[0]:.1f} us")
        print(f"read: {ours[1]:.1f} us, by thymiodirect alone {library[1]:.1f} us")


if __name__ == "__main__":
    if missing():
        raise SystemExit(missing())
    main()
