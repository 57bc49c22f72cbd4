"""Several programs in one run: simulated robots share a world, real ones have a thread each."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from operator import or_
from typing import TYPE_CHECKING, Any

import msgspec

from learnblock import robots
from learnblock.client import Client, Goal
from learnblock.devices import Pose
from learnblock.robots import RobotEntry
from learnblock.robots.simulated import SimulatedRobot, Simulation, goal_of
from learnblock.running.program_run import Options, monitor_of
from learnblock.running.report import Report, report
from learnblock.runtime.containment.driver import OwnThread, end_threads, give_up
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.escalation import PATIENCE, Patience
from learnblock.runtime.host import Host
from learnblock.runtime.limits import Limits
from learnblock.runtime.log.keeping import RunLog, TeamLog
from learnblock.runtime.post import Post
from learnblock.runtime.process import ProcessWorker, Worker
from learnblock.runtime.program import Program
from learnblock.runtime.run import Run
from learnblock.runtime.trace import MemberTrace, Recorder, Trace, TraceSink, record
from learnblock.runtime.values import plain
from learnblock.runtime.watcher import Watcher

if TYPE_CHECKING:
    from learnblock.monitor import Monitor


@dataclass(frozen=True, slots=True)
class Member:
    """One robot of a run with several.

    Args:
        name: its name in the report, the trace and the world.
        program: its program.
        robot: the kind of robot.
        network: whether the program may use the network.
        start: (x mm, y mm, heading in degrees) where a simulated robot starts; by default a start
            pose of the world.
    """

    name: str
    program: Program
    robot: RobotEntry
    network: bool = False
    start: Pose | None = None

    @property
    def twin(self) -> type[SimulatedRobot] | None:
        """Its class if it is simulated, else None."""
        kind = self.robot.load()
        return kind if issubclass(kind, SimulatedRobot) else None


@dataclass(frozen=True, slots=True)
class TeamReport:
    """The results of a run with several robots.

    Args:
        robots: each robot's report, in their order; the goals are left to the whole run.
        goals: the goals of the world.
        trace_sha256: the hash of the trace; None if a real robot took part, since another such run
            has another trace.
    """

    robots: tuple[tuple[Member, Report], ...]
    goals: tuple[Goal, ...]
    trace_sha256: str | None


# Why: docs/decisions.md, "Several robots share a world, not a process"
class TeamRun:
    """A prepared run of several programs.

    Args:
        members: the robots, in the order in which they take turns.
        options: the options of the run; ``network`` is left to the members.
        trace: takes the lines of the trace, such as a file; None for none.
        watch: creates what receives the events of a member.
        debug: creates what pauses a member's program; None for no pauses.
        monitored: whether the robots have monitors, for a page.
        limits: the resources that each program may use.
        worker: creates the worker that runs a program; a process by default.
        patience: how long the end may take when `run` is interrupted.
        logs: by the names of members, what keeps what their programs do, for questions about the
            run; all of them or none.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: the world's file is invalid, or has no room for all robots.
    """

    def __init__(
        self,
        members: Sequence[Member],
        options: Options,
        *,
        trace: TraceSink | None = None,
        watch: Callable[[Member], Watcher] = lambda _: Watcher(),
        debug: Callable[[Member], Debugger | None] = lambda _: None,
        monitored: bool = False,
        limits: Limits | None = None,
        worker: Callable[[], Worker] = ProcessWorker,
        patience: Patience = PATIENCE,
        logs: Mapping[str, RunLog] | None = None,
    ) -> None:
        self.members = tuple(members)
        self.options = options
        self.trace = Trace(trace)
        twins = [member for member in members if member.twin]
        #: Whether the same programs, world and seed give the same run.
        self.is_deterministic = len(twins) == len(members)
        #: The world of all simulated robots, if there is one.
        self.simulation = _shared_world(twins, options)
        self._logs = logs or {}
        shared = [self._logs[member.name] for member in twins if self._logs]
        self._team_log = TeamLog(shared, [*map(_plain, twins)]) if shared else None
        self._make_run = partial(
            self._prepared, watch=watch, debug=debug, limits=limits, worker=worker
        )
        self._monitored = monitored
        self._patience = patience
        self._monitors: dict[str, Monitor] = {}
        self._runs: dict[str, Run] = {}
        post = Post(len(self.members))
        self._boxes = {member.name: post.box(index) for index, member in enumerate(self.members)}
        # Simulated robots take turns in one world; a real one does not wait for others.
        groups = [twins, *([member] for member in members if not member.twin)]
        self._hosts = [self._make_host(group) for group in groups if group]

    def run(self) -> TeamReport:
        """Run all programs to their end.

        Raises:
            LearnBlockError: it was interrupted, and a program could not be ended.
        """
        threads: list[OwnThread[None]] = []
        try:
            for host in self._hosts:
                # One by one: what has begun must end, even if there is no thread for the next.
                threads += [OwnThread(host.run)]
            for thread in threads:
                thread.result()
        finally:
            end_threads(threads, self._patience.measures(self.stop, self.abort))
        for member in self.members:
            if log := self._logs.get(member.name):
                log.end(msgspec.to_builtins(self._own_report(member), enc_hook=plain))
        return TeamReport(
            robots=tuple((member, self.report(member)) for member in self.members),
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

    def recorder(self, member: Member) -> Recorder | None:
        """The events of a member, once it has a robot."""
        return self._runs[member.name].recorder

    def client(self, member: Member) -> Client | None:
        """The robot of a member, once its program has created it."""
        return self._runs[member.name].client

    def ended(self, member: Member) -> bool:
        """Whether the program of a member has ended."""
        return self._runs[member.name].ending is not None

    def report(self, member: Member) -> Report:
        """The report of a member whose program has ended."""
        return report(member.program, self._runs[member.name], "")

    def _own_report(self, member: Member) -> Report:
        """A member's report with the goals and the trace of the whole run."""
        return replace(self.report(member), goals=self._goals, trace_sha256=self._sha256 or "")

    @property
    def _goals(self) -> tuple[Goal, ...]:
        goals = self.simulation.world.goals if self.simulation else ()
        return tuple(map(goal_of, goals))

    @property
    def _sha256(self) -> str | None:
        return self.trace.sha256 if self.is_deterministic else None

    def monitor(self, member: Member) -> "Monitor | None":
        """The robot of a member as the page shows it, once its program has created it."""
        return self._monitors.get(member.name)

    def set_speed(self, factor: float | None) -> None:
        """Set the speed of the simulated world, times real time; None is as fast as possible.

        May be called from any thread.
        """
        for run in self._runs.values():
            run.world.set_speed(factor)

    def report_variables(self, member: Member, *, enabled: bool) -> None:
        """Start or stop reporting the variables of a member to its watcher."""
        self._runs[member.name].variables.enabled = enabled

    def _make_host(self, group: Sequence[Member]) -> Host:
        fence = _Fence([member.robot for member in group])
        for member in group:
            self._runs[member.name] = self._make_run(member, fence)
        return Host(*(self._runs[member.name] for member in group), seconds=self.options.seconds)

    def _prepared(
        self,
        member: Member,
        fence: "_Fence",
        *,
        watch: Callable[[Member], Watcher],
        debug: Callable[[Member], Debugger | None],
        **more: Any,
    ) -> Run:
        return Run(
            member.program,
            partial(self._make_robot, member, fence),
            partial(self._make_recorder, member),
            watcher=watch(member),
            debugger=debug(member),
            network=member.network,
            anyway=self.options.anyway,
            box=self._boxes[member.name],
            robots=tuple(entry.module for entry in robots.entries().values()),
            log=self._logs.get(member.name),
            **more,
        )

    def _make_robot(
        self, member: Member, fence: "_Fence", _module: str, arguments: dict[str, Any]
    ) -> Client:
        fence.close()
        client = self._make_client(member, arguments)
        if self._monitored:
            self._monitors[member.name] = monitor_of(client)
        return client

    def _make_client(self, member: Member, arguments: dict[str, Any]) -> Client:
        if member.twin and self.simulation:
            # The world is everyone's, so a program's own arguments do not choose it.
            return member.twin(simulation=self.simulation, name=member.name, start=member.start)
        return member.robot.load().hosted(arguments, {})

    def _make_recorder(self, member: Member, client: Client) -> Recorder:
        more = {} if self.is_deterministic else {"deterministic": False}
        label = {"robot": member.name}
        trace = self.trace
        if log := self._logs.get(member.name):
            trace = MemberTrace(trace, log, self._team_log if member.twin else None)
        return record(client, member.program.identity, trace, label, **more)


def _plain(member: Member) -> dict[str, object]:
    """What a log says about a robot of a shared world."""
    return {"name": member.name, "robot": member.robot.name, "start": member.start}


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


def _shared_world(twins: Sequence[Member], options: Options) -> Simulation | None:
    """The world of the first robot's choice, with all robots in it."""
    simulation = None
    for member in twins:
        kind = member.twin
        assert kind is not None  # noqa: S101 - only members with one are passed
        if simulation is None:
            simulation = kind.make_simulation(**options.wishes)
        simulation.world.add_robot(kind.description(), name=member.name, start=member.start)
    return simulation
