"""Run every example on every robot of the paper, through its real driver and wire.

Run it with ``python benchmarks/drivers.py [--seconds 40] [ROBOT...]``. Our emulator is at the
other end of each wire and moves its twin in real time; all robots run at the same time. For each
pair, the table shows how the run ended, or which device is missing, and how far the robot was from
the path of the same program on the twin in lock-step, as a root mean square in mm.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from bisect import bisect
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import tomli_w

from learnblock.emulators import TWINS, emulate
from learnblock.robots import find

TESTS = Path(__file__).parents[1] / "tests" / "helpers"
sys.path.insert(0, str(TESTS))

from runs import EXAMPLES, WORLDS  # noqa: E402 - found through the line above

NAMES = sorted(path.name for path in EXAMPLES.glob("*.bt"))
Track = list[tuple[float, float, float]]


def run(example: str, robot: str, seconds: float, home: str, *more: str) -> dict:
    """Run an example as a user does."""
    program = EXAMPLES / example
    command = ["run", program, "--robot", robot, "--for", str(seconds), "--json", *more]
    done = subprocess.run(
        [sys.executable, "-m", "learnblock", *command],
        capture_output=True,
        check=False,
        env={**os.environ, "LEARNBLOCK_HOME": home},
    )
    return json.loads(done.stdout or b'{"ended": "refused", "error": {"message": "?"}}')


def path_of_twin(example: str, robot: str, seconds: float, home: str) -> Track:
    """Return the path of the twin in lock-step with the same program: (time s, x mm, y mm)."""
    trace = Path(home) / f"{example}.jsonl"
    world = WORLDS.get(example, "empty")
    run(example, TWINS[robot], seconds, home, "--world", world, "--trace", str(trace))
    if not trace.exists():
        # The check refused it: the real robot has more devices than its twin.
        return []
    lines = map(json.loads, trace.read_text().splitlines())
    return [(line["t"], *line["pose"][:2]) for line in lines if "pose" in line]


def settle(home: str, robot: str, chosen: dict) -> None:
    """Write the settings with which the driver reaches the emulator."""
    (Path(home) / "settings.toml").write_text(tomli_w.dumps({"robots": {robot: dict(chosen)}}))


def away(driven: Track, twins: Track) -> float:
    """Return the root mean square of the distance between two paths at the same times, in mm."""
    times = [time for time, _, _ in twins]
    begun = next((t for t, x, y in driven if math.dist((x, y), driven[0][1:]) > 2), 0.0)
    left = next((t for t, x, y in twins if math.dist((x, y), twins[0][1:]) > 2), 0.0)
    squares = []
    for time, x, y in driven:
        at = bisect(times, time - begun + left)
        if 0 < at < len(twins):
            squares.append(math.dist((x, y), twins[at][1:]) ** 2)
    return math.sqrt(sum(squares) / len(squares)) if squares else 0.0


def outcome(example: str, robot: str, seconds: float) -> str:
    """Return one cell of the table."""
    with tempfile.TemporaryDirectory() as home:
        with emulate(robot, WORLDS.get(example, "empty")) as emulation:
            settle(home, robot, emulation.settings)
            report = run(example, robot, seconds, home)
            driven = [(time, x, y) for time, (x, y, _) in emulation.twin.path]
            goals = emulation.twin.goals()
        if report["ended"] == "refused":
            message = report["error"]["message"]
            return "needs " + message.split("`")[3] if message.count("`") > 3 else message
        twins = path_of_twin(example, robot, seconds, home)
    apart = f" {away(driven, twins):.0f} mm" if twins else ""
    reached = f" {sum(goals.values())}/{len(goals)} goals" if goals else ""
    return f"{report['ended']}{reached}{apart}"


def column(robot: str, seconds: float) -> dict[str, str]:
    """Run all examples on one robot, one after the other."""
    return {example: outcome(example, robot, seconds) for example in NAMES}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("robots", nargs="*", default=sorted(TWINS))
    parser.add_argument("--seconds", type=float, default=40.0)
    chosen = parser.parse_args()
    for robot in chosen.robots:
        find(robot)
    with ThreadPoolExecutor() as pool:
        columns = list(pool.map(lambda robot: column(robot, chosen.seconds), chosen.robots))
    print(f"{'':<16}" + "".join(f"{robot:<27}" for robot in chosen.robots))
    for example in NAMES:
        print(f"{example:<16}" + "".join(f"{one[example]:<27.26}" for one in columns))


if __name__ == "__main__":
    main()
