"""The robots of an open project in their world."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Protocol

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.project.files.project import LONGEST_PART_NAME, Project, is_part_name
from learnblock.robots import RobotEntry
from learnblock.running import MOST_ROBOTS
from learnblock.server import catalog, messages
from learnblock.server.runs.player import Player
from learnblock.server.runs.shown import ShownProgram
from learnblock.server.runs.viewers import Viewer
from learnblock.server.sessions.archive import Archive
from learnblock.server.sessions.part import Part, PartHome
from learnblock.server.sessions.parts import Parts
from learnblock.server.sessions.prepared import (
    DEFAULT_WORLD,
    Prepared,
    PreparedPart,
    empty_part,
    loaded,
)
from learnblock.server.sessions.runs import Runs


class RobotsProject(PartHome, Protocol):
    """The project that the robots belong to."""

    @property
    def project(self) -> Project:
        """The project in the form that is saved."""

    @property
    def archive(self) -> Archive:
        """Saves it."""

    @property
    def runs(self) -> Runs:
        """The runs of its programs."""

    def remark(self, problem: Phrase) -> None:
        """Tell every page of a problem, also those that join later."""


@dataclass(frozen=True)
class ClosedPart:
    """A program that was closed last with its robots, and can be reopened.

    Args:
        part: the program with its robots.
        index: its place among the others.
    """

    part: Part
    index: int


class ProjectRobots:
    """The robots of an open project in their world: which there are, and what they run.

    Its methods run in the event loop; a caller that changes something must hold the project's
    `turn`.

    Args:
        project: the project.
        prepared: its robots, programs and world.
    """

    def __init__(self, project: RobotsProject, prepared: Prepared) -> None:
        self.parts = Parts(Part(part, project) for part in prepared.parts)
        self.world = prepared.world
        #: The number of the world's variant; 0, the world as it is drawn, whenever it is opened.
        self.variant = 0
        self._project = project
        self._closed: ClosedPart | None = None

    async def end(self) -> None:
        """Stop the programs and the robots, because the project is closed."""
        for part in self.parts:
            await part.close()
        if self._closed:
            await self._closed.part.close()

    # Which there are.

    async def add(self, page: Viewer, robot: str, count: int) -> None:
        """Add an empty program for one or more robots of a kind, and show it to the page.

        Raises:
            LearnBlockError: there is no such robot, no room, too many, several real ones, or a
                program runs.
        """
        self._project.runs.require_rest()
        self._require_few(count)
        entry = await to_thread.run_sync(loaded, robot)
        _require_simulated(entry, count)
        prepared = await to_thread.run_sync(
            empty_part, self.parts.free_name(entry.name), entry, count
        )
        await self.append(prepared)
        self.show(page, self.parts.last.name)

    async def set_count(self, part: Part, count: int) -> None:
        """Let another number of robots run a program.

        Raises:
            LearnBlockError: there is no room, there are too many, or several real ones, or a
                program runs.
        """
        before = len(part.players)
        if count == before:
            return
        self._project.runs.require_rest()
        self._require_few(count - before)
        _require_simulated(part.robot, count)
        left = self._resize(part, count)
        try:
            await self._project.runs.set_the_stage()
        except LearnBlockError:
            left += self._resize(part, before)
            raise
        finally:
            for player in left:
                await player.close()
        part.forget_run()
        self.name_single()
        self._project.part_changed()

    def _resize(self, part: Part, count: int) -> tuple[Player, ...]:
        """Let another number of robots run a program; return those that are left over."""
        pages = [page for player in part.players[count:] for page in player.viewers]
        for page in pages:
            part.leave(page)
        left = part.set_count(count)
        self.parts.name_robots()
        for page in pages:
            self._show(page, part)
        return left

    async def _set_counts(self, counts: Iterable[tuple[Part, int]]) -> None:
        """Let other numbers of robots run some programs; those that lose robots come first."""
        for part, count in sorted(counts, key=lambda change: change[1] - len(change[0].players)):
            await self.set_count(part, count)

    def _require_few(self, more: int) -> None:
        if len(self.parts.kinds) + more > MOST_ROBOTS:
            raise LearnBlockError("tabs-too-many", limit=MOST_ROBOTS)

    async def close(self, name: str) -> None:
        """Close a program with its robots; it can be reopened until the next one is closed.

        Raises:
            LearnBlockError: it is the last one, or a program runs.
        """
        self._project.runs.require_rest()
        part = self.parts.require(name)
        if len(self.parts) == 1:
            raise LearnBlockError("tabs-last")
        await self._project.archive.keep_version("time")
        index = self.parts.index(part)
        self.parts.remove(part)
        before, self._closed = self._closed, ClosedPart(part, index)
        if before:
            await before.part.close()
        for page in part.viewers:
            part.leave(page)
            self._show(page, tuple(self.parts)[max(0, index - 1)])
        self.name_single()
        await self.set_the_stage()
        self._project.part_changed()

    async def reopen(self, page: Viewer) -> None:
        """Reopen the program that was closed last, and show it to the page.

        Raises:
            LearnBlockError: none was closed, there are too many, or a program runs.
        """
        self._project.runs.require_rest()
        if self._closed is None:
            raise LearnBlockError("tabs-none-closed")
        self._require_few(len(self._closed.part.players))
        part, index = self._closed.part, self._closed.index
        self._closed = None
        part.name = self.parts.free_name(part.name)
        await self._insert(part, index)
        self.show(page, part.name)

    async def rename(self, name: str, new: str) -> None:
        """Rename a robot, or all that share a program.

        Raises:
            LearnBlockError: a robot can't have this name, or a program runs.
        """
        self._project.runs.require_rest()
        part = self.parts.require(name)
        if not is_part_name(new) or (self.parts.named(new) not in (None, part)):
            raise LearnBlockError("tabs-wrong-name", name=new, limit=LONGEST_PART_NAME)
        part.name = new
        self.parts.name_robots()
        # It has the name in the world too.
        await self.set_the_stage()
        self._project.part_changed()

    async def append(self, prepared: PreparedPart) -> None:
        """Add a program with its robots.

        Raises:
            LearnBlockError: there is no room, or a program runs.
        """
        await self._insert(Part(prepared, self._project), len(self.parts))

    async def restore(self, earlier: Prepared) -> None:
        """Restore earlier programs and numbers of robots; robots added since then stay."""
        like = [
            (self.parts.like(prepared_part, len(earlier.parts)), prepared_part)
            for prepared_part in earlier.parts
        ]
        await self._set_counts((part, prepared_part.count) for part, prepared_part in like if part)
        for part, prepared_part in like:
            if part:
                await part.restore(prepared_part.document)
            else:
                await self.append(prepared_part)

    async def _insert(self, part: Part, index: int) -> None:
        self.parts.insert(index, part)
        try:
            await self._project.runs.set_the_stage()
        except LearnBlockError:
            self.parts.remove(part)
            raise
        self._project.part_changed()

    def name_single(self) -> None:
        """Give a robot that is alone the name that it has when the project is opened again."""
        if not self.parts.has_several:
            self.parts.first.name = self._project.project.parts[0].name
        self.parts.name_robots()

    # Pages.

    def show(self, page: Viewer, tab: str, robot: str = "") -> None:
        """Show a page another robot.

        Args:
            page: the page.
            tab: the name of its program's tab; the current one if there is none with this name.
            robot: its name, if several run the program; the first if there is none.
        """
        before = self.parts.shown_to(page)
        before.leave(page)
        self._show(page, self.parts.named(tab) or before, robot)

    def _show(self, page: Viewer, part: Part, robot: str = "") -> None:
        page.shown = ShownProgram(page.shown.number + 1)
        player = part.player_named(robot)
        page.send(
            messages.TabOpened(
                self.parts.tab_name(part),
                part.robot.name,
                self.world,
                page.shown.number,
                part.breakpoints,
                player.voice.robot,
            )
        )
        part.join(page, player)
        # The page has forgotten which keys its user held.
        self._project.keyboard.release(page)
        self._project.keyboard.join(page)

    # Their kinds, and their world.

    async def set_the_stage(self) -> None:
        """Put the robots into their world; a problem is shown to every page.

        The user can choose another world.
        """
        try:
            await self._project.runs.set_the_stage()
        except LearnBlockError as error:
            self._project.remark(error.phrase)

    async def choose(self, part: Part, name: str) -> None:
        """Change the kind of a robot, in the same world.

        Raises:
            LearnBlockError: the robot does not exist, several would be real ones, or a program is
                running.
        """
        self._project.runs.require_rest()
        robot = await to_thread.run_sync(loaded, name)
        _require_simulated(robot, len(part.players))
        await self._project.runs.set_the_stage({part: robot})
        await part.use(robot)
        self._send_settings()

    async def choose_world(self, name: str, variant: int = 0) -> None:
        """Change the world, or its variant.

        Raises:
            LearnBlockError: the world or its variant does not exist, or a program is running.
        """
        await to_thread.run_sync(catalog.check_world_name, name)
        await self._project.runs.set_the_stage(world=(name, variant))
        if (name, variant) != (self.world, self.variant):
            for part in self.parts:
                part.forget_run()
        self.world, self.variant = name, variant
        self._send_settings()

    async def leave_world(self, name: str) -> None:
        """Choose the robot's usual world if the current one is this one.

        Raises:
            LearnBlockError: a program is running.
        """
        if self.world != name:
            return
        usual = await to_thread.run_sync(catalog.usual_world, self.parts.first.robot)
        await self.choose_world(DEFAULT_WORLD if usual in (None, name) else usual)

    def set_breakpoints(self, part: Part, blocks: tuple[str, ...]) -> None:
        """Set the blocks before which a program pauses."""
        part.breakpoints = blocks
        for player in part.players:
            player.set_breakpoints(blocks)
        self._send_settings()

    def _send_settings(self) -> None:
        for part in self.parts:
            settings = messages.Settings(part.robot.name, self.world, part.breakpoints)
            part.viewers.send(settings)
        self._project.part_changed()


def _require_simulated(robot: RobotEntry, count: int) -> None:
    """Refuse several real robots of a kind: all would use one connection."""
    if count > 1 and not robot.load().lockstep:
        raise LearnBlockError("tabs-one-real", robot=robot.name)
