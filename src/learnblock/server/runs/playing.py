"""A single run of the program, as the event loop sees it."""

import asyncio
import threading
from collections.abc import Callable, Collection, Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol
from weakref import ref

from learnblock.monitor.monitor import GoalNow
from learnblock.project.document.document import Document
from learnblock.running import ProgramRun, Report
from learnblock.running.job import Job
from learnblock.runtime.debugger import Debugger, HeldBy
from learnblock.runtime.escalation import PATIENCE, EndTimeouts
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import Recorder
from learnblock.runtime.trace_sinks import LineSink
from learnblock.server import messages
from learnblock.server.runs.escalation import escalate_async
from learnblock.server.runs.function_call import FunctionCall
from learnblock.server.runs.guest_program import GuestProgram
from learnblock.server.runs.looking import Looking
from learnblock.server.runs.memory import give_back_memory
from learnblock.server.runs.watcher import Listener, RunWatcher
from learnblock.storage import skill_files

if TYPE_CHECKING:
    from learnblock.monitor import Monitor

#: A program, a function that the user tries, or the program of another pupil.
Played = Document | FunctionCall | GuestProgram
#: Runs programs to their ends and reports them.
Play = Callable[[Sequence["Playing"]], None]


class Controlled(Protocol):
    """A run of one program, whether it is alone or one of several."""

    @property
    def program(self) -> Program:
        """The program."""

    @property
    def monitor(self) -> "Monitor | None":
        """The robot as the page shows it, once the program has created it."""

    @property
    def is_deterministic(self) -> bool:
        """Whether the same programs, world and seed give the same run."""

    @property
    def recorder(self) -> Recorder | None:
        """The events recorded so far, if they are kept apart from those of other robots."""

    def run(self) -> Report:
        """Run the program to its end."""

    def stop(self) -> None: ...

    def abort(self) -> None: ...

    def pause(self) -> None: ...

    def resume(self) -> None: ...

    def step(self) -> None: ...

    def step_over(self) -> None: ...

    def set_breakpoints(self, lines: Collection[int]) -> None: ...

    def held_by(self, line: int) -> HeldBy: ...

    def set_speed(self, factor: float | None) -> None: ...

    def report_variables(self, *, enabled: bool) -> None: ...


class Playing:
    """A run: the program as it was at the start, its controls and its watcher.

    Args:
        played: the program.
        run: the prepared run.
        watcher: the watcher of `run`.
        looking: looks back at the run; None if no log of it is kept.
        patience: how long it may take to end once it is stopped.
    """

    def __init__(
        self,
        played: Played,
        run: Controlled,
        watcher: RunWatcher,
        looking: Looking | None = None,
        patience: EndTimeouts = PATIENCE,
    ) -> None:
        self.played = played
        self.run = run
        self.watcher = watcher
        self.looking = looking
        #: Set when the run has ended and its robot has been released, or when it was given up.
        self.over = asyncio.Event()
        self._patience = patience
        #: The thread that runs it; None before it has begun.
        self._thread: threading.Thread | None = None

    @property
    def running_line(self) -> messages.RunningLine:
        """The current line and block; none of a guest's program, which no page shows."""
        line = 0 if self.is_guests else self.watcher.current_line
        return messages.RunningLine(line, self.played.block_at(line))

    @property
    def is_call(self) -> bool:
        return isinstance(self.played, FunctionCall)

    @property
    def is_guests(self) -> bool:
        """Whether another pupil's program runs."""
        return isinstance(self.played, GuestProgram)

    @property
    def is_real(self) -> bool:
        """Whether a real robot takes part."""
        return not self.run.is_deterministic

    def start(self) -> None:
        """Run the program in a thread.

        Raises:
            RuntimeError: the system has no thread for it.
            MemoryError: there is no memory for it.
        """
        follow([self], play_one)

    def played_by(self, thread: threading.Thread) -> None:
        """Note which thread runs it."""
        self._thread = thread

    @property
    def is_lost(self) -> bool:
        """Whether its thread has ended, so that all that it reports is in the event loop."""
        return self._thread is not None and not self._thread.is_alive()

    async def stop(self) -> bool:
        """Stop the program and the robot; return whether they have ended.

        A program that does not stop is killed. A thread can't be killed: if it hangs, as in a
        driver, it is left behind.
        """
        measures = self._patience.measures(self.run.stop, self.run.abort)
        return await escalate_async(measures, self.over)

    def set_breakpoints(self, blocks: Iterable[str]) -> None:
        """Pause before these blocks only."""
        self.run.set_breakpoints(first_lines(self.played, blocks))

    def ended(self, report: Report) -> messages.Ended:
        """Describe how the run ended."""
        error = report.error or {}
        line = error.get("line")
        line = line if isinstance(line, int) and not self.is_guests else 0
        custom_block, custom_line = self._own_place(error.get("within"), line)
        return messages.Ended(
            ended=report.ended,
            message=error.get("message"),  # type: ignore[arg-type]
            block=self.played.block_at(line) if line else None,
            line=line,
            custom_block=custom_block,
            custom_line=custom_line,
            tried=self.is_call,
            time=report.time,
            distance=report.distance,
            goals=tuple(
                GoalNow(goal.name, goal.kind, goal.state, goal.time, goal.team)
                for goal in report.goals
            ),
            emotions=report.emotions,
            no_effect=tuple((str(call["skill"]), str(call["device"])) for call in report.no_effect),
            trace_sha256=report.trace_sha256,
            repeatable=self.run.is_deterministic,
        )

    def _own_place(self, within: Any, line: int) -> tuple[str, int]:
        """The custom block in which an error happened, and the line of its source."""
        if isinstance(self.played, FunctionCall) and (custom_line := self.played.custom_line(line)):
            return self.played.name, custom_line
        if within and Path(within["file"]) in skill_files.own_files():
            return Path(within["file"]).stem, within["line"]
        return "", 0


