"""What becomes of each example on each robot, in the world in which its purpose is a goal.

With `--wires` the robots are the six real ones, each emulated at the other end of its wire, in
real time: some 25 minutes. Words select examples: `agnosticism.py --wires first/park square`. With
`--page` it only writes the table of the docs.
"""

import os
import sys
import tempfile
import threading
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from itertools import product
from math import hypot
from pathlib import Path
from time import monotonic, sleep
from typing import Any

from learnblock import robots, running
from learnblock.emulators import TWINS as WIRES
from learnblock.emulators import emulate
from learnblock.language.check.robots import Verdict
from learnblock.running import Options, ProgramRun
from learnblock.runtime.process import ProcessWorker
from learnblock.simulator.goals import RobotState, goals

TESTS = Path(__file__).parents[1] / "tests" / "helpers"
sys.path.insert(0, str(TESTS))

from emulated import settle  # noqa: E402 - found through the line above
from every_robot import (  # noqa: E402 - as above
    PATIENCE,
    missed_goals,
    programs_table,
    run_for_goals,
    write_part,
)
from every_robot import outcome as cell  # noqa: E402 - as above
from playground import Playground  # noqa: E402
from runs import EXAMPLES, TASKS, TWINS, person  # noqa: E402

#: How many robots drive in real time at once.
AT_ONCE = 6
#: Seconds between two looks at the goals.
LOOK = 0.1
#: Seconds for which a robot is watched after its program: to stop at a place is to stay there.
STANDING = 5.0
#: Kinds of goals that can't be judged by a robot's way.
UNSEEN = {"avoid", "show"}


def outcome(name: str, robot: str) -> str:
    """Return `reached` or `missed GOAL`, and without what, or why the robot can't run it."""
    verdict = running.runs_on(running.read(EXAMPLES / name))[robot]
    # What CoppeliaSim's robot has is known only once it is connected.
    is_known = isinstance(verdict, Verdict)
    if is_known and not verdict.runs:
        return str(verdict.phrase)
    report, missed = (on_twin if robot in TWINS else over_wire)(name, robot)
    if report.error:
        return f"error: {report.error['message']}"
    announced = {lack.skill.name for lack in verdict.missed} if is_known else set()
    silent = ", ".join(sorted({str(one["skill"]) for one in report.no_effect} - announced))
    if silent and is_known:
        return f"NOT ANNOUNCED: {silent}"
    without = silent and f"no effect: {silent}"
    if is_known and verdict.missed:
        without = str(verdict.phrase)
    what = f"missed {', '.join(missed)}" if missed else "reached"
    return what + (f" ({without})" if without else "")


def on_twin(name: str, robot: str) -> tuple[Any, list[str]]:
    """Run an example; return its report and the names of the goals that it missed."""
    report = run_for_goals(name, robot)
    return report, missed_goals(report)


def over_wire(name: str, robot: str) -> tuple[Any, list[str]]:
    """The same over a robot's wire; the run ends as soon as all goals are reached."""
    world, seconds = TASKS[name]
    entry = robots.find(robot)
    program = running.program(running.read(EXAMPLES / name), entry)
    with tempfile.TemporaryDirectory() as home, observed(robot, world, home) as missed:
        options = Options(seconds=PATIENCE * seconds)
        run = ProgramRun(program, entry, options, worker=ProcessWorker, watcher=person(name))
        ended = threading.Event()

        def look() -> None:
            while missed() and not ended.wait(LOOK):
                pass
            run.stop()

        watching = threading.Thread(target=look)
        watching.start()
        report = run.run()
        ended.set()
        watching.join()
        until = monotonic() + STANDING
        while missed() and monotonic() < until:
            sleep(LOOK)
        return report, missed()


@contextmanager
def observed(robot: str, world: str, home: str) -> Iterator[Any]:
    """Emulate a robot; yield a function that returns the names of the goals not yet reached."""
    os.environ["LEARNBLOCK_HOME"] = home
    if robot in WIRES:
        with emulate(robot, world) as emulation:
            settle(robot, emulation.settings)
            twin: Any = emulation.twin
            yield lambda: [goal for goal, is_reached in twin.goals().items() if not is_reached]
        return
    playground = Playground(world)
    try:
        settle(robot, playground.settings)
        judge = Judge(playground)
        with playground.watching() as path:
            yield lambda: judge.missed(path)
    finally:
        playground.close()


class Judge:
    """Judges the way of a robot that another simulator moves.

    It sees neither bumps nor feelings: a goal about them is missed with a question mark.
    """

    def __init__(self, playground: Any) -> None:
        self._goals = goals(playground.world)
        self._seen = 0
        self._driven = 0.0

    def missed(self, path: list[tuple[float, Any]]) -> list[str]:
        """Return the names of the goals that a growing path has not reached."""
        for before, (time, pose) in zip(path[self._seen :], path[self._seen + 1 :], strict=False):
            self._driven += hypot(pose.x - before[1].x, pose.y - before[1].y)
            self._seen += 1
            state = RobotState("robot", time, pose, distance=self._driven)
            for goal in self._goals:
                goal.look(time, [state])
        states = [goal.state for goal in self._goals]
        open_goals = [state.name for state in states if state.reached_at is None]
        return [f"{state.name}?" for state in states if state.kind in UNSEEN] or open_goals


def write_page() -> None:
    """Write the table of the docs."""
    found = {name: {robot: cell(name, robot) for robot in TWINS} for name in TASKS}
    write_part("programs", programs_table(found))


def main() -> None:
    arguments = sys.argv[1:]
    if "--page" in arguments:
        write_page()
        return
    over_wires = "--wires" in arguments
    words = [word for word in arguments if word != "--wires"]
    names = [name for name in TASKS if not words or any(word in name for word in words)]
    chosen = [*WIRES, "thymio"] if over_wires else TWINS
    counts: Counter[str] = Counter()
    with ProcessPoolExecutor(AT_ONCE if over_wires else 1) as pool:
        pairs = list(product(names, chosen))
        found = pool.map(outcome, *zip(*pairs, strict=True))
        for (name, robot), what in zip(pairs, found, strict=True):
            counts[what.partition(" ")[0]] += 1
            print(f"{name:<26}{robot:<13}{what}", flush=True)
    print(", ".join(f"{count} {kind}" for kind, count in counts.most_common()))


if __name__ == "__main__":
    main()
