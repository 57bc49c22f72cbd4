"""The run that pages look back at."""

from collections.abc import Iterator

from learnblock.errors import LearnBlockError
from learnblock.server import messages
from learnblock.server.runs.console import Console, message_of
from learnblock.server.runs.kept import OpenedRun
from learnblock.server.runs.looking import Looking
from learnblock.server.runs.viewers import Viewers


class ShownRun:
    """The newest run of a robot, or a kept one that pages look back at instead.

    Args:
        viewers: the pages that show the robot.
        console: the output of the newest run.
    """

    def __init__(self, viewers: Viewers, console: Console) -> None:
        self._viewers = viewers
        self._console = console
        #: The world of the robot; None before it is in one.
        self._scene: messages.Scene | None = None
        #: Looks back at this run or the last one; None before the first, and if no log is kept.
        self.newest: Looking | None = None
        self._kept: OpenedRun | None = None

    @property
    def looking(self) -> Looking | None:
        """Looks back at the kept run that is shown, or at the newest one; None if there is none."""
        return self._kept.looking if self._kept else self.newest

    def require_looking(self) -> Looking:
        """What looks back at the run that is shown.

        Raises:
            LearnBlockError: there is none.
        """
        looking = self.looking
        if looking is None:
            raise LearnBlockError("play-nothing-to-look-back-at")
        return looking

    @property
    def scene(self) -> messages.Scene | None:
        """The world in which pages see it; None before there is one."""
        return (self._kept and self._kept.scene) or self._scene

    @property
    def kept(self) -> messages.RunShown | None:
        """What pages say about the kept run; None if the newest one is shown."""
        return self._kept.shown if self._kept else None

    def enter(self, scene: messages.Scene) -> None:
        """Show the robot in a world."""
        self.show_newest()
        self._scene = scene
        self._viewers.send(scene)

    def show_kept(self, run: OpenedRun) -> None:
        """Let pages look back at a kept run."""
        self._kept = run
        self._viewers.send(run.shown)
        if self.scene:
            self._viewers.send(self.scene)

    def show_newest(self) -> None:
        """Let pages look back at the newest run again."""
        if self._kept is None:
            return
        self._kept = None
        for message in self._of_newest():
            self._viewers.send(message)

    def _of_newest(self) -> Iterator[messages.ToPage]:
        yield messages.RunShown()
        if printed := message_of(self._console.kept):
            yield printed
        if self._scene:
            yield self._scene
