"""One of the programs of an open project, with the robots that run it."""

import asyncio
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Literal, Protocol, TypeVar

from anyio import to_thread

from learnblock.blocks import BlockConfiguration
from learnblock.project.document.document import Document
from learnblock.project.document.shared import Content, Edit, Merged, SharedProgram, base_of
from learnblock.project.document.views import View
from learnblock.project.files.project import ProjectPart
from learnblock.robots import RobotEntry
from learnblock.server import messages
from learnblock.server.runs.console import Console
from learnblock.server.runs.guest_program import GuestProgram
from learnblock.server.runs.keyboard import SharedKeyboard
from learnblock.server.runs.player import Player
from learnblock.server.runs.viewers import Viewer, Viewers
from learnblock.server.sessions.prepared import PreparedPart, guest_program

Result = TypeVar("Result")
#: The states of programs, those that need attention most first.
_STATES: tuple[messages.StateName, ...] = (
    "held",
    "paused",
    "input",
    "running",
    "starting",
    "done",
    "ended",
    "idle",
)


class PartHome(Protocol):
    """The project that a part belongs to."""

    @property
    def keyboard(self) -> SharedKeyboard:
        """The keyboard of the project."""

    def part_changed(self) -> None:
        """Save the project, and show the pages what has changed on a tab."""

    def part_ended(self, ended: messages.Ended) -> None:
        """Record how the program of a part ended."""

    def show_tabs(self) -> None:
        """Show the pages what has changed on a tab."""

    async def keep_lost(
        self, part: "Part", lost: Document, pages: Iterable[Viewer], by: Literal["page", "before"]
    ) -> None:
        """Save a version with a change that the program of a part lacks, and say so."""


