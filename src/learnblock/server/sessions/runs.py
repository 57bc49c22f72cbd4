"""The robots of an open project in their world, and the runs of their programs."""

import asyncio
from collections.abc import Mapping, Sequence
from dataclasses import replace
from time import time
from typing import Protocol

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.history import PastRun
from learnblock.robots import RobotEntry
from learnblock.running import Options, may_use_network
from learnblock.running.job import Job
from learnblock.running.recorded_keys import RecordedKeys
from learnblock.runtime.trace_sinks import LineSink
from learnblock.server import messages
from learnblock.server.runs.function_call import FunctionCall
from learnblock.server.runs.guest_program import GuestProgram
from learnblock.server.runs.player import Player
from learnblock.server.runs.playing import Played, prepared
from learnblock.server.runs.together import Participant, play_together, staged
from learnblock.server.sessions.archive import Archive
from learnblock.server.sessions.part import Part
from learnblock.server.sessions.parts import Parts
from learnblock.server.sessions.run_proof import RunProof

#: The seed of the command line, so that the same run can be repeated there.
SEED = 0


class RunObserver(Protocol):
    """Judges the runs of a project."""

    def watch(self) -> tuple[LineSink, float]:
        """Begin to judge a run that is about to start: what takes its lines, and its limit in s."""

    def ended(self) -> None:
        """Judge the run, whose programs have all ended."""


class RunProject(Protocol):
    """An open project, as far as its runs need it."""

    @property
    def name(self) -> str:
        """Its name."""

    @property
    def parts(self) -> Parts:
        """Its programs with their robots."""

    @property
    def world(self) -> str:
        """The name of its world."""

    @property
    def variant(self) -> int:
        """The number of the world's variant."""

    @property
    def tags(self) -> Mapping[str, int]:
        """The names of tags, and their numbers."""

    @property
    def archive(self) -> Archive:
        """Saves it."""

    @property
    def proof(self) -> RunProof:
        """Knows its last run."""

    @property
    def coach(self) -> RunObserver | None:
        """Guides through a lesson; None if the project has none."""


