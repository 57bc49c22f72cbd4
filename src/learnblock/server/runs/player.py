"""Runs the program of a project, and moves its robot while no program runs."""

import asyncio
from collections.abc import Callable, Collection, Sequence
from contextlib import ExitStack
from typing import TYPE_CHECKING

from anyio import to_thread
from msgspec.structs import replace

from learnblock.errors import LearnBlockError, phrase_of
from learnblock.i18n import Phrase
from learnblock.running import Report
from learnblock.runtime.debugger import HeldBy
from learnblock.runtime.messages import Variables
from learnblock.runtime.recorder import Collision
from learnblock.runtime.status import State
from learnblock.server import messages
from learnblock.server.runs import telemetry
from learnblock.server.runs.console import Console, Voice, message_of
from learnblock.server.runs.kept import OpenedRun
from learnblock.server.runs.keyboard import SharedKeyboard
from learnblock.server.runs.playing import Playing
from learnblock.server.runs.reporter import Reporter
from learnblock.server.runs.shown_run import ShownRun
from learnblock.server.runs.viewers import Viewer, Viewers

if TYPE_CHECKING:
    from learnblock.devices import Pose
    from learnblock.monitor import Monitor

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
    """A robot of a project in its world, and the program that it runs.

    Args:
        console: the output of the program, which other robots may run too.
        readers: the pages that show the console.
        keyboard: the keyboard of the project.
        on_run_ended: called after each run.
        on_state: called after each change of the program's state.
    """

    def __init__(
        self,
        console: Console,
        readers: Viewers,
        keyboard: SharedKeyboard,
        on_run_ended: Callable[[messages.Ended], object],
        on_state: Callable[[], object],
    ) -> None:
        self.readers = readers
        #: The pages that show this robot.
        self.viewers = Viewers()
        self._keyboard = keyboard
        self._on_run_ended = on_run_ended
        self._on_state = on_state
        self._monitor: Monitor | None = None
        self._playing: Playing | None = None
        self._state = IDLE
        self._speed: float | None = 1.0
        self._asked: messages.InputWanted | None = None
        self._variables: messages.Variables | None = None
        self._ended: messages.Ended | None = None
        #: The report of the last run; None during a run.
        self.report: Report | None = None
        self.shown_run = ShownRun(self.viewers, console)
        self.console = console
        self.voice = Voice(console)
        self._reporter = Reporter(self, console)

    # For the reporter.

    @property
    def monitor(self) -> "Monitor | None":
        """The monitor of the robot: the program's, once it has created its robot."""
        return (self._playing and self._playing.run.monitor) or self._monitor

    @property
    def active(self) -> bool:
        return self._playing is not None

    @property
    def state(self) -> messages.StateName:
        """The state of the program."""
        return self._state.state

    @property
    def has_failed(self) -> bool:
        """Whether the last run has ended with an error."""
        return self._ended is not None and self._ended.ended == "error"

    @property
    def collisions(self) -> Sequence[Collision]:
        """What the robot has bumped into in this run, or the last one, if that is known."""
        if self.report:
            return self.report.collisions
        recorder = self._playing.run.recorder if self._playing else None
        return tuple(recorder.collisions) if recorder else ()

    @property
    def variables(self) -> dict[str, str]:
        """The program's variables as it has reported them, those of the function first."""
        variables = self._variables
        return {**variables.shared, **variables.local} if variables else {}

    @property
    def running_line(self) -> messages.RunningLine:
        return self._playing.running_line if self._playing else NOWHERE

    # Pages.

    def join(self, page: Viewer) -> None:
        """Send a page what the other pages have received, and all changes from now on."""
        self._reporter.flush()
        self.viewers.add(page)
        printed = message_of(self.console.kept)
        of_run = (self._variables, self._asked, self._ended)
        shown = self.shown_run
        for message in (shown.scene, self._state, printed, *of_run, shown.kept):
            if message is not None:
                page.send(message)
        self._reporter.greet()

    def watch(self) -> None:
        """Send camera frames, or stop, after a page has started or stopped watching."""
        self._reporter.watch()

    # The robot in its world.

    async def stage(self, monitor: "Monitor") -> None:
        """Show the robot in its world, while no program runs."""
        await self._close_monitor()
        self._monitor = monitor
        self.shown_run.enter(telemetry.scene(monitor))
        self._reporter.greet()

    def forget(self) -> None:
        """Forget the result and the variables of the last run, which was in another world."""
        self.shown_run.show_newest()
        self._variables = self._ended = self.shown_run.newest = None
        self._enter("idle")

    def attend(self) -> None:
        """Watch the world, because something moves in it or is about to."""
        self._reporter.attend()

    def place(self, x: float, y: float, heading: float) -> None:
        """Place the robot; the next run starts there.

        Raises:
            LearnBlockError: the robot is moving, or it is a real robot.
        """
        if self._state.state not in {"idle", "ended", "paused", "held"}:
            raise LearnBlockError("play-robot-moves")
        self._require_monitor().place(x, y, heading)
        self._reporter.attend()

    def handle(self, how: str) -> None:
        """Shake or tilt the robot.

        Raises:
            LearnBlockError: it is a real robot.
        """
        self._require_monitor().handle(how)
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

    async def run(self, playing: Playing) -> None:
        """Run a program from the beginning; if it can't begin, the pages show why."""
        try:
            await self.begin(playing)
            playing.start()
        except Exception as error:
            if not self.active:
                raise
            self.take_back(error)

    async def begin(self, playing: Playing) -> None:
        """Follow a run that is about to start."""
        playing.run.set_speed(self._speed)
        await self._close_monitor()
        self.console.clear()
        self._variables = self._ended = self.report = None
        self._playing = playing
        self.shown_run.newest = playing.looking
        self.shown_run.show_newest()
        self._enter("starting")
        self._reporter.begin()

    def take_back(self, error: Exception) -> None:
        """Report why a run could not begin, if it is about to."""
        if self._playing:
            self._playing.watcher.detach()
            self.on_ended(error)

    async def stop(self) -> None:
        """Stop the program and the robot; return once both have stopped, or were given up."""
        playing = self._playing
        if playing and not await playing.stop() and playing is self._playing:
            playing.watcher.detach()
            self._reporter.start_again()
            code = "play-given-up-real" if playing.is_real else "play-given-up"
            self.on_ended(Phrase(code))

    def check(self) -> None:
        """Notice a run whose thread has died without a report, as it does without memory."""
        if self._playing and self._playing.is_lost:
            # After what the thread has reported.
            asyncio.get_running_loop().call_soon(self._lose, self._playing)

    def _lose(self, playing: Playing) -> None:
        if playing is self._playing:
            self.on_ended(Phrase("play-lost"))

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
        self._enter(self._state.state, self._state.block, self._state.held_by)

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

    def leave(self, page: Viewer) -> None:
        """Stop sending messages to a page."""
        self.viewers.remove(page)
        self._reporter.watch()

    async def close(self) -> None:
        """Stop the program, the robot and the reports."""
        await self.stop()
        await self._close_monitor()
        self._reporter.close()

    def show_kept(self, kept: OpenedRun) -> None:
        """Let pages look back at a kept run.

        Raises:
            LearnBlockError: a program runs.
        """
        self._require_rest()
        self.shown_run.show_kept(kept)

    # Reports of the run, in the event loop; only `held_keys` is called from its thread.

    def on_state(self, state: State) -> None:
        if state in _STATES and self.state != "done":
            self._enter(_STATES[state])

    def on_held(self, line: int) -> None:
        if self._playing:
            playing = self._playing
            self._enter("held", playing.played.block_at(line), playing.run.held_by(line))

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

    def on_keys_wanted(self) -> None:
        if self._playing:
            self._keyboard.want(self, self._playing.run.program.keys)

    def on_sound(self, sound: messages.Sound) -> None:
        self.viewers.send(sound)

    def held_keys(self) -> Collection[str]:
        playing = self._playing
        return self._keyboard.held(self, is_guests=playing is not None and playing.is_guests)

    def on_done(self, report: Report) -> None:
        """Report the end of the program while those of other robots continue."""
        if self._playing is None:
            return
        self._reporter.flush()
        self._asked = None
        self._keyboard.ignore(self)
        self.report = report
        self._ended = replace(self._playing.ended(report), others=True)
        self.viewers.send(self._ended)
        self._enter("done")

    def on_ended(self, report: Report | Exception | Phrase) -> None:
        """Report the end of the run: its report, its error, or another reason."""
        playing = self._playing
        assert playing is not None  # noqa: S101 - each run reports its end once
        self._playing = self._asked = None
        # Whatever fails, for example without memory: the run is over, and the page shows that.
        with ExitStack() as ending:
            self._ended = messages.Ended("error", Phrase("play-lost"), tried=playing.is_call)
            # The last one first.
            ending.callback(playing.over.set)
            ending.callback(self._note_end)
            ending.callback(self._enter, "ended")
            ending.callback(self._send_end)
            # Once the report says what it has bumped into, which is forgotten with the run.
            ending.callback(self._reporter.flush)
            if not isinstance(report, Phrase):
                # Otherwise its robot may hang.
                self._monitor = playing.run.monitor or self._monitor
            self._keyboard.ignore(self)
            self._reporter.attend()
            self._describe_end(playing, report)

    # Helpers.

    def _enter(
        self,
        state: messages.StateName,
        block: str | None = None,
        held_by: HeldBy = "pause",
    ) -> None:
        self._reporter.flush()
        before, self._state = self._state, messages.RunState(state, block, self._speed, held_by)
        if self._state != before:
            self.viewers.send(self._state)
            self._on_state()

    def _describe_end(self, playing: Playing, report: Report | Exception | Phrase) -> None:
        if isinstance(report, Report):
            self.report = report
            self._ended = playing.ended(report)
            return
        if isinstance(report, Exception):
            report = Phrase("play-not-started", reason=phrase_of(report))
        self._ended = messages.Ended("error", report, tried=playing.is_call)

    def _send_end(self) -> None:
        if self._ended:
            self.viewers.send(self._ended)

    def _note_end(self) -> None:
        if self._ended:
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