class Part:
    """A program of an open project, with the robots that run it; a page shows one of them.

    Its methods run in the event loop; a caller that changes it must hold the project's `turn`.

    Args:
        prepared: the program and the kind of robot.
        home: the project.
    """

    def __init__(self, prepared: PreparedPart, home: PartHome) -> None:
        self.name = prepared.name
        self.robot = prepared.robot
        self.breakpoints = prepared.breakpoints
        self.program = SharedProgram(prepared.document)
        #: The pages that show this part.
        self.viewers = Viewers()
        self._home = home
        self._console = Console()
        #: The page of a guest with the program that runs instead of the part's own.
        self._guest: tuple[Viewer, GuestProgram] | None = None
        #: The robots that run the program, at least one.
        self.players = tuple(self._new_player() for _ in range(prepared.count))
        #: The program changes in one thread at a time.
        self._thinking = asyncio.Lock()

    @property
    def document(self) -> Document:
        """The current program."""
        return self.program.document

    @property
    def played(self) -> Document | GuestProgram:
        """What its robots run."""
        return self._guest[1] if self._guest else self.document

    @property
    def has_guest(self) -> bool:
        """Whether its robots run a guest's program."""
        return self._guest is not None

    @property
    def tab(self) -> messages.Tab:
        """Its tab in the page."""
        robots = tuple(
            messages.TabRobot(player.voice.robot, player.state, player.has_failed)
            for player in self.players
        )
        return messages.Tab(
            self.name,
            self.robot.name,
            min((robot.state for robot in robots), key=_STATES.index),
            failed=any(robot.failed for robot in robots),
            mistakes=self.document.first_error is not None,
            robots=robots if len(robots) > 1 else (),
        )

    def player_of(self, page: Viewer) -> Player:
        """The robot that a page shows."""
        return next(player for player in self.players if page in player.viewers)

    def name_of(self, player: Player) -> str:
        """The name of one of its robots in the world."""
        return player.voice.robot or self.name

    def player_named(self, name: str) -> Player:
        """The robot with this name; the first if there is none."""
        return next(
            (player for player in self.players if player.voice.robot == name), self.players[0]
        )

    def set_count(self, count: int) -> tuple[Player, ...]:
        """Let another number of robots run the program; return those that are left over.

        Pages must not show them any more, and they must be closed.
        """
        more = [self._new_player() for _ in range(count - len(self.players))]
        left = self.players[count:]
        self.players = (*self.players[:count], *more)
        return left

    def forget_run(self) -> None:
        """Forget the last run, which was one of other robots or in another world."""
        self._console.clear()
        for player in self.players:
            player.forget()

    def name_robots(self, names: Sequence[str]) -> None:
        """Give the robots their names in the world."""
        several = len(self.players) > 1
        for player, name in zip(self.players, names, strict=True):
            player.voice.robot = name if several else ""

    async def close(self) -> None:
        """Stop the programs and the robots."""
        for player in self.players:
            await player.close()

    def saved_with(self, document: Document) -> ProjectPart:
        """The part in the form that is saved, with a program."""
        return ProjectPart(
            name=self.name,
            blocktext=document.blocktext,
            python=document.python_by_hand,
            workspace=document.workspace,
            robot=self.robot.name,
            breakpoints=self.breakpoints,
            count=len(self.players),
        )

    # Pages.

    def join(self, page: Viewer, player: Player) -> None:
        """Send a page the program and the run of a robot, and all changes from now on."""
        page.send(page.shown.update(self.program))
        player.join(page)
        # Only now, because it has just received what has been printed so far.
        self.viewers.add(page)

    def leave(self, page: Viewer) -> None:
        """Stop sending messages to a page."""
        self.player_of(page).leave(page)
        self.viewers.remove(page)
        if self._guest and self._guest[0] is page:
            self._guest = None

    async def take_guest(self, page: Viewer, text: str, *, is_python: bool) -> None:
        """Run a guest's program instead of the part's own until the guest's page leaves.

        Args:
            page: the guest's.
            text: the program, in Block-Text or Python.
            is_python: whether it is Python.

        Raises:
            LearnBlockError: it can't run on the robot.
        """
        program = await to_thread.run_sync(guest_program, self.robot, text, is_python)
        # The guest may have left meanwhile.
        if page in tuple(self.viewers):
            self._guest = page, program

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
            base = page.shown.base(view, revision or revisions.number, revisions)
            merged = self.program.merge(Edit(view, content, base), page.shown)
            page.shown.edited(number, view, content, merged.left)
            return merged

        merged = await self._think(merge)
        if merged.lost:
            await self._home.keep_lost(self, merged.lost, self.viewers, "page")

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
            page.shown.repeated(number, view, merged.left)
            return merged

        merged = await self._think(merge)
        if merged.lost:
            await self._home.keep_lost(self, merged.lost, [page], "before")

    async def undo(self) -> None:
        """Undo the last edit, if there is one."""
        await self._think(self.program.undo)

    async def redo(self) -> None:
        """Redo the last undone edit, if there is one."""
        await self._think(self.program.redo)

    async def restore(self, earlier: Document) -> None:
        """Restore an earlier program, for the current robot."""
        await self.change(lambda _: self._for_robot(earlier))

    async def know(self, configurations: Mapping[str, BlockConfiguration]) -> None:
        """Read the program with a changed set of skills."""
        await self._think(
            lambda: self.program.replace(lambda now: now.with_configurations(configurations))
        )

    async def use(self, robot: RobotEntry) -> None:
        """Write the program for another kind of robot."""
        self.robot = robot
        await self._think(lambda: self.program.replace(self._for_robot))

    # The file.

    async def take_in(self, outside: ProjectPart, read: Document) -> bool:
        """Merge the program as another program has saved it; what was changed here wins.

        Args:
            outside: the part in the file.
            read: its program.

        Returns:
            Whether the program lacks a change of the other program.
        """
        document = self._for_robot(read)
        view: View = "blocktext" if outside.python is None else "python"
        text = document.text_of(view)

        def merge() -> bool:
            revisions = self.program.revisions
            base = revisions.edited(view, text)
            if revisions.number == base:
                self.program.change(lambda _: document)
                return False
            edit = Edit(view, text, revisions.text(base, view), wins=False)
            return self.program.merge(edit).lost is not None

        return await self._think(merge)

    # Helpers.

    def _new_player(self) -> Player:
        home = self._home
        return Player(self._console, self.viewers, home.keyboard, home.part_ended, home.show_tabs)

    def _for_robot(self, document: Document) -> Document:
        kind = self.robot.load()
        return document.with_robot(self.robot.module, kind.known_equipment(), kind.drivetrain())

    async def _think(self, change: Callable[[], Result]) -> Result:
        """Change the program in a thread, because this is slow, and send the changes."""
        async with self._thinking:
            result = await to_thread.run_sync(change)
        for page in self.viewers:
            page.send(page.shown.update(self.program))
        self._home.part_changed()
        return result
