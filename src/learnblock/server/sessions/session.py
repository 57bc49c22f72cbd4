"""An open project, shared by every page that shows it."""

import asyncio
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

from anyio import to_thread

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.block_sets import BlockSet
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.reading import OpenLesson
from learnblock.project.document.document import Document
from learnblock.project.files.carried import Carried, Code
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.kept_runs import KeptRun
from learnblock.project.files.lesson_folder import Progress
from learnblock.project.files.project import LONGEST_PART_NAME, Project, is_part_name
from learnblock.project.files.unpacking import without
from learnblock.robots import RobotEntry
from learnblock.running import MOST_ROBOTS
from learnblock.server import catalog, messages
from learnblock.server.runs.keyboard import Keyboard
from learnblock.server.runs.player import Player
from learnblock.server.runs.shown import Shown
from learnblock.server.runs.viewers import Viewer, Viewers
from learnblock.server.sessions.archive import Archive
from learnblock.server.sessions.coach import Coach
from learnblock.server.sessions.offered_code import offer
from learnblock.server.sessions.part import Part
from learnblock.server.sessions.parts import Parts
from learnblock.server.sessions.periods import Periods
from learnblock.server.sessions.prepared import (
    DEFAULT_WORLD,
    Prepared,
    PreparedPart,
    empty_part,
    loaded,
    prepare,
)
from learnblock.server.sessions.runs import Runs


@dataclass(frozen=True)
class ClosedPart:
    """A program that was closed last with its robots, and can be reopened.

    Args:
        part: the program with its robots.
        index: its place among the others.
    """

    part: Part
    index: int


