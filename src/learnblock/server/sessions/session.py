"""An open project, shared by every page that shows it."""

import asyncio
from collections.abc import Callable, Mapping
from time import time

from anyio import to_thread

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.block_sets import BlockSet
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server import catalog, messages
from learnblock.server.program.document import Document
from learnblock.server.program.edits import Edits
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.projects.project_file import Project
from learnblock.server.runs.player import Player
from learnblock.server.runs.playing import Played, Setting
from learnblock.server.runs.trial import Trial
from learnblock.server.runs.viewers import Viewer, Viewers
from learnblock.server.sessions.archive import Archive
from learnblock.server.sessions.prepared import Prepared, loaded, prepare, settled


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
        self.edits = Edits(prepared.document)
        self.turn = asyncio.Lock()
        self.archive = Archive(
            folder, prepared.name, lambda: self.project, self._saving, self._failed
        )
        self.viewers = Viewers()
        self._remarks = prepared.remarks
        self._last_run = (0.0, "")
        self.player = Player(self.viewers, self._keep_run)

    @property
    def document(self) -> Document:
        """The current program."""
        return self.edits.document

    @property
    def project(self) -> Project:
        """The project in the form that is saved."""
        return Project(
            name=self.name,
            blocktext=self.document.blocktext,
            python=self.document.python_by_hand,
            workspace=self.document.workspace,
            robot=self.robot.name,
            world=self.world,
            breakpoints=self.breakpoints,
            shown=self.shown_blocks.name,
            block_sets=self.shown_blocks.carried,
            libraries=self.libraries.used(self.document.good.tree),
        )

    async def close(self) -> None:
        """End the running program, and save."""
        await self.player.close()
        await self.archive.close()

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
        page.send(messages.Opened(self.name, self.robot.name, self.world, self.breakpoints))
        page.send(self.shown_blocks.message())
        page.send(catalog.tag_dictionary())
        page.send(page.shown.update(self.edits))
        for remark in self._remarks:
            page.send(messages.Failed(remark))
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
        before = self.document
        await self._think(lambda: self.edits.push(settled(edit(before))))

    async def undo(self) -> None:
        """Undo the last edit, if there is one."""
        await self._think(self.edits.undo)

    async def redo(self) -> None:
        """Redo the last undone edit, if there is one."""
        await self._think(self.edits.redo)

    async def restore(self, earlier: Project) -> None:
        """Restore an earlier program, with the current robot and world."""
        await self.archive.keep_version("restored")
        module, devices = self.robot.module, self.robot.load().known_devices()
        await self.change(lambda _: prepare(earlier).document.with_robot(module, devices))

    async def know(self, configurations: Mapping[str, BlockConfiguration]) -> None:
        """Read the program with a changed set of skills."""
        before = self.document
        self.libraries = await to_thread.run_sync(self.libraries.renewed)
        await self._think(lambda: self.edits.replace(before.with_configurations(configurations)))

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
            lambda: self.edits.replace(self.document.with_robot(robot.module, devices))
        )
        self._send_settings()

    async def choose_world(self, name: str) -> None:
        """Change the world.

        Raises:
            LearnBlockError: the world does not exist, or a program is running.
        """
        await to_thread.run_sync(catalog.check_world_name, name)
        await self.player.set_the_stage(self.robot, name)
        self.world = name
        self._send_settings()

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
        setting = Setting(self.name, self.robot, self.world, self.player.start, self.breakpoints)
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

    async def _think(self, change: Callable[[], None]) -> None:
        """Change the program in a thread, because this is slow, and send the changes."""

        def think() -> None:
            change()
            settled(self.document)

        await to_thread.run_sync(think)
        for page in self.viewers:
            page.send(page.shown.update(self.edits))
        self.archive.changed()

    def _send_settings(self) -> None:
        self.viewers.send(messages.Settings(self.robot.name, self.world, self.breakpoints))
        self.archive.changed()

    def _saving(self) -> Callable[[], None]:
        """Record the last edit of each page, to confirm it once it is saved."""
        edits = [(page, page.shown.edit) for page in self.viewers]

        def saved() -> None:
            for page, edit in edits:
                page.send(messages.Saved(edit))

        return saved

    def _failed(self, message: Phrase) -> None:
        self.viewers.send(messages.Failed(message))
