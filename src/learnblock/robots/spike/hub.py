"""The connection to a hub: it starts the agent there, sends it lines and hears its reports."""

import threading
from collections.abc import Callable
from contextlib import suppress
from importlib import resources

from learnblock.closing import Closing
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.robots.bluetooth import Radio, ReportLink
from learnblock.robots.spike import lines, profile
from learnblock.robots.spike.lines import HubState
from learnblock.robots.spike.settings import Settings
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: The compiled agent: `scripts/agent` makes it.
AGENT = "agent.mpy"
#: Seconds between two lines of an idle program: the hub stops its motors after 0.3.
PULSE = 0.1
#: The maximum number of characters of what a hub prints without ending the line.
LONGEST_LINE = 500


class Hub(Closing):
    """A hub with Pybricks on which the agent runs.

    The last drive command is repeated ten times per second, as for every robot that stops by itself
    if it hears nothing.

    Args:
        settings: the robot's settings.
        on_state: called with each report, in the thread of the connection.
        clock: the clock of its periods and limits.

    Attributes:
        ports: the port of each motor and sensor; "" where there is none.

    Raises:
        RobotConnectionError: there is no such hub, or it can't run the agent; the error says why.
    """

    def __init__(
        self,
        settings: Settings,
        on_state: Callable[[HubState], None],
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        self._clock = clock
        self._on_state = on_state
        self._printed = ""
        self._running = False
        self._greeting: str | None = None
        self._wish = lines.pulse()
        self._pulse = Deadline.after(PULSE, clock)
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._keep_alive, name="spike", daemon=True)
        self._patience = settings.patience
        self._radio = Radio(
            "spike", settings.address, profile.SERVICE, clock, seconds=settings.patience
        )
        self._reports: ReportLink[HubState] = ReportLink(self._radio, clock)
        #: When the agent must run.
        self._beginning = Deadline.after(settings.patience, clock)
        try:
            self._largest = self._prepare()
            self.ports = self._begin(settings)
            self.latest()
        except BaseException:
            self._radio.close()
            raise
        self._thread.start()

    @property
    def place(self) -> str:
        return self._reports.place

    @property
    def signal(self) -> int | None:
        """How strong its radio was when it was found, dBm."""
        return self._reports.signal

    @property
    def known(self) -> HubState | None:
        """The last report, however old."""
        return self._reports.known

    def latest(self) -> HubState:
        """A report that is at most 0.1 s old.

        Raises:
            RobotConnectionError: the hub does not report any more, or a motor is unplugged.
        """
        return self._reports.latest()

    def drive(self, left: float, right: float) -> None:
        """Turn the wheels until the next command: degrees/s, forward positive."""
        line = lines.drive(left, right)
        self._wish = line if left or right else lines.pulse()
        self.say(line)

    def say(self, line: bytes) -> None:
        """Send a line to the agent.

        Raises:
            RobotConnectionError: the connection is broken, or the agent has ended.
        """
        self.check()
        self._pulse = Deadline.after(PULSE, self._clock)
        for command in profile.typing(line, self._largest):
            self._write(command)

    def check(self) -> None:
        """Check that the agent runs and reports.

        Raises:
            RobotConnectionError: it does not.
        """
        self._reports.check()

    def close(self) -> None:
        """Stop the agent, and with it the motors, and close the connection."""
        if not self._closed.is_set():
            self._closed.set()
            self._reports.close()
            # Not if the connection is broken: then the agent ends by itself.
            with suppress(LearnBlockError):
                self._write(bytes([profile.HubCommand.STOP_PROGRAM]))
        self._radio.close()
        if self._thread.is_alive() and self._thread is not threading.current_thread():
            self._thread.join()

    def _prepare(self) -> int:
        """Check what the hub can do, and listen to it; return the largest command."""
        remaining = self._beginning.left
        text = self._radio.read(profile.SOFTWARE_REVISION, remaining).decode("ascii", "replace")
        described = self._radio.read(profile.CAPABILITIES, self._beginning.left)
        try:
            protocol = profile.version(text)
            capabilities = profile.Capabilities.parsed(described)
        except ValueError as error:
            raise RobotConnectionError("spike-garbled", place=self.place) from error
        if protocol < profile.OLDEST or not (
            capabilities.flags & profile.Capability.PROGRAM_OF_SEVERAL_FILES
        ):
            raise RobotConnectionError("spike-too-old", place=self.place, version=text)
        self._slots = capabilities.slots
        self._radio.hear(profile.COMMAND_EVENT, self._note, self._beginning.left)
        return capabilities.largest_write

    def _begin(self, settings: Settings) -> dict[str, str]:
        """Replace the hub's program by the agent, and start it; return the ports in use."""
        self._command(bytes([profile.HubCommand.STOP_PROGRAM]))
        self._wait_for(lambda: not self._running)
        agent = resources.files("learnblock.robots.spike").joinpath(AGENT).read_bytes()
        for command in profile.uploading(profile.packed("__main__", agent), self._largest):
            self._command(command)
        self._printed = ""
        self._command(profile.starting(self._slots))
        self._wait_for(lambda: self._running)
        for command in profile.typing(lines.wishes(settings.ports), self._largest):
            self._command(command)
        self._wait_for(lambda: self._greeting is not None)
        assert self._greeting is not None  # noqa: S101 - it was waited for
        try:
            return lines.ports(self._greeting)
        except ValueError as error:
            raise RobotConnectionError("spike-garbled", place=self.place) from error

    def _write(self, command: bytes) -> None:
        self._radio.write(profile.COMMAND_EVENT, command, self._patience)

    def _command(self, command: bytes) -> None:
        """Send a command before the agent runs."""
        self._radio.write(profile.COMMAND_EVENT, command, self._beginning.left)

    def _wait_for(self, predicate: Callable[[], bool]) -> None:
        if not self._reports.wait_for(predicate, self._beginning.left):
            raise RobotConnectionError("spike-not-started", place=self.place)

    def _keep_alive(self) -> None:
        while not self._clock.wait(self._closed, self._pulse.left):
            if not self._pulse.is_over:
                continue
            try:
                self.say(self._wish)
            except LearnBlockError:
                # The next use of the robot raises it again.
                return

    def _note(self, event: bytes) -> None:
        """Take an event of the hub, in the thread of the connection."""
        with self._reports.changed:
            try:
                self._take(event)
            except ValueError:
                self._reports.fail(RobotConnectionError("spike-garbled", place=self.place))
            except LearnBlockError as error:
                self._reports.fail(error)
            self._reports.changed.notify_all()

    def _take(self, event: bytes) -> None:
        kind, payload = event[:1], event[1:]
        if kind == bytes([profile.HubEvent.STATUS]):
            was_running = self._running
            self._running = bool(profile.status(event) & profile.HubStatus.PROGRAM_RUNNING)
            if was_running and not self._running and self._greeting:
                raise RobotConnectionError("spike-agent-ended", place=self.place)
        elif kind == bytes([profile.HubEvent.WRITE_STDOUT]):
            self._printed += payload.decode("ascii", "replace")
            *complete, self._printed = self._printed.split("\n")
            if len(self._printed) > LONGEST_LINE:
                raise ValueError("the line is too long")
            for line in complete:
                self._read(line.strip())

    def _read(self, line: str) -> None:
        if line.startswith((lines.GREETING, lines.ERROR)):
            self._greeting = self._greeting or line
            if line.startswith(lines.ERROR):
                raise lines.error(line)
        elif self._greeting:
            state = lines.state(line)
            if state:
                self._reports.note(state)
                self._on_state(state)
