"""The connection to one of iRobot's education robots, which sends and hears packets."""

import threading
from collections.abc import Callable, Sequence
from contextlib import suppress
from itertools import cycle

from learnblock.closing import Closing
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.robots.bluetooth import Radio
from learnblock.robots.irobot import messages
from learnblock.robots.irobot.messages import RobotMessage
from learnblock.robots.irobot.packets import Packet
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Seconds between two questions to an idle robot.
PERIOD = 0.03
#: Seconds without an answer until the robot counts as gone.
SILENCE = 2.0
#: Seconds for which an answer is new enough to be a reading.
FRESH = 0.2
#: Seconds for which a part answers that may be missing.
PROBING = 1.0
#: Seconds between two questions for the battery.
BATTERY_PERIOD = 10.0

Kind = tuple[int, int]


class PacketLink(Closing):
    """A connected robot.

    Args:
        radio: its connection.
        patience: the time limit of each step, in seconds.
        note: called with each packet that answers no question, in the thread of the connection.
        clock: the clock of its periods and limits.

    Attributes:
        battery: volts; None before the first answer.

    Raises:
        RobotConnectionError: there is no such robot, or it can't be used; the error says why.
    """

    def __init__(
        self,
        radio: Radio,
        patience: float,
        note: Callable[[Packet], None],
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        self._clock = clock
        self._patience = patience
        self._on_event = note
        self._changed = threading.Condition()
        #: Numbers and packets go out in the same order.
        self._sending = threading.Lock()
        self._number = 0
        #: The payloads of answers by kind, each with its number and its time.
        self._answers: dict[Kind, tuple[int, float, bytes]] = {}
        self._error: RobotConnectionError | None = None
        self._closed = threading.Event()
        self._thread: threading.Thread | None = None
        self.battery: float | None = None
        self._radio = radio
        try:
            self._radio.hear(messages.FROM_ROBOT, self._note, patience)
        except BaseException:
            self._radio.close()
            raise

    @property
    def place(self) -> str:
        return self._radio.loop.place

    @property
    def address(self) -> str:
        """Where the robot is, also if any would do."""
        return self._radio.address

    def serial_number(self) -> str:
        """As on the robot's label, such as RT0123456789."""
        value = self._radio.read(messages.SERIAL_NUMBER, self._patience)
        return value.decode("ascii", "replace")

    def watch(self, questions: Sequence[RobotMessage]) -> None:
        """Ask these questions again and again from now on, so that `latest` has their answers."""
        self._thread = threading.Thread(
            target=self._watch, args=(tuple(questions),), name="irobot", daemon=True
        )
        self._thread.start()

    def latest(self, question: RobotMessage) -> bytes:
        """The payload of an answer to a watched question, at most 0.2 s old.

        Raises:
            RobotConnectionError: the robot does not answer any more.
        """
        kind = question[:2]

        def is_fresh() -> bool:
            answer = self._answers.get(kind)
            is_new = answer is not None and self._clock.now() - answer[1] < FRESH
            return is_new or bool(self._error)

        with self._changed:
            is_there = self._clock.wait_for(self._changed, is_fresh, SILENCE)
            self._check()
            if not is_there:
                raise RobotConnectionError("robot-link-silent", place=self.place)
            return self._answers[kind][2]

    def ask(self, question: RobotMessage, seconds: float = SILENCE) -> bytes:
        """The payload of the answer to a question.

        Raises:
            RobotConnectionError: it does not answer within so many seconds, or is gone.
        """
        answer = self.probe(question, seconds)
        if answer is None:
            raise RobotConnectionError("robot-link-silent", place=self.place)
        return answer

    def probe(self, question: RobotMessage, seconds: float = PROBING) -> bytes | None:
        """The payload of the answer to a question; None if the robot does not answer it.

        Raises:
            RobotConnectionError: the robot is gone.
        """
        kind = question[:2]
        number = self.say(question)

        def is_answered() -> bool:
            return self._answers.get(kind, (None,))[0] == number or bool(self._error)

        with self._changed:
            is_there = self._clock.wait_for(self._changed, is_answered, seconds)
            self._check()
            return self._answers[kind][2] if is_there else None

    def say(self, message: RobotMessage) -> int:
        """Send a message; return its number. The robot has received it at the end.

        Raises:
            RobotConnectionError: the connection is broken.
        """
        self.check()
        with self._sending:
            number, self._number = self._number, (self._number + 1) % 256
            packet = Packet(message.device, message.command, number, message.payload)
            with self._changed:
                # The answer of 256 packets ago has the same number.
                self._forget(message[:2], number)
            self._radio.write(messages.TO_ROBOT, packet.encoded, self._patience)
        return number

    def check(self) -> None:
        """Check that the robot answers.

        Raises:
            RobotConnectionError: it does not.
        """
        with self._changed:
            self._check()

    def close(self) -> None:
        """Stop the robot, and close the connection."""
        if not self._closed.is_set():
            # Not if the connection is broken.
            with suppress(LearnBlockError):
                self.say(messages.STOP)
            self._closed.set()
        self._radio.close()
        if self._thread and self._thread is not threading.current_thread():
            self._thread.join()

    def _forget(self, kind: Kind, number: int) -> None:
        heard = self._answers.get(kind)
        if heard and heard[0] == number:
            self._answers[kind] = (-1, *heard[1:])

    def _check(self) -> None:
        """Check it, with the condition held."""
        self._radio.check()
        if self._error:
            raise RobotConnectionError(self._error.phrase.code, **self._error.phrase.values)
        if self._closed.is_set():
            raise RobotConnectionError("robot-link-closed", place=self.place)

    def _watch(self, questions: Sequence[RobotMessage]) -> None:
        """Ask until the connection ends."""
        turns = cycle(questions)
        battery = Deadline.after(0, self._clock)
        try:
            while not self._clock.wait(self._closed, PERIOD):
                self.ask(next(turns))
                if battery.is_over:
                    self.ask(messages.BATTERY)
                    battery = Deadline.after(BATTERY_PERIOD, self._clock)
        except LearnBlockError as error:
            self._fail(error)

    def _fail(self, error: LearnBlockError) -> None:
        with self._changed:
            if not self._closed.is_set() and isinstance(error, RobotConnectionError):
                self._error = self._error or error
            self._changed.notify_all()

    def _note(self, data: bytes) -> None:
        """Take a packet of the robot, in the thread of the connection."""
        try:
            packet = Packet.parsed(data)
            self._take(packet)
        except ValueError:
            self._fail(RobotConnectionError("irobot-garbled", place=self.place))
        except LearnBlockError as error:
            self._fail(error)

    def _take(self, packet: Packet) -> None:
        kind = packet[:2]
        if kind == messages.BUTTON:
            raise RobotConnectionError("irobot-button", place=self.place)
        if kind in messages.EVENTS:
            self._on_event(packet)
            return
        if kind == messages.BATTERY[:2]:
            self.battery = messages.volts(packet.payload)
        with self._changed:
            self._answers[kind] = packet.number, self._clock.now(), packet.payload
            self._changed.notify_all()
