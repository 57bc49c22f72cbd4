"""Several robots of a project in one world, and one run of all their programs."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING

from learnblock.running import Report
from learnblock.running.job import Job
from learnblock.runtime.debugger import Debugger, HeldBy
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program
from learnblock.runtime.status import State
from learnblock.runtime.trace_sinks import LineSink
from learnblock.server.runs.guest_program import GuestProgram
from learnblock.server.runs.looking import Looking
from learnblock.server.runs.player import Player
from learnblock.server.runs.playing import Played, Playing, first_lines, follow, looking_at
from learnblock.server.runs.watcher import RunWatcher

if TYPE_CHECKING:
    from learnblock.monitor import Monitor
    from learnblock.robots import RobotEntry
    from learnblock.running.team import TeamReport, TeamRun


def staged(robots: "Mapping[str, RobotEntry]", world: str, variant: int) -> "Sequence[Monitor]":
    """The monitors of robots in a world; this is slow.

    Args:
        robots: the kinds of robots, by name.
        world: the name of the world.
        variant: the number of its variant; 0 is the world as it is drawn.

    Raises:
        LearnBlockError: there is no such world, or it has no room.
    """
    # The server answers before the simulator is loaded, which is slow.
    from learnblock.monitor import make_monitor, make_monitors  # noqa: PLC0415

    if len(robots) == 1:
        return [make_monitor(entry, world, variant=variant) for entry in robots.values()]
    return make_monitors(robots, world, variant)


class MemberRun:
    """One program of a run of several; pausing it pauses all.

    Args:
        team: the run.
        robot: its name.
        debuggers: those of all robots, by name.
    """

    def __init__(self, team: "TeamRun", robot: str, debuggers: Mapping[str, Debugger]) -> None:
        self._team = team
        self._robot = robot
        self._debuggers = debuggers

    @property
    def program(self) -> Program:
        """The program."""
        return self._team.jobs[self._robot].program

    @property
    def monitor(self) -> "Monitor | None":
        """The robot as the page shows it, once the program has created it."""
        return self._team.monitor(self._robot)

    @property
    def is_deterministic(self) -> bool:
        """Whether no real robot takes part."""
        return self._team.is_deterministic

    @property
    def recorder(self) -> None:
        """Not kept apart from those of other robots while they run."""

    def run(self) -> Report:
        """The report of this program; the whole run is started elsewhere."""
        return self._team.report(self._robot)

    def stop(self) -> None:
        """End all programs."""
        self._team.stop()

    def abort(self) -> None:
        """Kill all programs."""
        self._team.abort()

    def pause(self) -> None:
        """Pause the world at once, and all programs at their next lines."""
        for debugger in self._debuggers.values():
            debugger.pause()

    def resume(self) -> None:
        """Continue all programs."""
        for debugger in self._debuggers.values():
            debugger.resume()

    def step(self) -> None:
        """Run to the next line of this program; the others continue until then."""
        self._own.pause()
        self._own.step()
        self._resume_others()

    def step_over(self) -> None:
        """Run to the next line of the same function; the other programs continue until then."""
        self._own.pause()
        self._own.step_over()
        self._resume_others()

    def set_breakpoints(self, lines: Collection[int]) -> None:
        self._own.set_breakpoints(lines)

    def held_by(self, line: int) -> HeldBy:
        return self._own.held_by(line)

    def set_speed(self, factor: float | None) -> None:
        self._team.set_speed(factor)

    def report_variables(self, *, enabled: bool) -> None:
        self._team.report_variables(self._robot, enabled=enabled)

    @property
    def _own(self) -> Debugger:
        return self._debuggers[self._robot]

    def _resume_others(self) -> None:
        for debugger in self._debuggers.values():
            if debugger is not self._own:
                debugger.resume()


class MemberWatcher(RunWatcher):
    """Watches one program of a run of several, which may end before the others."""

    #: The program's part of the run.
    run: MemberRun

    def state(self, state: State) -> None:
        super().state(state)
        if state is State.ENDED:
            self._pass_on(self._listener.on_done, self.run.run())


@dataclass(frozen=True, slots=True)
class Participant:
    """A robot of a run of several.

    Args:
        player: follows its program.
        name: its name in the run.
        played: its program.
        job: its run, if it were alone; all have the same world.
        breakpoints: the blocks before which its program pauses.
        paused: whether to pause before the first line.
    """

    player: Player
    name: str
    played: Played
    job: Job
    breakpoints: tuple[str, ...] = ()
    paused: bool = False

    def watcher(self) -> MemberWatcher:
        """Watches its part of the run."""
        return MemberWatcher(self.player, self.job.keys)

    def looking(self, log: RunLog) -> Looking | None:
        """Looks back at the run of this robot; None for a guest's program, which no page shows."""
        return None if isinstance(self.played, GuestProgram) else looking_at(self.played, log)

    def debugger(self) -> Debugger:
        """What pauses the program."""
        return Debugger(first_lines(self.played, self.breakpoints), paused=self.paused)


async def play_together(participants: Sequence[Participant], lines: LineSink | None = None) -> None:
    """Run programs in one world from the beginning; if they can't begin, the pages show why.

    Args:
        participants: the robots, in the order in which they take turns.
        lines: takes the lines of the trace; None for nothing.

    Raises:
        LearnBlockError: there is no room for all robots.
    """
    from learnblock.running.team import TeamRun  # noqa: PLC0415 - as above

    watchers = {participant.name: participant.watcher() for participant in participants}
    debuggers = {participant.name: participant.debugger() for participant in participants}
    jobs = {participant.name: participant.job for participant in participants}
    logs = {name: RunLog(job.program) for name, job in jobs.items()}
    team = TeamRun(
        jobs,
        lines=lines,
        watch=watchers.__getitem__,
        debug=debuggers.__getitem__,
        monitored=True,
        logs=logs,
    )
    playings = []
    for participant in participants:
        watcher = watchers[participant.name]
        watcher.run = MemberRun(team, participant.name, debuggers)
        looking = participant.looking(logs[participant.name])
        playings.append(Playing(participant.played, watcher.run, watcher, looking))
    try:
        for playing, participant in zip(playings, participants, strict=True):
            await participant.player.begin(playing)
        follow(playings, partial(_play, team))
    except Exception as error:
        if not any(participant.player.active for participant in participants):
            raise
        for participant in participants:
            participant.player.take_back(error)


def _play(team: "TeamRun", playings: Sequence[Playing]) -> None:
    outcomes: Sequence[Report | Exception]
    try:
        outcomes = _outcomes(team.run())
    except Exception as error:  # noqa: BLE001 - a driver may raise any exception
        outcomes = [error] * len(playings)
    for playing, outcome in zip(playings, outcomes, strict=True):
        playing.watcher.ended(outcome)


def _outcomes(report: "TeamReport") -> Sequence[Report]:
    """The report of each robot, with the goals and the trace of the whole run."""
    trace = report.trace_sha256 or ""
    return [
        replace(own_report, goals=report.goals, trace_sha256=trace)
        for own_report in report.robots.values()
    ]
