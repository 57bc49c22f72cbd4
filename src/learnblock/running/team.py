"""Several programs in one run: simulated robots share a world, real ones have a thread each."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from operator import or_
from typing import TYPE_CHECKING, Any

import msgspec

from learnblock import robots
from learnblock.client import Client, Goal
from learnblock.robots import RobotEntry
from learnblock.robots.simulated import SimulatedRobot, Simulation, goal_of
from learnblock.running.job import Job, Options
from learnblock.running.program_run import monitor_of
from learnblock.running.report import Report, report
from learnblock.runtime.containment.driver import OwnThread, end_threads, give_up
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.escalation import PATIENCE, EndTimeouts
from learnblock.runtime.host import Host
from learnblock.runtime.log.keeping import RunLog, TeamLog
from learnblock.runtime.post import Post
from learnblock.runtime.process import ProcessWorker, Worker
from learnblock.runtime.recorder import Recorder, record
from learnblock.runtime.run import Run
from learnblock.runtime.trace import MemberTrace, Trace
from learnblock.runtime.trace_sinks import LineSink, TraceSink
from learnblock.runtime.values import plain
from learnblock.runtime.watcher import Watcher

if TYPE_CHECKING:
    from learnblock.monitor import Monitor


@dataclass(frozen=True, slots=True)
class TeamReport:
    """The results of a run with several robots.

    Args:
        robots: each robot's report by its name, in their order; the goals are left to the whole
            run.
        goals: the goals of the world.
        trace_sha256: the hash of the trace; None if a real robot took part, since another such run
            has another trace.
    """

    robots: Mapping[str, Report]
    goals: tuple[Goal, ...]
    trace_sha256: str | None


# Why: docs/decisions.md, "Several robots share a world, not a process"
class TeamRun:
    """A prepared run of several programs.

    Args:
        jobs: the runs by the names of their robots, in the order in which they take turns. What
            the options of the first one say of the world, its pace and the time holds for all.
        trace: the file of the trace; None for none.
        lines: takes the lines of the trace themselves; None for nothing.
        watch: creates what receives the events of the robot with a name.
        debug: creates what pauses a robot's program; None for no pauses.
        monitored: whether the robots have monitors, for a page.
        worker: creates the worker that runs a program; a process by default.
        patience: how long the end may take when `run` is interrupted.
        logs: by the names of robots, what keeps what their programs do, for questions about the
            run; all of them or none.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: the world's file is invalid, or has no room for all robots.
    """

    def __init__(
        self,
        jobs: Mapping[str, Job],
        *,
        trace: TraceSink | None = None,
        lines: LineSink | None = None,
        watch: Callable[[str], Watcher] = lambda _: Watcher(),
        debug: Callable[[str], Debugger | None] = lambda _: None,
        monitored: bool = False,
        worker: Callable[[], Worker] = ProcessWorker,
        patience: EndTimeouts = PATIENCE,
        logs: Mapping[str, RunLog] | None = None,
    ) -> None:
        self.jobs = dict(jobs)
        self.trace = Trace(trace, lines=lines)
        twins = [name for name, job in self.jobs.items() if _twin(job)]
        #: Whether the same programs, world and seed give the same run.
        self.is_deterministic = len(twins) == len(self.jobs)
        #: The world of all simulated robots, if there is one.
        self.simulation = _shared_world({name: self.jobs[name] for name in twins}, self.options)
        self._logs = logs or {}
        shared = [self._logs[name] for name in twins if self._logs]
        self._team_log = TeamLog(shared, [*map(self._logged, twins)]) if shared else None
        self._make_run = partial(self._prepared, watch=watch, debug=debug, worker=worker)
        self._monitored = monitored
        self._patience = patience
        self._monitors: dict[str, Monitor] = {}
        self._runs: dict[str, Run] = {}
        post = Post(len(self.jobs))
        self._boxes = {name: post.box(index) for index, name in enumerate(self.jobs)}
        # Simulated robots take turns in one world; a real one does not wait for others.
        groups = [twins, *([name] for name in self.jobs if name not in twins)]
        self._hosts = [self._make_host(group) for group in groups if group]

    @property
    def options(self) -> Options:
        """What holds for all robots: the options of the first one."""
        return next(iter(self.jobs.values())).options

    def run(self) -> TeamReport:
        """Run all programs to their end.

        Raises:
            LearnBlockError: it was interrupted, and a program could not be ended.
        """
        threads: list[OwnThread[None]] = []
        try:
            for host in self._hosts:
                # One by one: what has begun must end, even if there is no thread for the next.
                threads.append(OwnThread(host.run))
                threads[-1].start()
            for thread in threads:
                thread.result()
        finally:
            end_threads(threads, self._patience.measures(self.stop, self.abort))
        for name, log in self._logs.items():
            log.end(msgspec.to_builtins(self._own_report(name), enc_hook=plain))
        return TeamReport(
            robots={name: self.report(name) for name in self.jobs},
            goals=self._goals,
            trace_sha256=self._sha256,
        )

    def stop(self) -> None:
        """End all programs within a second; may be called from any thread."""
        for host in self._hosts:
            host.stop()

    def abort(self) -> None:
        """Kill the programs of a run that `stop` has not ended; may be called from any thread."""
        for host in self._hosts:
            host.abort()

    def recorder(self, robot: str) -> Recorder | None:
        """The events of a robot, once its program has created it."""
        return self._runs[robot].recorder

    def client(self, robot: str) -> Client | None:
        """A robot, once its program has created it."""
        return self._runs[robot].client

    def ended(self, robot: str) -> bool:
        """Whether the program of a robot has ended."""
        return self._runs[robot].ending is not None

    def report(self, robot: str) -> Report:
        """The report of a robot whose program has ended."""
        return report(self.jobs[robot].program, self._runs[robot], "")

    def _own_report(self, robot: str) -> Report:
        """A robot's report with the goals and the trace of the whole run."""
        return replace(self.report(robot), goals=self._goals, trace_sha256=self._sha256 or "")

    @property
    def _goals(self) -> tuple[Goal, ...]:
        goals = self.simulation.world.goals if self.simulation else ()
        return tuple(map(goal_of, goals))

    @property
    def _sha256(self) -> str | None:
        return self.trace.sha256 if self.is_deterministic else None

    def monitor(self, robot: str) -> "Monitor | None":
        """A robot as the page shows it, once its program has created it."""
        return self._monitors.get(robot)

    def set_speed(self, factor: float | None) -> None:
        """Set the speed of the simulated world, times real time; None is as fast as possible.

        May be called from any thread.
        """
        for run in self._runs.values():
            run.world.set_speed(factor)

    def report_variables(self, robot: str, *, enabled: bool) -> None:
        """Start or stop reporting the variables of a robot's program to its watcher."""
        self._runs[robot].variables.enabled = enabled

    def _make_host(self, group: Sequence[str]) -> Host:
        fence = _Fence([self.jobs[robot].robot for robot in group])
        for robot in group:
            self._runs[robot] = self._make_run(robot, fence)
        return Host(*(self._runs[robot] for robot in group), seconds=self.options.seconds)

    def _prepared(
        self,
        robot: str,
        fence: "_Fence",
        *,
        watch: Callable[[str], Watcher],
        debug: Callable[[str], Debugger | None],
        **more: Any,
    ) -> Run:
        job = self.jobs[robot]
        return Run(
            job.program,
            partial(self._make_robot, robot, fence),
            partial(self._make_recorder, robot),
            watcher=watch(robot),
            debugger=debug(robot),
            limits=job.limits,
            network=job.options.network,
            anyway=job.options.anyway,
            box=self._boxes[robot],
            robots=tuple(entry.module for entry in robots.entries().values()),
            log=self._logs.get(robot),
            **more,
        )

    def _make_robot(
        self, robot: str, fence: "_Fence", _module: str, arguments: dict[str, Any]
    ) -> Client:
        fence.close()
        client = self._make_client(robot, arguments)
        if self._monitored:
            self._monitors[robot] = monitor_of(client)
        return client

    def _make_client(self, robot: str, arguments: dict[str, Any]) -> Client:
        job = self.jobs[robot]
        if (twin := _twin(job)) and self.simulation:
            # The world is everyone's, so a program's own arguments do not choose it.
            return twin(simulation=self.simulation, name=robot, start=job.options.start)
        return job.robot.load().hosted(arguments, {})

    def _make_recorder(self, robot: str, client: Client) -> Recorder:
        more: dict[str, Any] = {} if self.is_deterministic else {"deterministic": False}
        job, trace = self.jobs[robot], self.trace
        if log := self._logs.get(robot):
            trace = MemberTrace(trace, log, self._team_log if _twin(job) else None)
        return record(client, job.program.identity, trace, {"robot": robot}, **more)

    def _logged(self, robot: str) -> dict[str, object]:
        """What a log says about a robot of a shared world."""
        job = self.jobs[robot]
        return {"name": robot, "robot": job.robot.name, "start": job.options.start}


class _Fence:
    """What the thread of a host gives up when it creates its first robot."""

    def __init__(self, served: Sequence[RobotEntry]) -> None:
        self._served = served
        self._is_closed = False

    def close(self) -> None:
        """Let the thread do only what its robots need."""
        if not self._is_closed:
            self._is_closed = True
            give_up(reduce(or_, (entry.load().known_rights() for entry in self._served)))


def _twin(job: Job) -> type[SimulatedRobot] | None:
    """The class of a simulated robot; None for a real one."""
    kind = job.robot.load()
    return kind if issubclass(kind, SimulatedRobot) else None


def _shared_world(twins: Mapping[str, Job], options: Options) -> Simulation | None:
    """The world of these options, with all robots in it."""
    simulation = None
    for name, job in twins.items():
        kind = _twin(job)
        assert kind is not None  # noqa: S101 - only simulated robots are passed
        if simulation is None:
            # Each robot has a start of its own.
            simulation = kind.make_simulation(**replace(options, start=None).wishes)
        simulation.world.add_robot(kind.description(), name=name, start=job.options.start)
    return simulation