def follow(playings: Sequence[Playing], play: Play) -> None:
    """Run programs in a thread, and give back their memory when they have ended.

    Args:
        playings: one run, or those of several robots in one world.
        play: runs the programs, and reports their ends.

    Raises:
        RuntimeError: the system has no thread for them.
        MemoryError: there is no memory for them.
    """
    handed = [partial(play, playings)]
    runs = [ref(playing.run) for playing in playings]
    thread = threading.Thread(target=_followed, args=(handed, runs), name="run", daemon=True)
    for playing in playings:
        playing.run.report_variables(enabled=not playing.is_guests)
        playing.played_by(thread)
    thread.start()


def play_one(playings: Sequence[Playing]) -> None:
    """Run a program to its end; see `Play`."""
    (playing,) = playings
    try:
        outcome: Report | Exception = playing.run.run()
    except Exception as error:  # noqa: BLE001 - a driver may raise any exception
        outcome = error
    playing.watcher.ended(outcome)


def _followed(handed: list[Callable[[], None]], runs: Sequence[ref[Controlled]]) -> None:
    # Removed, because a thread keeps its arguments, and would keep the world of the run.
    handed.pop()()
    give_back_memory(lambda: not any(run() for run in runs))


def prepared(
    played: Played,
    job: Job,
    listener: Listener,
    *,
    breakpoints: Iterable[str] = (),
    lines: LineSink | None = None,
    paused: bool = False,
) -> Playing:
    """Prepare a run.

    Args:
        played: a program without errors.
        job: its run.
        listener: receives the reports of the run.
        breakpoints: the blocks before which it pauses.
        lines: takes the lines of the trace; None for nothing.
        paused: pause before the first line.
    """
    watcher = RunWatcher(listener, job.keys)
    log = RunLog(job.program)
    run = ProgramRun(
        job,
        lines=lines,
        watcher=watcher,
        debugger=Debugger(first_lines(played, breakpoints), paused=paused),
        log=log,
        lacking=played.lacking,
        monitored=True,
    )
    return Playing(played, run, watcher, looking_at(played, log))


def looking_at(played: Played, log: RunLog) -> Looking:
    """What looks back at the run of a program that is about to start."""
    count = log.program.python.count("\n") + 1
    # The blocks as they are now: the user may change the program while it runs.
    return Looking(log, [played.block_at(line) for line in range(1, count + 1)])


def first_lines(played: Played, blocks: Iterable[str]) -> frozenset[int]:
    """The lines of Python that begin these blocks."""
    numbers = map(played.python_line, blocks)
    return frozenset(line for line in numbers if line is not None)
