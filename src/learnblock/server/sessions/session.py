"""An open project, shared by every page that shows it."""

import asyncio
from collections.abc import Callable, Iterable, Mapping
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
from learnblock.project.files.project import Project
from learnblock.project.files.share_link import SharedProject
from learnblock.project.files.shared_record import SharedRecord
from learnblock.project.files.unpacking import without
from learnblock.server import catalog, messages
from learnblock.server.runs.keyboard import SharedKeyboard
from learnblock.server.runs.viewers import Viewer, Viewers
from learnblock.server.sessions.archive import Archive
from learnblock.server.sessions.coach import Coach
from learnblock.server.sessions.offered_code import offer
from learnblock.server.sessions.part import Part
from learnblock.server.sessions.parts import Parts
from learnblock.server.sessions.periods import Periods
from learnblock.server.sessions.prepared import Prepared, prepare
from learnblock.server.sessions.project_robots import ProjectRobots
from learnblock.server.sessions.run_proof import RunProof
from learnblock.server.sessions.runs import Runs


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
        self.keyboard = SharedKeyboard(self.viewers)
        self.robots = ProjectRobots(self, prepared)
        self._saved = self.project
        self.archive = Archive(folder, self, periods)
        self.proof = RunProof(self)
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
    def parts(self) -> Parts:
        """Its programs with their robots."""
        return self.robots.parts

    @property
    def world(self) -> str:
        """The name of its world."""
        return self.robots.world

    @property
    def variant(self) -> int:
        """The number of the world's variant."""
        return self.robots.variant

    @property
    def is_running(self) -> bool:
        """Whether its programs run, or are checked on all variants and robots of a lesson."""
        return self.runs.active or (self.coach is not None and self.coach.checking)

    async def close(self) -> None:
        """End the running programs, and save."""
        await self.runs.stop()
        if self.coach:
            await self.coach.close()
        await self.robots.end()
        await self.archive.close()

    async def rename(self, name: str) -> None:
        """Rename the project, and tell every page.

        Raises:
            LearnBlockError: the name is taken, or the file can't be renamed.
        """
        await self.archive.rename(name)
        self.robots.name_single()
        self.viewers.send(messages.ProjectRenamed(name))

    async def begin_lesson(self, opened: OpenLesson, browser: str) -> None:
        """Follow a lesson from its first step, in the browser with this id."""
        progress = Progress(opened.name, browser=browser)
        self.coach = Coach(self, opened, progress, self._folder.lesson)
        await self.coach.begin()

    async def resume_lesson(self) -> None:
        """Continue the lesson that the project follows, if there is one."""
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

    async def follow_link(self, shared: SharedProject) -> None:
        """Compare the runs from now on with the one in the link that the project comes from."""
        await self._choose_variant(shared.variant)
        record = SharedRecord(self.proof.state, shared.run)
        await to_thread.run_sync(self._folder.keep_shared, self.name, record)
        self.proof.record = record
        self._notes = (
            *self._notes,
            Phrase("share-opened" if shared.run else "share-opened-no-run"),
        )

    async def resume_link(self) -> None:
        """Compare the runs with the one in the link that the project came from, if it did."""
        record = await to_thread.run_sync(self._folder.shared, self.name)
        if record:
            await self._choose_variant(record.state.variant)
        self.proof.record = record

    async def _choose_variant(self, variant: int) -> None:
        if variant == self.variant:
            return
        try:
            await self.robots.choose_world(self.world, variant)
        except LearnBlockError as error:
            self._remarks = (*self._remarks, error.phrase)

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
        # Pages that come later have not seen anything change.
        self._notes = ()
        if self.offered:
            page.send(offer(self.offered))

    def leave(self, page: Viewer) -> None:
        """Stop sending messages to a page."""
        self.viewers.remove(page)
        self.keyboard.leave(page)
        self.parts.shown_to(page).leave(page)

    def part_changed(self) -> None:
        """Save the project, and show the pages what has changed on a tab."""
        self.show_tabs()
        self.archive.changed()

    def show_tabs(self) -> None:
        """Show the pages what has changed on a tab."""
        self.parts.show_tabs()

    # The programs.

    async def restore(self, earlier: Project) -> None:
        """Restore earlier programs, with the current world; robots added since then stay."""
        self.runs.require_rest()
        await self.archive.keep_version("restored")
        prepared = await to_thread.run_sync(prepare, earlier)
        await self.robots.restore(prepared)

    async def know(self, configurations: Mapping[str, BlockConfiguration]) -> None:
        """Read the programs with a changed set of skills."""
        self.libraries = await to_thread.run_sync(self.libraries.renewed)
        for part in self.parts:
            await part.know(configurations)

    async def keep_lost(
        self, part: Part, lost: Document, pages: Iterable[Viewer], by: Literal["page", "before"]
    ) -> None:
        """Save a version with a change that the program of a part lacks, and report it."""
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

    async def _take_in_robots(self, outside: Project, opened: Prepared) -> bool:
        """Add and close robots as another program has done; return whether that is impossible."""
        before = {part.name for part in self._saved.parts}
        after = {part.name for part in outside.parts}
        if before == after or len(before) == len(after) == 1:
            return False
        try:
            for prepared in opened.parts:
                if self.parts.named(prepared.name) is None and prepared.name not in before:
                    await self.robots.append(prepared)
            for name in before - after:
                if self.parts.named(name):
                    await self.robots.close(name)
        except LearnBlockError as error:
            self.failed(error.phrase)
            return True
        return False

    async def _take_in_settings(self, saved: Project, outside: Project, opened: Prepared) -> None:
        """Choose what another program has chosen, unless a running program forbids it."""
        before = {part.name: part for part in saved.parts}
        try:
            for there, prepared in zip(outside.parts, opened.parts, strict=True):
                part, last = self.parts.like(prepared, len(outside.parts)), before.get(there.name)
                if part and last and there.robot != last.robot:
                    await self.robots.choose(part, prepared.robot.name)
                if part and last and there.count != last.count:
                    await self.robots.set_count(part, prepared.count)
                if part and last and there.breakpoints != last.breakpoints:
                    self.robots.set_breakpoints(part, prepared.breakpoints)
            if outside.world != saved.world:
                await self.robots.choose_world(opened.world)
        except LearnBlockError as error:
            self.failed(error.phrase)
        if (outside.shown, outside.block_sets) != (saved.shown, saved.block_sets):
            self.shown_blocks = opened.shown_blocks
            self.viewers.send(self.shown_blocks.message())

    def runs_kept(self, runs: tuple[KeptRun, ...]) -> None:
        """Send every page the kept runs."""
        self.viewers.send(messages.KeptRuns(runs))

    def remark(self, problem: Phrase) -> None:
        """Tell every page of a problem, also those that join later."""
        self._remarks = (*self._remarks, problem)
        self.failed(problem)

    def failed(self, message: Phrase) -> None:
        """Report an error to every page."""
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