class Session:
    """An open project: one robot with its program, or several robots in one world.

    Its methods run in the event loop; a caller that changes the project must hold `turn`.

    Args:
        folder: the folder to save it in.
        prepared: the project.
        periods: when it is saved, and its file looked at.
    """

    def __init__(self, folder: ProjectFolder, prepared: Prepared, periods: Periods) -> None:
        self.name = prepared.name
        self.world = prepared.world
        #: The number of the world's variant; 0, the world as it is drawn, whenever it is opened.
        self.variant = 0
        self.shown_blocks = prepared.shown_blocks
        self.libraries = prepared.libraries
        self.tags = prepared.tags
        self.offered = prepared.offered
        self.turn = asyncio.Lock()
        #: Guides through a lesson; None if the project has none.
        self.coach: Coach | None = None
        self._folder = folder
        self._remarks = prepared.remarks
        self._notes = prepared.notes
        self._new_worlds = prepared.worlds
        self.viewers = Viewers()
        self.keyboard = Keyboard(self.viewers)
        self.parts = Parts(self._new_part(part) for part in prepared.parts)
        self._saved = self.project
        self._closed: ClosedPart | None = None
        self.archive = Archive(folder, self, periods)
        self.runs = Runs(self, folder)

    @property
    def project(self) -> Project:
        """The project in the form that is saved."""
        return self._project_with({})

    def _project_with(self, documents: Mapping[Part, Document]) -> Project:
        """The project with other programs of some parts."""
        programs = {part: documents.get(part, part.document) for part in self.parts}
        libraries = [self.libraries.used(document.good.tree) for document in programs.values()]
        project = Project(
            name=self.name,
            world=self.world,
            shown=self.shown_blocks.name,
            block_sets=self.shown_blocks.carried,
            libraries={name: used[name] for used in libraries for name in sorted(used)},
            tags=self.tags,
            carried=Carried(offered=self.offered),
        )
        return project.with_parts(
            [part.saved_with(document) for part, document in programs.items()]
        )

    @property
    def is_running(self) -> bool:
        """Whether its programs run, or are checked on all variants and robots of a lesson."""
        return self.runs.active or (self.coach is not None and self.coach.checking)

    async def close(self) -> None:
        """End the running programs, and save."""
        await self.runs.stop()
        if self.coach:
            await self.coach.close()
        for part in self.parts:
            await part.close()
        if self._closed:
            await self._closed.part.close()
        await self.archive.close()

    async def rename(self, name: str) -> None:
        """Rename the project, and tell every page.

        Raises:
            LearnBlockError: the name is taken, or the file can't be renamed.
        """
        await self.archive.rename(name)
        self._name_single()
        self.viewers.send(messages.ProjectRenamed(name))

    async def begin_lesson(self, opened: OpenLesson, browser: str) -> None:
        """Follow a lesson from its first step, in the browser with this id."""
        progress = Progress(opened.name, browser=browser)
        self.coach = Coach(self, opened, progress, self._folder.lesson)
        await self.coach.begin()

    async def resume_lesson(self) -> None:
        """Go on with the lesson that the project follows, if there is one."""
        progress = await to_thread.run_sync(self._folder.lesson(self.name).progress)
        if progress is None:
            return
        try:
            opened = await to_thread.run_sync(catalog.find_lesson, progress.lesson)
        except LearnBlockError as error:
            missing = Phrase("server-lesson-missing", name=progress.lesson, problem=error.phrase)
            self._remarks = (*self._remarks, missing)
            return
        self.coach = Coach(self, opened, progress, self._folder.lesson)
        await self.coach.resume()

    # Pages.

    def join(self, page: Viewer, tab: str = "") -> None:
        """Send a page the whole project, and all changes from now on.

        Args:
            page: the page.
            tab: the name of the robot to show; the first one if there is none with this name.
        """
        self.viewers.add(page)
        if self._new_worlds:
            page.send(messages.Worlds(self._new_worlds))
            self._new_worlds = ()
        part = self.parts.named(tab) or self.parts.first
        tab, robot = self.parts.tab_name(part), part.robot.name
        page.send(messages.Opened(self.name, robot, self.world, part.breakpoints, tab))
        page.send(messages.Tabs(self.parts.tabs, tab, part.players[0].voice.robot))
        page.send(self.shown_blocks.message())
        page.send(catalog.tag_dictionary())
        part.join(page, part.players[0])
        self.keyboard.join(page)
        if self.coach:
            self.coach.join(page)
        for remark in self._remarks:
            page.send(messages.Failed(remark))
        for note in self._notes:
            page.send(messages.Noted(note))
        # Those who come later have not seen anything change.
        self._notes = ()
        if self.offered:
            page.send(offer(self.offered))

    def leave(self, page: Viewer) -> None:
        """Stop sending messages to a page."""
        self.viewers.remove(page)
        self.keyboard.leave(page)
        self.parts.shown_to(page).leave(page)

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
        page.shown = Shown(page.shown.number + 1)
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
        self.keyboard.leave(page)
        self.keyboard.join(page)

    # Robots.

    async def add_robots(self, page: Viewer, robot: str, count: int) -> None:
        """Add an empty program for one or more robots of a kind, and show it to the page.

        Raises:
            LearnBlockError: there is no such robot, no room, too many, several real ones, or a
                program runs.
        """
        self.runs.require_rest()
        self._require_few(count)
        entry = await to_thread.run_sync(loaded, robot)
        _require_simulated(entry, count)
        prepared = await to_thread.run_sync(
            empty_part, self.parts.free_name(entry.name), entry, count
        )
        await self._insert(self._new_part(prepared), len(self.parts))
        self.show(page, self.parts.last.name)

    async def set_robot_count(self, part: Part, count: int) -> None:
        """Let another number of robots run a program.

        Raises:
            LearnBlockError: there is no room, there are too many, or several real ones, or a
                program runs.
        """
        before = len(part.players)
        if count == before:
            return
        self.runs.require_rest()
        self._require_few(count - before)
        _require_simulated(part.robot, count)
        left = self._resize(part, count)
        try:
            await self.runs.set_the_stage()
        except LearnBlockError:
            left += self._resize(part, before)
            raise
        finally:
            for player in left:
                await player.close()
        part.forget_run()
        self._name_single()
        self.part_changed()

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

    async def _set_robot_counts(self, counts: Iterable[tuple[Part, int]]) -> None:
        """Let other numbers of robots run some programs; those that lose robots come first."""
        for part, count in sorted(counts, key=lambda change: change[1] - len(change[0].players)):
            await self.set_robot_count(part, count)

    def _require_few(self, more: int) -> None:
        if len(self.parts.kinds) + more > MOST_ROBOTS:
            raise LearnBlockError("tabs-too-many", limit=MOST_ROBOTS)

    async def close_robot(self, name: str) -> None:
        """Close a program with its robots; it can be reopened until the next one is closed.

        Raises:
            LearnBlockError: it is the last one, or a program runs.
        """
        self.runs.require_rest()
        part = self.parts.require(name)
        if len(self.parts) == 1:
            raise LearnBlockError("tabs-last")
        await self.archive.keep_version("time")
        index = self.parts.index(part)
        self.parts.remove(part)
        before, self._closed = self._closed, ClosedPart(part, index)
        if before:
            await before.part.close()
        for page in part.viewers:
            part.leave(page)
            self._show(page, tuple(self.parts)[max(0, index - 1)])
        self._name_single()
        await self.set_the_stage()
        self.part_changed()

    async def reopen_robot(self, page: Viewer) -> None:
        """Reopen the program that was closed last, and show it to the page.

        Raises:
            LearnBlockError: none was closed, there are too many, or a program runs.
        """
        self.runs.require_rest()
        if self._closed is None:
            raise LearnBlockError("tabs-none-closed")
        self._require_few(len(self._closed.part.players))
        part, index = self._closed.part, self._closed.index
        self._closed = None
        part.name = self.parts.free_name(part.name)
        await self._insert(part, index)
        self.show(page, part.name)

    async def rename_robot(self, name: str, new: str) -> None:
        """Rename a robot, or all that share a program.

        Raises:
            LearnBlockError: a robot can't have this name, or a program runs.
        """
        self.runs.require_rest()
        part = self.parts.require(name)
        if not is_part_name(new) or (self.parts.named(new) not in (None, part)):
            raise LearnBlockError("tabs-wrong-name", name=new, limit=LONGEST_PART_NAME)
        part.name = new
        self.parts.name_robots()
        # It has the name in the world too.
        await self.set_the_stage()
        self.part_changed()

    def part_changed(self) -> None:
        """Save the project, and show the pages what has changed on a tab."""
        self.show_tabs()
        self.archive.changed()

    def show_tabs(self) -> None:
        """Show the pages what has changed on a tab."""
        self.parts.show_tabs()

    async def _insert(self, part: Part, index: int) -> None:
        self.parts.insert(index, part)
        try:
            await self.runs.set_the_stage()
        except LearnBlockError:
            self.parts.remove(part)
            raise
        self.part_changed()

    def _new_part(self, prepared: PreparedPart) -> Part:
        return Part(prepared, self)

    def _name_single(self) -> None:
        """Give a robot that is alone the name that it has when the project is opened again."""
        if not self.parts.has_several:
            self.parts.first.name = self.project.parts[0].name
        self.parts.name_robots()

    # The programs.

    async def restore(self, earlier: Project) -> None:
        """Restore earlier programs, with the current world; robots added since then stay."""
        self.runs.require_rest()
        await self.archive.keep_version("restored")
        prepared = await to_thread.run_sync(prepare, earlier)
        like = [
            (self.parts.like(prepared_part, len(prepared.parts)), prepared_part)
            for prepared_part in prepared.parts
        ]
        await self._set_robot_counts(
            (part, prepared_part.count) for part, prepared_part in like if part
        )
        for part, prepared_part in like:
            if part:
                await part.restore(prepared_part.document)
            else:
                await self._insert(self._new_part(prepared_part), len(self.parts))

    async def know(self, configurations: Mapping[str, BlockConfiguration]) -> None:
        """Read the programs with a changed set of skills."""
        self.libraries = await to_thread.run_sync(self.libraries.renewed)
        for part in self.parts:
            await part.know(configurations)

    async def keep_lost(
        self, part: Part, lost: Document, pages: Iterable[Viewer], by: Literal["page", "before"]
    ) -> None:
        """Save a version with a change that the program of a part lacks, and say so."""
        version = await self.archive.keep_version("conflict", self._project_with({part: lost}))
        for page in pages:
            page.send(messages.Conflict(version, by))

    # The file.

    def saving(self) -> tuple[Project, Callable[[], None]]:
        """Return the project, and what confirms the last edit of each page once it is saved."""
        edits = [(page, page.shown, page.shown.edit) for page in self.viewers]
        project = self.project
        saves = [(part.program.revisions, part.program.revisions.number) for part in self.parts]

        def saved() -> None:
            self._saved = project
            for revisions, number in saves:
                revisions.saved(number)
            for page, shown, edit in edits:
                # A page that now shows another robot counts its edits from the start again.
                if page.shown is shown:
                    page.send(messages.Saved(edit))

        return project, saved

    async def take_in(self, outside: Project) -> bool:
        """Merge the project as another program has saved it; what was changed here wins.

        Returns:
            Whether the project lacks a change of the other program.
        """
        await self.archive.keep_version("time")
        read_only = self._folder.read_only
        prepared = await to_thread.run_sync(lambda: prepare(outside, read_only=read_only))
        is_lost = await self._take_in_robots(outside, prepared)
        await self._take_in_settings(self._saved, outside, prepared)
        for saved, prepared_part in zip(outside.parts, prepared.parts, strict=True):
            if part := self.parts.like(prepared_part, len(outside.parts)):
                is_lost |= await part.take_in(saved, prepared_part.document)
        if not is_lost:
            self.viewers.send(messages.TakenIn())
        return is_lost

    def kept_outside(self, version: str) -> None:
        """Tell every page which version has another program's change that could not be merged."""
        self.viewers.send(messages.Conflict(version, "file"))

    async def _take_in_robots(self, outside: Project, found: Prepared) -> bool:
        """Add and close the robots that another program has; return whether that is impossible."""
        before = {part.name for part in self._saved.parts}
        after = {part.name for part in outside.parts}
        if before == after or len(before) == len(after) == 1:
            return False
        try:
            for prepared in found.parts:
                if self.parts.named(prepared.name) is None and prepared.name not in before:
                    await self._insert(self._new_part(prepared), len(self.parts))
            for name in before - after:
                if self.parts.named(name):
                    await self.close_robot(name)
        except LearnBlockError as error:
            self.failed(error.phrase)
            return True
        return False

    async def _take_in_settings(self, saved: Project, outside: Project, found: Prepared) -> None:
        """Choose what another program has chosen, unless a running program forbids it."""
        before = {part.name: part for part in saved.parts}
        try:
            for there, prepared in zip(outside.parts, found.parts, strict=True):
                part, last = self.parts.like(prepared, len(outside.parts)), before.get(there.name)
                if part and last and there.robot != last.robot:
                    await self.choose_robot(part, prepared.robot.name)
                if part and last and there.count != last.count:
                    await self.set_robot_count(part, prepared.count)
                if part and last and there.breakpoints != last.breakpoints:
                    self.set_breakpoints(part, prepared.breakpoints)
            if outside.world != saved.world:
                await self.choose_world(found.world)
        except LearnBlockError as error:
            self.failed(error.phrase)
        if (outside.shown, outside.block_sets) != (saved.shown, saved.block_sets):
            self.shown_blocks = found.shown_blocks
            self.viewers.send(self.shown_blocks.message())

    def runs_kept(self, runs: tuple[KeptRun, ...]) -> None:
        """Tell every page which runs are kept."""
        self.viewers.send(messages.KeptRuns(runs))

    def failed(self, message: Phrase) -> None:
        """Tell every page what went wrong."""
        self.viewers.send(messages.Failed(message))

    def installed(self, code: Code) -> None:
        """Record that offered code has been installed."""
        self.offered = without(self.offered, code)
        self.viewers.send(offer(self.offered))
        self.archive.changed()

    def tags_changed(self, before: Mapping[str, int], after: Mapping[str, int]) -> None:
        """Use the user's numbers of tags where the user has just changed them."""
        own = self.tags.items()
        self.tags = {name: tag for name, tag in own if before.get(name) == after.get(name)}
        if own != self.tags.items():
            self.archive.changed()

    # Settings.

    async def set_the_stage(self) -> None:
        """Put the robots into their world; a problem is shown to every page.

        The user can choose another world.
        """
        try:
            await self.runs.set_the_stage()
        except LearnBlockError as error:
            self._remarks = (*self._remarks, error.phrase)
            self.failed(error.phrase)

    async def choose_robot(self, part: Part, name: str) -> None:
        """Change the kind of a robot, in the same world.

        Raises:
            LearnBlockError: the robot does not exist, several would be real ones, or a program is
                running.
        """
        self.runs.require_rest()
        robot = await to_thread.run_sync(loaded, name)
        _require_simulated(robot, len(part.players))
        await self.runs.set_the_stage({part: robot})
        await part.use(robot)
        self._send_settings()

    async def choose_world(self, name: str, variant: int = 0) -> None:
        """Change the world, or its variant.

        Raises:
            LearnBlockError: the world or its variant does not exist, or a program is running.
        """
        await to_thread.run_sync(catalog.check_world_name, name)
        await self.runs.set_the_stage(world=(name, variant))
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

    def show_blocks(self, block_set: BlockSet) -> None:
        """Show the blocks of a set in the palette.

        Raises:
            BlockSetError: the set has an unusable name.
        """
        self.shown_blocks = self.shown_blocks.choosing(block_set)
        self.viewers.send(self.shown_blocks.message())
        self.archive.changed()

    def part_ended(self, ended: messages.Ended) -> None:
        """Record how the program of a part ended."""
        self.runs.ended(ended)

    def _send_settings(self) -> None:
        for part in self.parts:
            settings = messages.Settings(part.robot.name, self.world, part.breakpoints)
            part.viewers.send(settings)
        self.part_changed()


def _require_simulated(robot: RobotEntry, count: int) -> None:
    """Refuse several real robots of a kind: all would use one connection."""
    if count > 1 and not robot.load().lockstep:
        raise LearnBlockError("tabs-one-real", robot=robot.name)
