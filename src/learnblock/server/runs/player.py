"""Runs the program of a session, and plays with its robot while none runs."""

from typing import TYPE_CHECKING

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.running import Report
from learnblock.runtime.messages import Variables
from learnblock.runtime.status import State
from learnblock.server import messages
from learnblock.server.runs import telemetry
from learnblock.server.runs.console import Console
from learnblock.server.runs.playing import Played, Playing, Setting, prepared
from learnblock.server.runs.reporter import Reporter

if TYPE_CHECKING:
    from learnblock.robots import RobotEntry
    from learnblock.robots.stage import Stage
    from learnblock.server.pages.page import Page
    from learnblock.server.sessions.session import Session

#: Being held comes with its line, and the end with its report.
_STATES: dict[State, messages.StateName] = {
    State.STARTING: "starting",
    State.RUNNING: "running",
    State.PAUSED: "paused",
    State.INPUT: "input",
}
IDLE = messages.RunState("idle")


class Player:
    """What runs, or stands still, in the world of a session.

    Args:
        session: whose program it is, and whose pages are told.
    """

    def __init__(self, session: "Session") -> None:
        self._session = session
        self._stage: Stage | None = None
        self._scene: messages.Scene | None = None
        self._playing: Playing | None = None
        self._state = IDLE
        self._speed: float | None = 1.0
        self._asked: messages.InputWanted | None = None
        self._variables: messages.Variables | None = None
        self._ended: messages.Ended | None = None
        self._console = Console()
        self._reporter = Reporter(self, self._console)

    # What the reporter asks.

    @property
    def stage(self) -> "Stage | None":
        """The robot in its world: the program's, once it has made it."""
        return (self._playing and self._playing.run.stage) or self._stage

    @property
    def active(self) -> bool:
        return self._playing is not None

    @property
    def block(self) -> str | None:
        return self._playing.block if self._playing else None

    @property
    def pages(self) -> "tuple[Page, ...]":
        return self._session.pages

    # Pages.

    def join(self, page: "Page") -> None:
        """Tell a page what all others know."""
        self._reporter.flush()
        printed = messages.Printed(self._console.kept) if self._console.kept else None
        known = (self._scene, self._state, printed, self._variables, self._asked, self._ended)
        for message in known:
            if message is not None:
                page.tell(message)
        self._reporter.greet()

    def watch(self) -> None:
        """A page has begun or ceased to watch the camera."""
        self._reporter.watch()

    # The stage.

    async def set_the_stage(self, robot: "RobotEntry", world: str) -> None:
        """Put a robot into a world.

        Raises:
            LearnBlockError: there is no room for it, or a program runs.
        """
        self._require_rest("change robot or world")
        stage = await to_thread.run_sync(_staged, robot, world)
        await self._close_stage()
        self._stage = stage
        self._scene = telemetry.scene(stage) if stage else None
        if self._scene:
            self._session.tell(self._scene)
        self._reporter.greet()

    async def reset_world(self) -> None:
        """Put everything back to where it was at first."""
        await self.set_the_stage(self._session.robot, self._session.world)

    def place(self, x: float, y: float, heading: float) -> None:
        """Set the robot down; the next run begins there."""
        if self._state.state not in {"idle", "ended", "paused", "held"}:
            raise LearnBlockError("the robot is moving: pause or stop the program to set it down")
        self._simulated().place(x, y, heading)
        self._reporter.attend()

    def drive(self, advance: float, rotation: float) -> None:
        """Drive by hand."""
        self._require_rest("drive by hand")
        self._simulated().drive(advance, rotation)
        self._reporter.attend()

    # The program.

    def require_no_errors(self) -> None:
        """Refuse a program that cannot be run.

        Raises:
            LearnBlockError: it has errors.
        """
        for problem in self._session.document.problems:
            if problem.severity == "error":
                place = f"line {problem.line}: " if problem.line else ""
                raise LearnBlockError(f"the program has an error: {place}{problem.message}")

    async def run(self, played: Played, *, paused: bool) -> None:
        """Run a program from the beginning."""
        session = self._session
        start = self._stage.start if self._stage else None
        setting = Setting(session.name, session.robot, session.world, start, session.breakpoints)
        playing = prepared(played, setting, self, self._console, paused=paused)
        playing.run.set_speed(self._speed)
        await self._close_stage()
        self._begin(playing)

    async def stop(self) -> None:
        """Stop the program and the robot, and return when they stand still."""
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
        """How fast this run and those to come are, times real time; None is as fast as it goes."""
        self._speed = factor
        if self._playing:
            self._playing.run.set_speed(factor)
        self._enter(self._state.state, self._state.block)

    def set_breakpoints(self, blocks: tuple[str, ...]) -> None:
        if self._playing:
            self._playing.set_breakpoints(blocks)

    def answer(self, text: str) -> None:
        """The line that the program waits for.

        Raises:
            LearnBlockError: it waits for none.
        """
        if not self._playing or not self._asked:
            raise LearnBlockError("the program does not ask for anything")
        self._asked = None
        self._playing.watcher.answer(text)

    async def close(self) -> None:
        """Stop everything, and look no more."""
        await self.stop()
        await self._close_stage()
        self._reporter.close()

    # What the run tells.

    def on_state(self, state: State) -> None:
        if state in _STATES:
            self._enter(_STATES[state])

    def on_held(self, line: int) -> None:
        if self._playing:
            self._enter("held", self._playing.played.block_at(line))

    def on_variables(self, variables: Variables) -> None:
        whens = tuple(messages.WhenNow(name, *now) for name, now in variables.whens.items())
        told = messages.Variables(variables.local, variables.shared, whens)
        if told != self._variables:
            self._variables = told
            self._session.tell(told)

    def on_input(self, prompt: str) -> None:
        self._reporter.flush()
        self._asked = messages.InputWanted(prompt)
        self._session.tell(self._asked)

    def on_ended(self, report: Report | Exception) -> None:
        playing = self._playing
        assert playing is not None  # noqa: S101 - it is told once, by the run that is over
        self._stage = playing.run.stage or self._stage
        self._playing = self._asked = None
        self._reporter.flush()
        self._reporter.attend()
        self._tell_end(playing, report)
        playing.over.set()

    # Within.

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
            self._session.tell(self._state)

    def _tell_end(self, playing: Playing, report: Report | Exception) -> None:
        if isinstance(report, Report):
            self._ended = playing.ended(report)
        else:
            sentence = f"the run could not be made: {report}"
            self._ended = messages.Ended("error", sentence, tried=playing.is_trial)
        self._session.tell(self._ended)
        self._enter("ended")
        self._session.ran(self._ended)

    def _require_rest(self, what: str) -> None:
        if self.active:
            raise LearnBlockError(f"a program is running: stop it first to {what}")

    def _simulated(self) -> "Stage":
        if self.stage is None:
            raise LearnBlockError("the chosen robot is no simulated one")
        return self.stage

    async def _close_stage(self) -> None:
        if self._stage:
            # It waits for the thread that a drive by hand has.
            await to_thread.run_sync(self._stage.close)


def _staged(robot: "RobotEntry", world: str) -> "Stage | None":
    # The simulator takes its time to be imported, and the server answers before it is.
    from learnblock.robots.stage import make_stage  # noqa: PLC0415

    return make_stage(robot, world)
