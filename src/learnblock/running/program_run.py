"""One run of one program, and its control from other threads."""

from collections.abc import Callable, Collection
from contextlib import nullcontext
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import msgspec

from learnblock import robots
from learnblock.client import Client
from learnblock.devices import Pose
from learnblock.errors import LearnBlockError, MissingDeviceError
from learnblock.i18n import Phrase
from learnblock.running.job import Job
from learnblock.running.report import Report, report
from learnblock.runtime.containment.driver import give_up, in_own_thread
from learnblock.runtime.debugger import Debugger, HeldBy
from learnblock.runtime.escalation import PATIENCE, EndTimeouts
from learnblock.runtime.host import Host
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.process import ProcessWorker, Worker, one_processor
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import Recorder, record
from learnblock.runtime.run import Run
from learnblock.runtime.standby import Standby
from learnblock.runtime.trace import Trace
from learnblock.runtime.trace_sinks import LineSink, TraceSink
from learnblock.runtime.values import plain
from learnblock.runtime.watcher import Watcher

if TYPE_CHECKING:
    from learnblock.monitor import Monitor


#: What a robot with this equipment lacks that the program needs; None if it lacks nothing.
Lacking = Callable[[frozenset[str]], Phrase | None]


@dataclass(frozen=True, slots=True)
class Standing:
    """The state of a run that goes on, for people.

    Args:
        time: seconds of the robot's time.
        pose: where the robot thinks it is, or None.
        emotion: the emotion that it shows; "" for none.
    """

    time: float
    pose: Pose | None
    emotion: str


class ProgramRun:
    """A prepared run of a program.

    Args:
        job: the run to be made. Its keys, its trace and its process are chosen by the arguments
            below.
        trace: the file of the trace; None for none.
        lines: takes the lines of the trace themselves; None for nothing.
        watcher: receives events as they happen.
        worker: creates the worker that runs the program; a process by default.
        debugger: pauses and steps the program, and stops it at breakpoints.
        log: keeps what the program does, for questions about the run; None for no log.
        lacking: refuses a robot whose devices are known only once it is connected.
        standby: the process for the program, if it has been started before.
        monitored: whether the robot has a monitor, for a page.
        patience: how long its end may take when `run` is interrupted.
    """

    def __init__(
        self,
        job: Job,
        *,
        trace: TraceSink | None = None,
        lines: LineSink | None = None,
        watcher: Watcher | None = None,
        worker: Callable[[], Worker] = ProcessWorker,
        debugger: Debugger | None = None,
        log: RunLog | None = None,
        lacking: Lacking | None = None,
        standby: Standby | None = None,
        monitored: bool = False,
        patience: EndTimeouts = PATIENCE,
    ) -> None:
        self.job = job
        self.trace = Trace(trace, log, lines)
        #: The robot as the page shows it, once the program has created it, if it is monitored.
        self.monitor: Monitor | None = None
        self._debugger = debugger
        self._lacking = lacking
        self._monitored = monitored
        self._patience = patience
        self._run = Run(
            job.program,
            self._make_robot,
            self._make_recorder,
            watcher=watcher,
            limits=job.limits,
            debugger=debugger,
            worker=partial(ProcessWorker, standby) if standby else worker,
            network=job.options.network,
            anyway=job.options.anyway,
            robots=tuple(entry.module for entry in robots.entries().values()),
            log=log,
        )
        self._host = Host(self._run, seconds=job.options.seconds)
        self._is_contained = False
        self._has_process = worker is ProcessWorker

    @property
    def program(self) -> Program:
        """The program."""
        return self.job.program

    @property
    def client(self) -> Client | None:
        """The robot in the host, once the program has created it."""
        return self._run.client

    @property
    def standing(self) -> Standing | None:
        """The state of the run; None before there is a robot."""
        recorder, client = self.recorder, self.client
        if recorder is None or client is None:
            return None
        emotions = recorder.emotions
        return Standing(recorder.time(), client.where(), emotions[-1] if emotions else "")

    @property
    def is_deterministic(self) -> bool:
        """Whether the same program, world and seed give the same run."""
        return self.job.robot.load().lockstep

    @property
    def recorder(self) -> Recorder | None:
        """The events recorded so far."""
        return self._run.recorder

    def run(self) -> Report:
        """Run the program to its end.

        Raises:
            LearnBlockError: it was interrupted, and could not be ended.
        """
        in_own_thread(self._serve, self._patience.measures(self.stop, self.abort))
        result = report(self.program, self._run, self.trace.sha256)
        if self.trace.log:
            self.trace.log.end(msgspec.to_builtins(result, enc_hook=plain))
        return result

    # The methods below can be called from any thread at any time.

    def stop(self) -> None:
        """End the run within a second, even if it is paused or waiting for input."""
        self._host.stop()

    def abort(self) -> None:
        """Kill the program of a run that `stop` has not ended."""
        self._host.abort()

    def pause(self) -> None:
        """Pause the world at once, and the program at its next line."""
        self._control.pause()

    def resume(self) -> None:
        """Continue after a pause or at a breakpoint."""
        self._control.resume()

    def step(self) -> None:
        """Run to the next line, stepping into functions."""
        self._control.step()

    def step_over(self) -> None:
        """Run to the next line of the same function, or of one of its callers."""
        self._control.step_over()

    def set_breakpoints(self, lines: Collection[int]) -> None:
        """Replace the breakpoints, given as lines of the program's Python."""
        self._control.set_breakpoints(lines)

    def held_by(self, line: int) -> HeldBy:
        """Why the program is held before a line of its Python."""
        return self._control.held_by(line)

    def set_speed(self, factor: float | None) -> None:
        """Set the speed of a simulated world, times real time; None is as fast as possible."""
        self._run.world.set_speed(factor)

    def report_variables(self, *, enabled: bool) -> None:
        """Start or stop reporting the variables to the watcher several times a second."""
        self._run.variables.enabled = enabled

    def _serve(self) -> None:
        takes_turns = self._has_process and self.job.robot.load().lockstep
        with one_processor() if takes_turns else nullcontext():
            self._host.run()

    @property
    def _control(self) -> Debugger:
        if self._debugger is None:
            raise LearnBlockError("run-no-debugger")
        return self._debugger

    def _make_robot(self, module: str, arguments: dict[str, Any]) -> Client:
        # The robot chosen for this run replaces the one that the program imports.
        del module
        self._contain()
        client = self.job.robot.load().hosted(arguments, self.job.options.wishes)
        self._refuse_lacking(client)
        if self._monitored:
            self.monitor = monitor_of(client)
        return client

    def _refuse_lacking(self, client: Client) -> None:
        """End the program before its first line, as the check does where it knows the devices."""
        if self._lacking is None or self.job.options.anyway:
            return
        is_known = self.job.robot.load().known_equipment() is not None
        if not is_known and (lack := self._lacking(client.equipment)):
            client.stop()
            raise MissingDeviceError(lack.code, **lack.values)

    def _contain(self) -> None:
        """Let the driver do only what it needs: from now on it may see the program's values."""
        if not self._is_contained:
            self._is_contained = True
            give_up(self.job.robot.load().known_rights())

    def _make_recorder(self, client: Client) -> Recorder:
        return record(client, self.program.identity, self.trace)


def monitor_of(client: Client) -> "Monitor":
    """The robot as the page shows it."""
    from learnblock.monitor import making  # noqa: PLC0415 - it is slow to load

    return making.monitor_of(client)
