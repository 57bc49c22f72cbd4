"""One run of the program, from the event loop's side."""

import asyncio
import threading
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from learnblock import skill_files
from learnblock.devices import Pose
from learnblock.robots import RobotEntry
from learnblock.running import Options, Report
from learnblock.running import Session as Run
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.program import Program
from learnblock.server import messages
from learnblock.server.runs.console import Console
from learnblock.server.runs.trial import Trial
from learnblock.server.runs.watcher import Audience, RunWatcher

#: Whoever repeats a run on the command line gets the same one: it seeds with 0 as well.
SEED = 0


@dataclass(frozen=True, slots=True)
class Setting:
    """What a program runs on.

    Args:
        name: what its author calls it.
        robot: on which robot.
        world: in which world.
        start: where the robot was put, if it was.
        breakpoints: blocks before which it is held.
    """

    name: str
    robot: RobotEntry
    world: str
    start: Pose | None
    breakpoints: tuple[str, ...]


class Played(Protocol):
    """What is run: a program's document, or a function that is tried."""

    def program(self, name: str, /) -> Program:
        """What is run."""

    def block_at(self, python_line: int, /) -> str | None:
        """The block that stands in a line of it."""

    def python_line(self, block: str, /) -> int | None:
        """The first line of a block."""


class Playing:
    """One run: the program as it was when it began, and who controls and watches it.

    Args:
        played: the program.
        run: prepared.
        watcher: that of `run`.
    """

    def __init__(self, played: Played, run: Run, watcher: RunWatcher) -> None:
        self.played = played
        self.run = run
        self.watcher = watcher
        #: Set once nothing of it is left.
        self.over = asyncio.Event()

    @property
    def block(self) -> str | None:
        """The block that runs now."""
        return self.played.block_at(self.watcher.current_line)

    @property
    def is_trial(self) -> bool:
        return isinstance(self.played, Trial)

    def start(self) -> None:
        """Run it, in a thread."""
        self.run.tell_variables(tell=True)
        threading.Thread(target=self._play, name="run", daemon=True).start()

    def set_breakpoints(self, blocks: Iterable[str]) -> None:
        """Hold it before these blocks."""
        self.run.set_breakpoints(lines(self.played, blocks))

    def ended(self, report: Report) -> messages.Ended:
        """How it ended."""
        error = report.error or {}
        line = error.get("line")
        line = line if isinstance(line, int) else 0
        own_block, own_line = self._own_place(error.get("within"), line)
        return messages.Ended(
            ended=report.ended,
            message=str(error.get("message", "")),
            block=self.played.block_at(line) if line else None,
            own_block=own_block,
            own_line=own_line,
            tried=self.is_trial,
            time=report.time,
            distance=report.distance,
            goals=tuple(
                messages.GoalNow(goal.name, goal.kind, goal.state, goal.time)  # type: ignore[arg-type]
                for goal in report.goals
            ),
            emotions=report.emotions,
            no_effect=tuple((str(one["skill"]), str(one["device"])) for one in report.no_effect),
            trace_sha256=report.trace_sha256,
        )

    def _own_place(self, within: Any, line: int) -> tuple[str, int]:
        """The block of the user's own in which it went wrong, and the line of its source."""
        if isinstance(self.played, Trial) and (own_line := self.played.own_line(line)):
            return self.played.name, own_line
        if within and Path(within["file"]) in skill_files.own_files():
            return Path(within["file"]).stem, within["line"]
        return "", 0

    def _play(self) -> None:
        try:
            outcome: Report | Exception = self.run.run()
        except Exception as error:  # noqa: BLE001 - a robot's driver may raise whatever it likes
            outcome = error
        self.watcher.ended(outcome)


def prepared(
    played: Played,
    setting: Setting,
    audience: Audience,
    console: Console,
    *,
    paused: bool,
) -> Playing:
    """A run that has not begun.

    Args:
        played: a program without errors.
        setting: what it runs on, and where.
        audience: is told how it fares.
        console: takes what it prints.
        paused: hold it before its first line.
    """
    watcher = RunWatcher(audience, console)
    run = Run(
        played.program(setting.name),
        setting.robot,
        Options(world=setting.world, seed=SEED, start=setting.start),
        watcher=watcher,
        debugger=Debugger(lines(played, setting.breakpoints), paused=paused),
    )
    return Playing(played, run, watcher)


def lines(played: Played, blocks: Iterable[str]) -> frozenset[int]:
    """The lines of Python that begin these blocks."""
    found = map(played.python_line, blocks)
    return frozenset(line for line in found if line is not None)
