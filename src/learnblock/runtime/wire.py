"""The child's side of the conversation with the host."""

from collections.abc import Callable
from threading import get_ident
from time import monotonic
from typing import Any

from learnblock import errors
from learnblock.errors import LearnBlockError, ProgramStopped, RobotConnectionError
from learnblock.runtime.link import Link
from learnblock.runtime.messages import (
    Answer,
    Ask,
    Continue,
    Control,
    Failed,
    FromHost,
    Input,
    Interrupted,
    Line,
    Lines,
    Message,
    ShowVariables,
    Sleep,
    Stop,
    Variables,
)
from learnblock.runtime.turn import Turn

#: Events wait for the next call, but are sent earlier after this many bytes or seconds.
MOST_QUEUED = 65536
LONGEST_WAIT = 0.05


class Wire:
    """The child's side of the conversation; several threads of a program may use it.

    Args:
        link: this end of the link.
        show: describes the program's variables.
    """

    def __init__(self, link: Link[FromHost], show: Callable[[], Variables]) -> None:
        self._link = link
        self._show = show
        #: Taken by the thread that sends.
        self.turn = Turn()
        #: Where the program should pause.
        self.control = Control()
        self._flushed = 0.0
        self._lines: list[int] = []
        #: The devices read since the program last slept, in order.
        self._used: dict[int, None] = {}
        #: Readings received at the last waking, until they are used or out of date.
        self._fresh: dict[int, Any] = {}
        #: Whether commands may wait for the next request, because no time passes until then.
        self.lockstep = False

    def ask(self, message: Message) -> Any:
        """Send a request and wait for its answer.

        Raises:
            ProgramStopped: the program is being stopped.
            LearnBlockError: the request failed.
        """
        with self.turn:
            self._put(message)
            self._flush()
            answer = self._receive()
        if type(answer) is Answer:
            return answer.value
        if isinstance(answer, Failed):
            raise _error(answer)
        return answer

    def sleep(self, steps: int) -> int:
        """Park for that many steps; return the world's step counter on waking."""
        reads, self._used = tuple(self._used), {}
        woke, readings = self.ask(Sleep(steps, reads))
        self._fresh = dict(zip(reads, readings, strict=True))
        return int(woke)

    def input(self, prompt: str) -> tuple[str | None, int | None]:
        """Ask for a line of input; return it and the world's step, which may have advanced."""
        answer, steps = self.ask(Input(prompt))
        self._fresh.clear()
        return answer, steps

    def read(self, index: int) -> Any:
        """The reading of a device, which may have been received at the last waking."""
        self._used[index] = None
        if index in self._fresh:
            return self._fresh.pop(index)
        return self.ask(Ask(index, "read", ()))

    def command(self, message: Message) -> None:
        """Send a command: at once, or in lock-step with the next request."""
        # A command such as a gyroscope's reset changes the readings.
        self._fresh.clear()
        with self.turn:
            if self._put(message) > MOST_QUEUED or not self.lockstep:
                self._flush()

    def note(self, message: Message) -> None:
        """Queue an event."""
        with self.turn:
            if self._put(message) > MOST_QUEUED:
                self._flush()

    def note_soon(self, message: Message) -> None:
        """Queue an event that should be shown soon, such as a print."""
        with self.turn:
            if self._put(message) > MOST_QUEUED or self._is_late():
                self._flush_now()

    def flush(self) -> None:
        """Send everything that is queued."""
        with self.turn:
            self._flush_now()

    def send(self, message: Message) -> None:
        """Send a message at once."""
        with self.turn:
            self._put(message)
            self._flush()

    def note_line(self, number: int) -> None:
        """Record that a line is about to run; lines are sent together, before the next message."""
        self._lines.append(number)
        if not self.lockstep and self._is_late():
            self.catch_up()

    def catch_up(self) -> None:
        """Send the lines that have run and whatever else is queued."""
        with self.turn:
            if self._lines:
                self._put_lines()
            self._flush_now()

    def hold(self, number: int, depth: int) -> None:
        """Report a line, and return when the program may run it."""
        with self.turn:
            self._put(Line(number, depth, self._variables()))
            self._flush()
            while not isinstance(self._receive(), Continue):
                # A paused program receives nothing else.
                continue

    def listen(self) -> None:
        """Accept unsolicited messages from the host, without waiting for any."""
        if self.turn.take(wait=False):
            try:
                while message := self._receive_now():
                    self._accept(message)
            finally:
                self.turn.give_back()

    def interrupted(self, line: int, file: str, file_line: int) -> None:
        """Report where a signal reached the program, unless another thread is sending."""
        if self.turn.take(wait=False):
            try:
                self._put(Interrupted(line, file, file_line))
                self._flush()
            finally:
                self.turn.give_back()

    # These methods need the turn.

    def _put(self, message: Message) -> int:
        if self._lines:
            self._put_lines()
        return self._link.put(message)

    def _put_lines(self) -> None:
        lines, self._lines = self._lines, []
        self._link.put(Lines(tuple(lines)))

    def _receive(self) -> FromHost:
        """The answer to a request."""
        while True:
            try:
                message = self._link.receive()
            except EOFError as error:
                raise ProgramStopped("the robot's host is gone") from error
            if message is None:
                raise ProgramStopped("the link is silent")
            if type(message) is Answer or not self._accept(message):
                return message

    def _receive_now(self) -> FromHost | None:
        try:
            return self._link.receive_now()
        except EOFError as error:
            raise ProgramStopped("the robot's host is gone") from error

    def _accept(self, message: FromHost) -> bool:
        """Accept a message that can arrive at any time; return whether it is such a message."""
        match message:
            case Stop():
                raise ProgramStopped("stopped")
            case Control():
                self.control = message
            case ShowVariables():
                self._put(self._variables())
                self._flush()
            case _:
                return False
        return True

    def _variables(self) -> Variables:
        """The variables; the code that describes them may neither use the robot nor print."""
        self.turn.forbidden_to = get_ident()
        try:
            return self._show()
        finally:
            self.turn.forbidden_to = None

    def _flush_now(self) -> None:
        self._flushed = monotonic()
        self._flush()

    def _flush(self) -> None:
        try:
            self._link.flush()
        except EOFError as error:
            raise ProgramStopped("the robot's host is gone") from error

    def _is_late(self) -> bool:
        return monotonic() - self._flushed > LONGEST_WAIT


def _error(failed: Failed) -> LearnBlockError:
    kind = getattr(errors, failed.error, RobotConnectionError)
    # Not through its own constructor, which may need more than the phrase.
    error: LearnBlockError = kind.__new__(kind)
    LearnBlockError.__init__(error, failed.phrase.code, **failed.phrase.values)
    return error
