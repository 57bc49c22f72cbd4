"""A project that is open, shared by every page that shows it."""

import asyncio
from collections.abc import Callable, Mapping
from time import time
from typing import TYPE_CHECKING

from anyio import to_thread

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.block_sets import BlockSet
from learnblock.errors import LearnBlockError
from learnblock.server import catalog, messages
from learnblock.server.pages import tags
from learnblock.server.pages.sentences import sentence
from learnblock.server.program.document import Document
from learnblock.server.program.edits import Edits
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.projects.project_file import Project
from learnblock.server.runs.player import Player
from learnblock.server.runs.trial import Trial
from learnblock.server.sessions.archive import Archive
from learnblock.server.sessions.prepared import Prepared, loaded, prepare, settled

if TYPE_CHECKING:
    from learnblock.server.pages.page import Page


class Session:
    """A project that is open.

    Its methods are the event loop's; whoever changes the project holds `turn`.

    Args:
        folder: where it is saved.
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
        self.archive = Archive(folder, lambda: self.project, self._saving, self._failed)
        self._pages: list[Page] = []
        self._remarks = prepared.remarks
        self._last_run = (0.0, "")
        self.player = Player(self)

    @property
    def document(self) -> Document:
        """The program as it is now."""
        return self.edits.document

    @property
    def project(self) -> Project:
        """What is saved."""
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
        """End the program that runs, and save."""
        await self.player.close()
        await self.archive.close()

    async def set_the_stage(self) -> None:
        """Put the robot into its world, before the first page comes."""
        try:
            await self.player.set_the_stage(self.robot, self.world)
        except LearnBlockError as error:
            # Whoever sees what is wrong can choose another world, or mend this one.
            self._remarks = (*self._remarks, sentence(error))

    # Pages.

    @property
    def pages(self) -> tuple["Page", ...]:
        """Those that show it."""
        return tuple(self._pages)

    def join(self, page: "Page") -> None:
        """Tell a page everything, from now on."""
        self._pages.append(page)
        page.tell(messages.Opened(self.name, self.robot.name, self.world, self.breakpoints))
        page.tell(self.shown_blocks.told())
        page.tell(tags.present())
        page.tell(page.shown.update(self.edits))
        for remark in self._remarks:
            page.tell(messages.Failed(remark))
        self.player.join(page)

    def leave(self, page: "Page") -> None:
        """Tell a page nothing any more."""
        self._pages.remove(page)
        self.player.watch()

    def tell(self, message: messages.Message) -> None:
        """Tell every page."""
        for page in self._pages:
            page.tell(message)

    # The program.

    async def change(self, edit: Callable[[Document], Document]) -> None:
        """Change the program, and tell every page what it does not show yet.

        Raises:
            LearnBlockError: it cannot be changed so; nothing has changed.
        """
        before = self.document
        await self._think(lambda: self.edits.push(settled(edit(before))))

    async def undo(self) -> None:
        """Take the last edit back, if there is one."""
        await self._think(self.edits.undo)

    async def redo(self) -> None:
        """Make the last edit that was taken back again, if there is one."""
        await self._think(self.edits.redo)

    async def restore(self, earlier: Project) -> None:
        """Go back to an earlier program, on the robot and in the world of now."""
        await self.archive.keep_version("restored")
        module, devices = self.robot.module, self.robot.load().known_devices()
        await self.change(lambda _: prepare(earlier).document.with_robot(module, devices))

    async def know(self, configurations: Mapping[str, BlockConfiguration]) -> None:
        """Other skills are there than before."""
        before = self.document
        self.libraries = await to_thread.run_sync(self.libraries.renewed)
        await self._think(lambda: self.edits.replace(before.with_configurations(configurations)))

    # Settings.

    async def choose_robot(self, name: str) -> None:
        """Another robot, in the same world.

        Raises:
            LearnBlockError: there is none of that name, or a program runs.
        """
        robot = await to_thread.run_sync(loaded, name)
        await self.player.set_the_stage(robot, self.world)
        self.robot = robot
        devices = robot.load().known_devices()
        await self._think(
            lambda: self.edits.replace(self.document.with_robot(robot.module, devices))
        )
        self._tell_settings()

    async def choose_world(self, name: str) -> None:
        """Another world.

        Raises:
            LearnBlockError: there is none of that name, or a program runs.
        """
        await to_thread.run_sync(catalog.check_world_name, name)
        await self.player.set_the_stage(self.robot, name)
        self.world = name
        self._tell_settings()

    def set_breakpoints(self, blocks: tuple[str, ...]) -> None:
        """Hold the program before these blocks."""
        self.breakpoints = blocks
        self.player.set_breakpoints(blocks)
        self._tell_settings()

    def show_blocks(self, block_set: BlockSet) -> None:
        """Have the palette show the blocks of a set.

        Raises:
            BlockSetError: it has no name that it can be found by.
        """
        self.shown_blocks = self.shown_blocks.choosing(block_set)
        self.tell(self.shown_blocks.told())
        self.archive.changed()

    # Running.

    async def run(self, *, paused: bool) -> None:
        """Run the program from the beginning; a version of it is kept.

        Raises:
            LearnBlockError: it has errors.
        """
        self.player.require_no_errors()
        await self.player.stop()
        self._last_run = (time(), await self.archive.keep_version("run"))
        await self.player.run(self.document, paused=paused)

    async def try_out(self, trial: Trial) -> None:
        """Run a function by itself, in place of the program."""
        await self.player.stop()
        await self.player.run(trial, paused=False)

    def ran(self, ended: messages.Ended) -> None:
        """A run is over."""
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

    # Within.

    async def _think(self, change: Callable[[], None]) -> None:
        """Change the program in a thread, as that takes its time, and tell what has changed."""

        def think() -> None:
            change()
            settled(self.document)

        await to_thread.run_sync(think)
        for page in self._pages:
            page.tell(page.shown.update(self.edits))
        self.archive.changed()

    def _tell_settings(self) -> None:
        self.tell(messages.Settings(self.robot.name, self.world, self.breakpoints))
        self.archive.changed()

    def _saving(self) -> Callable[[], None]:
        """What is being saved is what each page has sent until now."""
        edits = [(page, page.shown.edit) for page in self._pages]

        def saved() -> None:
            for page, edit in edits:
                page.tell(messages.Saved(edit))

        return saved

    def _failed(self, message: str) -> None:
        self.tell(messages.Failed(message))