class Runs:
    """Starts and stops all programs of a project together.

    Args:
        project: the project.
        folder: the folder of its file.
    """

    def __init__(self, project: RunProject, folder: ProjectFolder) -> None:
        self._project = project
        self._folder = folder
        self._last_run = (0.0, "")
        self._network = False
        self._speed: float | None = 1.0
        #: How the programs of this run have ended so far.
        self._endings: list[messages.Ended] = []

    @property
    def active(self) -> bool:
        """Whether a program is running."""
        return any(player.active for player in self._players)

    @property
    def uses_network(self) -> bool:
        """Whether a program is running that may use the network."""
        return self._network and self.active

    def require_rest(self) -> None:
        """Refuse what is impossible while a program runs.

        Raises:
            LearnBlockError: a program runs.
        """
        if self.active:
            raise LearnBlockError("play-program-running")

    async def set_the_stage(
        self,
        robots: Mapping[Part, RobotEntry] | None = None,
        world: tuple[str, int] | None = None,
    ) -> None:
        """Put the robots into their world.

        Args:
            robots: other kinds of some robots.
            world: the name of another world, and the number of its variant.

        Raises:
            LearnBlockError: there is no room for them, or a program runs.
        """
        self.require_rest()
        chosen = robots or {}
        kinds = {
            part.name_of(player): chosen.get(part, part.robot) for part, player in self._robots
        }
        name, variant = world or (self._project.world, self._project.variant)
        monitors = await to_thread.run_sync(staged, kinds, name, variant)
        for player, monitor in zip(self._players, monitors, strict=True):
            await player.stage(monitor)
            # A robot that was added has to be as fast as the others: they share the world's time.
            player.set_speed(self._speed)

    async def run(self, player: Player, *, paused: bool, keys: RecordedKeys | None = None) -> None:
        """Run all programs from the start, and save a version of the project.

        Args:
            player: the one that is paused.
            paused: whether to pause before its first line.
            keys: the keys that are pressed for the first robot, instead of those of the pages.

        Raises:
            LearnBlockError: a program has errors.
        """
        for part in self._parts:
            self._require_no_errors(part)
        await self.stop()
        self._endings.clear()
        self._last_run = (time(), await self._project.archive.keep_version("run"))
        jobs = [await self._job(part, member, part.played) for part, member in self._robots]
        self._project.proof.begin(jobs, has_guest=any(part.has_guest for part in self._parts))
        lines = None
        if coach := self._project.coach:
            lines, seconds = coach.watch()
            options = replace(jobs[0].options, seconds=seconds)
            jobs[0] = replace(jobs[0], options=options, keys=keys)
        try:
            await self._start(jobs, lines, player if paused else None)
        except Exception:
            if coach:
                coach.ended()
            raise

    async def _start(
        self, jobs: Sequence[Job], lines: LineSink | None, paused: Player | None
    ) -> None:
        if len(jobs) == 1:
            [(part, player)] = self._robots
            playing = prepared(
                part.played,
                jobs[0],
                player,
                breakpoints=part.breakpoints,
                lines=lines,
                paused=player is paused,
            )
            await player.run(playing)
            return
        participants = [
            Participant(
                player,
                part.name_of(player),
                part.played,
                job,
                part.breakpoints,
                paused=player is paused,
            )
            for (part, player), job in zip(self._robots, jobs, strict=True)
        ]
        await play_together(participants, lines)

    async def try_out(self, part: Part, player: Player, call: FunctionCall) -> None:
        """Run a single function on one of the robots instead of the programs."""
        await self.stop()
        job = await self._job(part, player, call)
        await player.run(prepared(call, job, player))

    async def stop(self) -> None:
        """Stop all programs and robots, and return once they have stopped."""
        await asyncio.gather(*(player.stop() for player in self._players))

    def set_speed(self, factor: float | None) -> None:
        """Set the speed of this and later runs, as a multiple of real time; None is the fastest."""
        self._speed = factor
        for player in self._players:
            player.set_speed(factor)

    def place(self, player: Player, x: float, y: float, heading: float) -> None:
        """Place a robot; the next run starts there.

        Raises:
            LearnBlockError: something moves, or it is a real robot.
        """
        player.place(x, y, heading)
        self._attend()

    def drive(self, player: Player, advance: float, rotation: float) -> None:
        """Drive a robot by hand.

        Raises:
            LearnBlockError: a program runs, or the robot is a real one.
        """
        player.drive(advance, rotation)
        self._attend()

    def ended(self, ended: messages.Ended) -> None:
        """Record how a program ended; the run is over when all have."""
        self._endings.append(ended)
        if ended.tried or len(self._endings) < len(self._players):
            return
        if coach := self._project.coach:
            coach.ended()
        self._keep_run()
        if compared := self._project.proof.end(self._endings):
            for player in self._players:
                player.viewers.send(compared)

    @property
    def _parts(self) -> Parts:
        return self._project.parts

    @property
    def _robots(self) -> list[tuple[Part, Player]]:
        """All robots, each with its program."""
        return [(part, player) for part in self._parts for player in part.players]

    @property
    def _players(self) -> list[Player]:
        return [player for _, player in self._robots]

    def _attend(self) -> None:
        for player in self._players:
            player.attend()

    def _require_no_errors(self, part: Part) -> None:
        if part.has_guest:
            return
        try:
            part.document.require_no_errors()
        except LearnBlockError as error:
            if len(self._parts) == 1:
                raise
            raise LearnBlockError("tabs-error", name=part.name, problem=error.phrase) from None

    async def _job(self, part: Part, player: Player, played: Played) -> Job:
        file = self._folder.file(self._project.name)
        self._network = await to_thread.run_sync(may_use_network, file)
        program = played.program(self._name(part, player))
        options = Options(
            world=self._project.world,
            seed=SEED,
            variant=self._project.variant,
            start=player.start,
            network=self._network and not isinstance(played, GuestProgram),
        )
        return Job(replace(program, tags=self._project.tags), part.robot, options)

    def _name(self, part: Part, player: Player) -> str:
        """The name of a robot in a run; one that is alone has that of the project."""
        if len(self._players) == 1:
            return self._project.name
        return part.name_of(player)

    def _keep_run(self) -> None:
        began, version = self._last_run
        first = self._endings[0]
        worst = next((ending for ending in self._endings if ending.ended != "finished"), first)
        self._project.archive.add_run(
            PastRun(
                time=began,
                robot=", ".join(part.robot.name for part in self._parts),
                world=self._project.world,
                ended=worst.ended,
                seconds=max(ending.time for ending in self._endings),
                goals=tuple(goal.name for goal in first.goals if goal.state == "reached"),
                trace_sha256=first.trace_sha256,
                version=version,
            )
        )
        newest_runs = (player.shown_run.newest for player in self._players)
        self._project.archive.keep_logs(
            began, version, [newest.log.blocks for newest in newest_runs if newest]
        )
