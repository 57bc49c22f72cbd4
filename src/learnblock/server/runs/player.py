"""Runs the program of a project, and moves its robot while no program runs."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.running import Report
from learnblock.runtime.messages import Variables
from learnblock.runtime.status import State
from learnblock.server import messages
from learnblock.server.runs import telemetry
from learnblock.server.runs.console import Console
from learnblock.server.runs.playing import Played, Playing, Setting, prepared
from learnblock.server.runs.reporter import Reporter
from learnblock.server.runs.viewers import Viewer, Viewers

if TYPE_CHECKING:
    from learnblock.devices import Pose
    from learnblock.monitor import Monitor
    from learnblock.robots import RobotEntry

#: The states reported as such; a paused program is reported with its line, an ended one with its
#: report.
_STATES: dict[State, messages.StateName] = {
    State.STARTING: "starting",
    State.RUNNING: "running",
    State.PAUSED: "paused",
    State.INPUT: "input",
}
IDLE = messages.RunState("idle")
NOWHERE = messages.RunningLine(0)


class Player:
    """The robot of a project in its world, and the program that it runs.

    Args:
        viewers: the pages that show the project.
        on_run_ended: called after each run.
    """

    def __init__(self, viewers: Viewers, on_run_ended: Callable[[messages.Ended], object]) -> None:
        self.viewers = viewers
        self._on_run_ended = on_run_ended
        self._monitor: Monitor | None = None
        self._scene: messages.Scene | None = None
        self._playing: Playing | None = None
        self._state = IDLE
        self._speed: float | None = 1.0
        self._asked: messages.InputWanted | None = None
        self._variables: messages.Variables | None = None
        self._ended: messages.Ended | None = None
        self._console = Console()
        self._reporter = Reporter(self, self._console)

    # For the reporter.

    @property
    def monitor(self) -> "Monitor | None":
        """The monitor of the robot: the program's, once it has created its robot."""
        return (self._playing and self._playing.run.monitor) or self._monitor

    @property
    def active(self) -> bool:
        return self._playing is not None

    @property
    def running_line(self) -> messages.RunningLine:
        return self._playing.running_line if self._playing else NOWHERE

    # Pages.

    def join(self, page: Viewer) -> None:
        """Send a page what the other pages have received."""
        self._reporter.flush()
        printed = messages.Printed(self._console.kept) if self._console.kept else None
        known = (self._scene, self._state, printed, self._variables, self._asked, self._ended)
        for message in known:
            if message is not None:
                page.send(message)
        self._reporter.greet()

    def watch(self) -> None:
        """Send camera frames, or stop, after a page has started or stopped watching."""
        self._reporter.watch()

    # The robot in its world.

    async def set_the_stage(self, robot: "RobotEntry", world: str) -> None:
        """Put a robot into a world.

        Raises:
            LearnBlockError: there is no room for it, or a program runs.
        """
        self._require_rest()
        monitor = await to_thread.run_sync(_monitor, robot, world)
        await self._close_monitor()
        self._monitor = monitor
        self._scene = telemetry.scene(monitor)
        self.viewers.send(self._scene)
        self._reporter.greet()

    def forget(self) -> None:
        """Forget the result and the variables of the last run, which was in another world."""
        self._variables = self._ended = None
        self._enter("idle")

    def place(self, x: float, y: float, heading: float) -> None:
        """Place the robot; the next run starts there.

        Raises:
            LearnBlockError: the robot is moving, or it is a real robot.
        """
        if self._state.state not in {"idle", "ended", "paused", "held"}:
            raise LearnBlockError("play-robot-moves")
        self._require_monitor().place(x, y, heading)
        self._reporter.attend()

    def drive(self, advance: float, rotation: float) -> None:
        """Drive the robot by hand.

        Raises:
            LearnBlockError: a program runs, or the robot is a real one.
        """
        self._require_rest()
        self._require_monitor().drive(advance, rotation)
        self._reporter.attend()

    # The program.

    @property
    def start(self) -> "Pose | None":
        """The pose at which the user placed the robot; None if it was not placed."""
        return self._monitor.start if self._monitor else None

    async def run(self, played: Played, setting: Setting, *, paused: bool) -> None:
        """Run a program from the beginning."""
        playing = prepared(played, setting, self, self._console, paused=paused)
        playing.run.set_speed(self._speed)
        await self._close_monitor()
        self._begin(playing)

    async def stop(self) -> None:
        """Stop the program and the robot, and return once both have stopped."""
        playing = self._playing
        if playing:
            playing.run.stop()
            await playing.over.wait()

    def pause(self) -> None:
        if self._playing:
            self._playing.run.pause()

    def resume(self) -> None:
        if self._playing:
            self._playing.run.resume()

    def step(self, *, over: bool) -> None:
        if self._playing:
            (self._playing.run.step_over if over else self._playing.run.step)()

    def set_speed(self, factor: float | None) -> None:
        """Set the speed of this and later runs, as a multiple of real time; None is the fastest."""
        self._speed = factor
        if self._playing:
            self._playing.run.set_speed(factor)
        self._enter(self._state.state, self._state.block)

    def set_breakpoints(self, blocks: tuple[str, ...]) -> None:
        if self._playing:
            self._playing.set_breakpoints(blocks)

    def answer(self, text: str) -> None:
        """Send the program the line that it is waiting for.

        Raises:
            LearnBlockError: it is not waiting for one.
        """
        if not self._playing or not self._asked:
            raise LearnBlockError("play-no-question")
        self._asked = None
        self._playing.watcher.answer(text)

    async def close(self) -> None:
        """Stop the program, the robot and the reports."""
        await self.stop()
        await self._close_monitor()
        self._reporter.close()

    # Reports of the run.

    def on_state(self, state: State) -> None:
        if state in _STATES:
            self._enter(_STATES[state])

    def on_held(self, line: int) -> None:
        if self._playing:
            self._enter("held", self._playing.played.block_at(line))

    def on_variables(self, variables: Variables) -> None:
        whens = tuple(messages.WhenNow(name, *now) for name, now in variables.whens.items())
        shown = messages.Variables(variables.local, variables.shared, whens)
        if shown != self._variables:
            self._variables = shown
            self.viewers.send(shown)

    def on_input(self, prompt: str) -> None:
        self._reporter.flush()
        self._asked = messages.InputWanted(prompt)
        self.viewers.send(self._asked)

    def on_ended(self, report: Report | Exception) -> None:
        playing = self._playing
        assert playing is not None  # noqa: S101 - each run reports its end once
        self._monitor = playing.run.monitor or self._monitor
        self._playing = self._asked = None
        self._reporter.flush()
        self._reporter.attend()
        self._report_end(playing, report)
        playing.over.set()

    # Helpers.

    def _begin(self, playing: Playing) -> None:
        self._console.clear()
        self._variables = self._ended = None
        self._playing = playing
        self._enter("starting")
        self._reporter.attend()
        playing.start()

    def _enter(self, state: messages.StateName, block: str | None = None) -> None:
        self._reporter.flush()
        before, self._state = self._state, messages.RunState(state, block, self._speed)
        if self._state != before:
            self.viewers.send(self._state)

    def _report_end(self, playing: Playing, report: Report | Exception) -> None:
        if isinstance(report, Report):
            self._ended = playing.ended(report)
        else:
            phrase = Phrase("play-not-started", reason=str(report))
            self._ended = messages.Ended("error", phrase, tried=playing.is_trial)
        self.viewers.send(self._ended)
        self._enter("ended")
        self._on_run_ended(self._ended)

    def _require_rest(self) -> None:
        if self.active:
            raise LearnBlockError("play-program-running")

    def _require_monitor(self) -> "Monitor":
        if self.monitor is None:
            raise LearnBlockError("play-no-robot")
        return self.monitor

    async def _close_monitor(self) -> None:
        if self._monitor:
            # It waits for the thread of manual driving.
            await to_thread.run_sync(self._monitor.close)


def _monitor(robot: "RobotEntry", world: str) -> "Monitor":
    # The server answers before the simulator is loaded, which is slow.
    from learnblock.monitor import make_monitor  # noqa: PLC0415

    return make_monitor(robot, world)
