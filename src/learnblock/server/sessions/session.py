"""An open project, shared by every page that shows it."""

import asyncio
from collections.abc import Callable, Iterable, Mapping
from time import time
from typing import Literal, TypeVar

from anyio import to_thread

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.block_sets import BlockSet
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.running import may_use_network
from learnblock.server import catalog, messages
from learnblock.server.messages import View
from learnblock.server.program.document import Document
from learnblock.server.program.merging import Content, Edit, Merged, base_of
from learnblock.server.program.shared import SharedProgram
from learnblock.server.projects.carried import Carried, Code
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.projects.offering import offer, without
from learnblock.server.projects.project_file import Project
from learnblock.server.runs.player import Player
from learnblock.server.runs.playing import Played, Setting
from learnblock.server.runs.trial import Trial
from learnblock.server.runs.viewers import Viewer, Viewers
from learnblock.server.sessions.archive import Archive
from learnblock.server.sessions.prepared import DEFAULT_WORLD, Prepared, loaded, prepare
from learnblock.server.sessions.saves import Saved, Saves

Result = TypeVar("Result")


class Session:
    """An open project.

    Its methods run in the event loop; a caller that changes the project must hold `turn`.

    Args:
        folder: the folder to save it in.
        prepared: the project.
    """

    def __init__(self, folder: ProjectFolder, prepared: Prepared) -> None:
        self.name = prepared.name
        self.robot = prepared.robot
        self.world = prepared.world
        self.breakpoints = prepared.breakpoints
        self.shown_blocks = prepared.shown_blocks
        self.libraries = prepared.libraries
        self.tags = prepared.tags
        self.offered = prepared.offered
        self.program = SharedProgram(prepared.document)
        self.turn = asyncio.Lock()
        #: The program changes in one thread at a time.
        self._thinking = asyncio.Lock()
        self._folder = folder
        self.archive = Archive(folder, self)
        self._saves = Saves(self._save())
        self.viewers = Viewers()
        self._remarks = prepared.remarks
        self._notes = prepared.notes
        self._new_worlds = prepared.worlds
        self._last_run = (0.0, "")
        self._network = False
        self.player = Player(self.viewers, self._keep_run)

    @property
    def document(self) -> Document:
        """The current program."""
        return self.program.document

    @property
    def project(self) -> Project:
        """The project in the form that is saved."""
        return self._project_with(self.document)

    def _project_with(self, document: Document) -> Project:
        return Project(
            name=self.name,
            blocktext=document.blocktext,
            python=document.python_by_hand,
            workspace=document.workspace,
            robot=self.robot.name,
            world=self.world,
            breakpoints=self.breakpoints,
            shown=self.shown_blocks.name,
            block_sets=self.shown_blocks.carried,
            libraries=self.libraries.used(document.good.tree),
            tags=self.tags,
            carried=Carried(offered=self.offered),
        )

    async def close(self) -> None:
        """End the running program, and save."""
        await self.player.close()
        await self.archive.close()

    async def rename(self, name: str) -> None:
        """Rename the project, and tell every page.

        Raises:
            LearnBlockError: the name is taken, or the file can't be renamed.
        """
        await self.archive.rename(name)
        self.viewers.send(messages.ProjectRenamed(name))

    async def set_the_stage(self) -> None:
        """Put the robot into its world before the first page joins."""
        try:
            await self.player.set_the_stage(self.robot, self.world)
        except LearnBlockError as error:
            # The pages show the problem, and the user can choose another world.
            self._remarks = (*self._remarks, error.phrase)

    # Pages.

    def join(self, page: Viewer) -> None:
        """Send a page the whole project, and all changes from now on."""
        self.viewers.add(page)
        if self._new_worlds:
            page.send(messages.Worlds(self._new_worlds))
            self._new_worlds = ()
        page.send(messages.Opened(self.name, self.robot.name, self.world, self.breakpoints))
        page.send(self.shown_blocks.message())
        page.send(catalog.tag_dictionary())
        page.send(self.program.update(page.shown))
        for remark in self._remarks:
            page.send(messages.Failed(remark))
        for note in self._notes:
            page.send(messages.Noted(note))
        # Those who come later have not seen anything change.
        self._notes = ()
        if self.offered:
            page.send(offer(self.offered))
        self.player.join(page)

    def leave(self, page: Viewer) -> None:
        """Stop sending messages to a page."""
        self.viewers.remove(page)
        self.player.watch()

    # The program.

    async def change(self, edit: Callable[[Document], Document]) -> None:
        """Change the program, and send every page what it doesn't show yet.

        Raises:
            LearnBlockError: the edit is impossible; nothing has changed.
        """
        await self._think(lambda: self.program.change(edit))

    async def edit(
        self, page: Viewer, number: int, revision: int, view: View, content: Content
    ) -> None:
        """Merge an edit of a page, which wins where others have changed the same line since.

        Args:
            page: the page.
            number: the number of its edit.
            revision: the revision that it shows, apart from its own edits; 0 for the current one.
            view: the edited view.
            content: the view after the edit.
        """

        def merge() -> Merged:
            revisions = self.program.revisions
            base = page.shown.base(view, revision or revisions.last.number, revisions)
            merged = self.program.merge(Edit(view, content, base), page.shown)
            page.shown.edited(number, view, content)
            return merged

        merged = await self._think(merge)
        if merged.lost:
            await self._keep(merged.lost, self.viewers, "page")

    async def recover(
        self, page: Viewer, number: int, view: View, content: Content, base: Content
    ) -> None:
        """Merge an edit that a page had made before its connection was lost.

        What others have changed since wins.

        Args:
            page: the page.
            number: the number of its edit.
            view: the edited view.
            content: the view after the edit.
            base: the view before the edit.
        """

        def merge() -> Merged:
            edit = Edit(view, content, base_of(self.document, base), wins=False)
            merged = self.program.merge(edit, page.shown)
            page.shown.repeated(number, view)
            return merged

        merged = await self._think(merge)
        if merged.lost:
            await self._keep(merged.lost, [page], "before")

    async def undo(self) -> None:
        """Undo the last edit, if there is one."""
        await self._think(self.program.undo)

    async def redo(self) -> None:
        """Redo the last undone edit, if there is one."""
        await self._think(self.program.redo)

    async def restore(self, earlier: Project) -> None:
        """Restore an earlier program, with the current robot and world."""
        await self.archive.keep_version("restored")
        module, devices = self.robot.module, self.robot.load().known_devices()
        await self.change(lambda _: prepare(earlier).document.with_robot(module, devices))

    async def know(self, configurations: Mapping[str, BlockConfiguration]) -> None:
        """Read the program with a changed set of skills."""
        self.libraries = await to_thread.run_sync(self.libraries.renewed)
        await self._think(
            lambda: self.program.replace(lambda now: now.with_configurations(configurations))
        )

    # The file.

    def saving(self) -> tuple[Project, Callable[[], None]]:
        """Return the project, and what confirms the last edit of each page once it is saved."""
        edits = [(page, page.shown.edit) for page in self.viewers]
        save = self._save()

        def saved() -> None:
            self._saves.add(save)
            for page, edit in edits:
                page.send(messages.Saved(edit))

        return save.project, saved

    async def take_in(self, outside: Project) -> bool:
        """Merge the project as another program has saved it; what was changed here wins.

        Returns:
            Whether the project lacks a change of the other program.
        """
        await self.archive.keep_version("time")
        read_only = self._folder.read_only
        prepared = await to_thread.run_sync(lambda: prepare(outside, read_only=read_only))
        await self._take_in_settings(self._saves.last.project, outside, prepared)
        devices = self.robot.load().known_devices()
        document = prepared.document.with_robot(self.robot.module, devices)
        view: View = "blocktext" if outside.python is None else "python"
        base = self._saves.edited(view, document.text_of(view)).revision
        edit = Edit(view, document.text_of(view), base.text(view), wins=False)

        def merge() -> bool:
            if self.program.revisions.last == base:
                self.program.change(lambda _: document)
                return False
            return self.program.merge(edit).lost is not None

        is_lost = await self._think(merge)
        if not is_lost:
            self.viewers.send(messages.TakenIn())
        return is_lost

    def kept_outside(self, version: str) -> None:
        """Tell every page which version has another program's change that could not be merged."""
        self.viewers.send(messages.Conflict(version, "file"))

    async def _take_in_settings(self, saved: Project, outside: Project, found: Prepared) -> None:
        """Choose what another program has chosen, unless the running program forbids it."""
        try:
            if outside.robot != saved.robot:
                await self.choose_robot(found.robot.name)
            if outside.world != saved.world:
                await self.choose_world(found.world)
        except LearnBlockError as error:
            self.failed(error.phrase)
        if outside.breakpoints != saved.breakpoints:
            self.set_breakpoints(found.breakpoints)
        if (outside.shown, outside.block_sets) != (saved.shown, saved.block_sets):
            self.shown_blocks = found.shown_blocks
            self.viewers.send(self.shown_blocks.message())

    def _save(self) -> Saved:
        return Saved(self.project, self.program.revisions.last)

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

    async def choose_robot(self, name: str) -> None:
        """Change the robot, in the same world.

        Raises:
            LearnBlockError: the robot does not exist, or a program is running.
        """
        robot = await to_thread.run_sync(loaded, name)
        await self.player.set_the_stage(robot, self.world)
        self.robot = robot
        devices = robot.load().known_devices()
        await self._think(
            lambda: self.program.replace(lambda now: now.with_robot(robot.module, devices))
        )
        self._send_settings()

    async def choose_world(self, name: str) -> None:
        """Change the world.

        Raises:
            LearnBlockError: the world does not exist, or a program is running.
        """
        await to_thread.run_sync(catalog.check_world_name, name)
        await self.player.set_the_stage(self.robot, name)
        if name != self.world:
            self.player.forget()
        self.world = name
        self._send_settings()

    async def leave_world(self, name: str) -> None:
        """Choose the robot's usual world if the current one is this one.

        Raises:
            LearnBlockError: a program is running.
        """
        if self.world != name:
            return
        usual = await to_thread.run_sync(catalog.usual_world, self.robot)
        await self.choose_world(DEFAULT_WORLD if usual in (None, name) else usual)

    def set_breakpoints(self, blocks: tuple[str, ...]) -> None:
        """Set the blocks before which the program pauses."""
        self.breakpoints = blocks
        self.player.set_breakpoints(blocks)
        self._send_settings()

    def show_blocks(self, block_set: BlockSet) -> None:
        """Show the blocks of a set in the palette.

        Raises:
            BlockSetError: the set has an unusable name.
        """
        self.shown_blocks = self.shown_blocks.choosing(block_set)
        self.viewers.send(self.shown_blocks.message())
        self.archive.changed()

    # Running.

    @property
    def uses_network(self) -> bool:
        """Whether a program is running that may use the network."""
        return self._network and self.player.active

    async def run(self, *, paused: bool) -> None:
        """Run the program from the start, and save a version of it.

        Raises:
            LearnBlockError: it has errors.
        """
        self.document.require_no_errors()
        await self.player.stop()
        self._last_run = (time(), await self.archive.keep_version("run"))
        await self._run(self.document, paused=paused)

    async def try_out(self, trial: Trial) -> None:
        """Run a single function instead of the program."""
        await self.player.stop()
        await self._run(trial, paused=False)

    async def reset_world(self) -> None:
        """Reset the world to its initial state."""
        await self.player.set_the_stage(self.robot, self.world)

    async def _run(self, played: Played, *, paused: bool) -> None:
        self._network = await to_thread.run_sync(may_use_network, self._folder.file(self.name))
        setting = Setting(
            self.name,
            self.robot,
            self.world,
            self.player.start,
            self.breakpoints,
            network=self._network,
            tags=self.tags,
        )
        await self.player.run(played, setting, paused=paused)

    def _keep_run(self, ended: messages.Ended) -> None:
        if ended.tried:
            return
        began, version = self._last_run
        self.archive.add_run(
            messages.PastRun(
                time=began,
                robot=self.robot.name,
                world=self.world,
                ended=ended.ended,
                seconds=ended.time,
                goals=tuple(goal.name for goal in ended.goals if goal.state == "reached"),
                trace_sha256=ended.trace_sha256,
                version=version,
            )
        )

    # Helpers.

    async def _keep(
        self, lost: Document, pages: Iterable[Viewer], by: Literal["page", "before"]
    ) -> None:
        """Save a version of the project with a change that the program lacks, and say so."""
        version = await self.archive.keep_version("conflict", self._project_with(lost))
        for page in pages:
            page.send(messages.Conflict(version, by))

    async def _think(self, change: Callable[[], Result]) -> Result:
        """Change the program in a thread, because this is slow, and send the changes."""
        async with self._thinking:
            result = await to_thread.run_sync(change)
        for page in self.viewers:
            page.send(self.program.update(page.shown))
        self.archive.changed()
        return result

    def _send_settings(self) -> None:
        self.viewers.send(messages.Settings(self.robot.name, self.world, self.breakpoints))
        self.archive.changed()
