"""What a kernel takes: its memory after 100 cells, and the cost of noting what cells do.

    python benchmarks/notebooks.py [cells]

Kernels run 100 cells each. In the first, one robot drives a square side by side, and is shown after
each cell; in the second, each cell makes another robot, as when a pupil runs the same cell again
and again; in the third it also ends with that robot, which Jupyter keeps in `Out`; the last one
only calculates. Megabytes are those of the kernel's process. The last
line shows how long a cell takes that only calculates, without a robot and with one, whose cells
are noted.
"""

import sys
from pathlib import Path
from time import perf_counter

import psutil

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from kernels import Kernel, kernel

MADE = "from learnblock.robots.sim_ebo import Robot\nrobot = Robot(world='square')\n"
DRIVE = "robot.drive_distance(200)\nrobot.turn(90)\n"
CELLS = {
    "one robot, shown": (f"{MADE}robot.show()", DRIVE),
    "a robot in each": (MADE, f"robot = Robot(world='square')\n{DRIVE}"),
    "each kept in Out": (MADE, f"robot = Robot(world='square')\n{DRIVE}robot"),
    "no robot": ("x = 0", "for i in range(1000):\n    x = x + i"),
}
#: A calculation whose steps would be noted.
WORK = "total = 0\nfor i in range(300_000):\n    if i % 3:\n        total = total + i"
#: Cells after which the memory is looked at.
LOOKS = (0.1, 0.5, 1.0)
#: A cell's time is the best of so many.
TRIES = 5


def megabytes(there: Kernel) -> float:
    return psutil.Process(there.manager.provisioner.pid).memory_info().rss / 2**20


def memory(first: str, cell: str, number: int) -> list[float]:
    """Return the megabytes after the first cell, and after parts of the others."""
    with kernel() as there:
        there.run(first)
        taken = [megabytes(there)]
        looks = {round(look * number) for look in LOOKS}
        for count in range(1, number + 1):
            there.outputs(cell)
            if count in looks:
                taken.append(megabytes(there))
        return taken


def seconds(first: str) -> float:
    """Return how long a cell takes that calculates, after a first one."""
    with kernel() as there:
        there.run(first)
        times = []
        for _ in range(TRIES):
            begun = perf_counter()
            there.run(WORK)
            times.append(perf_counter() - begun)
        return min(times)


def main() -> None:
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    print("MB after".ljust(20), "first cell", *(f"{look * number:10.0f}" for look in LOOKS))
    for name, (first, cell) in CELLS.items():
        print(name.ljust(20), *(f"{taken:10.1f}" for taken in memory(first, cell, number)))
    without, noted = seconds("x = 0"), seconds(MADE)
    print(f"a calculation: {without:.3f} s, noted {noted:.3f} s, ratio {noted / without:.2f}")


if __name__ == "__main__":
    main()
