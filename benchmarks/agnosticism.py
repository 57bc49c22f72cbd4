"""What becomes of each example on each robot, in the world in which its purpose is a goal.

With `--wires` the robots are the ten real ones, each emulated at the other end of its wire, in
real time: some 40 minutes. Words select robots and examples: `agnosticism.py --wires ev3 first/park
square`. With `--page` it also writes the table of the docs, or the columns of these robots.
"""

import os
import re
import sys
import tempfile
import threading
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import product
from math import hypot
from pathlib import Path
from time import monotonic, sleep
from typing import Any

from learnblock import robots, running
from learnblock.blocks import builtin
from learnblock.emulators import TWINS as WIRES
from learnblock.emulators import emulate
from learnblock.language.check.robots import Verdict, demands, verdict
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.process import ProcessWorker
from learnblock.simulator.goals import RobotState, goals

TESTS = Path(__file__).parents[1] / "tests" / "helpers"
sys.path.insert(0, str(TESTS))

from emulated import settle  # noqa: E402 - found through the line above
from every_robot import (  # noqa: E402 - as above
    MISSED,
    NOT_JUDGED,
    PATIENCE,
    REACHED,
    REAL,
    cell,
    missed_goals,
    programs_table,
    run_for_goals,
    write_part,
    written_outcomes,
)
from playground import Playground  # noqa: E402
from runs import EXAMPLES, HANDS, TASKS, TWINS, person  # noqa: E402

#: How many robots drive in real time at once.
AT_ONCE = 6
#: Seconds between two looks at the goals.
LOOK = 0.1
#: Seconds for which a robot is watched after its program: to stop at a place is to stay there.
STANDING = 5.0
#: The folder of examples that play the game of a world.
_GAMES = "games/"
#: Kinds of goals that can't be judged by a robot's way.
UNSEEN = {"avoid", "show"}
#: What the name of such a goal ends with.
UNKNOWN = "?"


@dataclass(frozen=True)
class Outcome:
    """What became of an example on a robot.

    Args:
        cell: in the words of the docs.
        details: the goals that it missed, or the error with which it ended.
    """

    cell: str
    details: str = ""


def outcome(name: str, robot: str) -> Outcome:
    """Run an example on a robot, unless the check refuses it."""
    source = running.read(EXAMPLES / name)
    known = running.runs_on(source)[robot]
    if isinstance(known, Verdict) and not known.runs:
        return Outcome(cell(known))
    report, missed, equipment = (on_twin if robot in TWINS else over_wire)(name, robot)
    # What CoppeliaSim's robot has is known only once it is connected.
    late = verdict(demands(source.tree, builtin()), equipment)
    found = known if isinstance(known, Verdict) else late
    if report.error and found.runs:
        return Outcome("error", str(report.error["message"]))
    announced = {lack.skill.name for lack in found.missed}
    silent = {str(one["skill"]) for one in report.no_effect} - announced
    if silent and not report.error:
        return Outcome("NOT ANNOUNCED", ", ".join(sorted(silent)))
    return Outcome(cell(found, _goal(name, robot, missed)), ", ".join(missed))


def _goal(name: str, robot: str, missed: list[str]) -> str:
    # Nothing shakes a real robot here, and it does not play the game of a world.
    nobody_acts = robot not in TWINS and (name in HANDS or name.startswith(_GAMES))
    if missed and (nobody_acts or all(goal.endswith(UNKNOWN) for goal in missed)):
        return NOT_JUDGED
    return MISSED if missed else REACHED


def on_twin(name: str, robot: str) -> tuple[Any, list[str], frozenset[str]]:
    """Run an example; return its report, the names of the goals that it missed, what it had."""
    report = run_for_goals(name, robot)
    return report, missed_goals(report), frozenset()


def over_wire(name: str, robot: str) -> tuple[Any, list[str], frozenset[str]]:
    """The same over a robot's wire; the run ends as soon as all goals are reached."""
    world, seconds = TASKS[name]
    entry = robots.find(robot)
    program = running.program(running.read(EXAMPLES / name), entry)
    with tempfile.TemporaryDirectory() as home, observed(robot, world, home) as missed:
        options = Options(seconds=PATIENCE * seconds)
        run = ProgramRun(Job(program, entry, options), worker=ProcessWorker, watcher=person(name))
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
        return report, missed(), run.client.equipment if run.client else frozenset()


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

    It sees neither bumps nor feelings: whether a goal about them is reached is unknown.
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
        unknown = [f"{state.name}{UNKNOWN}" for state in states if state.kind in UNSEEN]
        return unknown + [
            state.name for state in states if state.kind not in UNSEEN and state.reached_at is None
        ]


def main() -> None:
    arguments = sys.argv[1:]
    over_wires = "--wires" in arguments
    words = [word for word in arguments if word not in {"--wires", "--page"}]
    every = REAL if over_wires else TWINS
    chosen = [robot for robot in every if robot in words] or every
    words = [word for word in words if word not in chosen]
    names = [name for name in TASKS if not words or any(word in name for word in words)]
    cells: dict[str, dict[str, str]] = {name: {} for name in names}
    with ProcessPoolExecutor(AT_ONCE if over_wires else 1) as pool:
        pairs = list(product(names, chosen))
        outcomes = pool.map(outcome, *zip(*pairs, strict=True))
        for (name, robot), found in zip(pairs, outcomes, strict=True):
            cells[name][robot] = found.cell
            print(f"{name:<26}{robot:<13}{found.cell}  {found.details}".rstrip(), flush=True)
    counts = Counter(re.split("[,:]", one)[0] for row in cells.values() for one in row.values())
    print(", ".join(f"{count} {kind}" for kind, count in counts.most_common()))
    if "--page" in arguments and not words:
        part = "wires" if over_wires else "programs"
        before = written_outcomes(part)
        table = {
            name: {robot: (before[name] | cells[name])[robot] for robot in every} for name in names
        }
        write_part(part, programs_table(table))


if __name__ == "__main__":
    main()
