"""How soon a robot reacts over its wire, and how soon a program learns what it measures.

Run it with ``python benchmarks/reactions.py [--rounds 30] [ROBOT...]``. Each robot is emulated, and
its driver moves it in real time. The first two columns are the milliseconds from a command to
wheels that turn, median and 95 %; the next two are those from a twin that has moved by 2 mm to
odometry that says so. Emulators have no radio: Bluetooth adds the time of one or two of its
intervals, 15 to 50 ms each.
"""

import argparse
import os
import statistics
import tempfile
from collections.abc import Callable
from time import perf_counter, sleep

from learnblock.devices import Base
from learnblock.emulators import TWINS, Twin, emulate
from learnblock.robots import connect

#: Seconds between two looks, and the longest wait.
LOOK, LONGEST = 0.0005, 3.0
#: mm by which the twin moves until odometry is asked.
MOVED = 2.0
#: mm/s.
SPEED = 60.0


def until(happened: Callable[[], bool]) -> float:
    """Return the milliseconds until something has happened."""
    begun = perf_counter()
    while not happened():
        if perf_counter() - begun > LONGEST:
            raise TimeoutError(f"it took more than {LONGEST} s")
        sleep(LOOK)
    return 1000 * (perf_counter() - begun)


def rolled(twin: Twin) -> float:
    with twin.body() as body:
        return body.wheels_rolled[0]


def stand(twin: Twin) -> None:
    """Wait until the wheels have not turned for a tenth of a second."""
    before = None
    while before != (before := rolled(twin)):
        sleep(0.1)


def of_command(twin: Twin, base: Base, speed: float) -> float:
    """Return the milliseconds from a command to wheels that turn."""
    begun = rolled(twin)
    start = perf_counter()
    base.move(speed, 0)
    sent = 1000 * (perf_counter() - start)
    return sent + until(lambda: rolled(twin) != begun)


def of_odometry(twin: Twin, base: Base) -> float:
    """Return the milliseconds from wheels that have rolled on to odometry that says so."""
    x, here = base.pose()[0], rolled(twin)
    until(lambda: abs(rolled(twin) - here) > MOVED)
    return until(lambda: abs(base.pose()[0] - x) > MOVED)


def reactions(name: str, rounds: int) -> tuple[list[float], list[float]]:
    """Return the milliseconds of each round: of commands, and of odometry, if it is measured."""
    commands, readings = [], []
    with emulate(name, "empty") as emulation, connect(name, **emulation.settings) as robot:
        base = robot.device(Base)
        for number in range(rounds):
            stand(emulation.twin)
            commands.append(of_command(emulation.twin, base, -SPEED if number % 2 else SPEED))
            if base.has_odometry:
                readings.append(of_odometry(emulation.twin, base))
            base.stop()
    return commands, readings


def spelled(times: list[float]) -> str:
    if not times:
        return f"{'-':>8}{'-':>8}"
    return f"{statistics.median(times):8.1f}{statistics.quantiles(times, n=20)[-1]:8.1f}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("robots", nargs="*", default=sorted(TWINS))
    parser.add_argument("--rounds", type=int, default=30)
    options = parser.parse_args()
    print(f"{'robot':<13}{'command':>16}{'odometry':>16}  ms (median, 95 %)")
    with tempfile.TemporaryDirectory() as home:
        os.environ["LEARNBLOCK_HOME"] = home
        for name in options.robots:
            commands, readings = reactions(name, options.rounds)
            print(f"{name:<13}{spelled(commands)}{spelled(readings)}", flush=True)


if __name__ == "__main__":
    main()
