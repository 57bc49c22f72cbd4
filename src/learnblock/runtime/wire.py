"""The child's side of the conversation with the host."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from threading import get_ident
from time import monotonic
from typing import Any

from learnblock import errors
from learnblock.errors import (
    DeviceValueError,
    LearnBlockError,
    ProgramStopped,
    RobotConnectionError,
)
from learnblock.runtime.link import AtOnce, Link
from learnblock.runtime.messages import (
    MOST_WAITED,
    Answer,
    Ask,
    Called,
    Collect,
    Command,
    Continue,
    Control,
    Failed,
    FromHost,
    Input,
    Interrupted,
    Line,
    Message,
    ShowVariables,
    Sleep,
    Steps,
    Stop,
    Variables,
)
from learnblock.runtime.turn import Turn
from learnblock.runtime.values import encodable, is_small

#: Events wait for the next call, but are sent earlier after this many bytes or seconds.
MOST_QUEUED = 65536
LONGEST_WAIT = 0.05
#: As many steps, each with a few small arguments.
MOST_STEPS, FEW = 1000, 10


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
        #: What the program did that no message has reported yet.
        self._steps: list[int | str | Called | Command] = []
        #: The devices read since the program last slept, in order.
        self._used: dict[int, None] = {}
        #: Readings received at the last waking, until they are used or out of date.
        self._fresh: dict[int, Any] = {}
        #: Whether commands may wait for the next request, because no time passes until then.
        self.lockstep = False
        #: What the host does at once while no message is queued; None for nothing.
        self._at_once: AtOnce | None = None

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
        if self._at_once is not None:
            self.turn.require_permission()
            at = self._at_once.wait(min(steps, MOST_WAITED))
            if at is not None:
                self._fresh = {index: self.call(index, "read") for index in reads}
                return at
            answer = self._at_once.sleep(min(steps, MOST_WAITED), reads)
            if answer is not None:
                return self._woken(answer, reads)
        woke, readings = self.ask(Sleep(min(steps, MOST_WAITED), reads))
        self._fresh = dict(zip(reads, readings, strict=True))
        return int(woke)

    def _woken(self, answer: Answer | Failed, reads: tuple[int, ...]) -> int:
        if isinstance(answer, Failed):
            raise _error(answer)
        woke, readings = answer.value
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
        return self.call(index, "read")

    def call(self, device: int, function: str, *args: str) -> Any:
        """Call a function of a device, and return its value.

        Raises:
            ProgramStopped: the program is being stopped.
            LearnBlockError: the call failed.
        """
        if self._at_once is not None and _are_few(args):
            self.turn.require_permission()
            # An error comes by a message; what can be asked may be asked twice.
            with suppress(LearnBlockError):
                return self._at_once.answer(device, function, args)
        return self.ask(Ask(device, function, args))

    def command(self, device: int, function: str, args: tuple[Any, ...]) -> None:
        """Send a command: at once, or in lock-step with the next request."""
        # A command such as a gyroscope's reset changes the readings.
        self._fresh.clear()
        if self.lockstep and _are_few(args):
            if self.turn.forbidden_to is not None:
                self.turn.require_permission()
            if self._at_once is None:
                self.note_step(Command(device, function, args))
            elif not self._at_once.obey(device, function, args):
                self._at_once = None
            return
        with self.turn:
            if self._put(Command(device, function, args)) > MOST_QUEUED or not self.lockstep:
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

    def send(self, message: Message) -> None:
        """Send a message at once."""
        with self.turn:
            self._put(message)
            self._flush()

    def note_skill(self, skill: str) -> None:
        """Record that a skill is called without arguments."""
        if self.turn.forbidden_to is not None:
            self.turn.require_permission()
        name = skill if skill.isascii() else encodable(skill)
        if self._at_once is None:
            self.note_step(name)
        else:
            self._at_once.note(name)

    def note_call(self, skill: str, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
        """Record that a skill is called with these arguments, which are plain."""
        if kwargs or not _are_few(args):
            self.note(Called(skill, args, kwargs))
            return
        self.turn.require_permission()
        if self._at_once is None:
            self.note_step(Called(skill, args, {}))
        else:
            self._at_once.note_call(skill, args)

    def note_line(self, number: int) -> None:
        """Record that a line is about to run."""
        if self._at_once is None:
            self.note_step(number)
        else:
            self._at_once.note(number)

    def note_step(self, step: int | str | Called | Command) -> None:
        """Record that a line is about to run, a skill is called or a device commanded.

        Steps are sent together, before the next message.
        """
        self._steps.append(step)
        if len(self._steps) > MOST_STEPS or (not self.lockstep and self._is_late()):
            self.flush()

    def flush(self) -> None:
        """Send the steps of the program and everything else in the queue."""
        with self.turn:
            if self._steps:
                self._put_steps()
            self._flush_now()

    def hold(self, number: int, depth: int) -> None:
        """Report a line, and return when the program may run it."""
        with self.turn:
            self._put(Line(number, depth, self._variables()))
            self._flush()
            while not isinstance(self._receive(), Continue):
                # A paused program receives nothing else.
                continue

    def await_stop(self) -> None:
        """Wait until the host stops the program, because it has exceeded a limit."""
        self.flush()
        self.ask(Collect())

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
        # What the program does from now on comes after the message.
        self._at_once = None
        if self._steps:
            self._put_steps()
        return self._link.put(message)

    def _put_steps(self) -> None:
        steps, self._steps = self._steps, []
        self._put_some(steps)

    def _put_some(self, steps: Sequence[int | str | Called | Command]) -> None:
        try:
            self._link.put(Steps(tuple(steps)))
        except DeviceValueError:
            # Long texts: in two messages.
            half = len(steps) // 2
            if not half:
                raise
            self._put_some(steps[:half])
            self._put_some(steps[half:])

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
        finally:
            self._at_once = self._link.at_once

    def _is_late(self) -> bool:
        return monotonic() - self._flushed > LONGEST_WAIT


def _are_few(args: tuple[Any, ...]) -> bool:
    for value in args:
        # Without a call for most of them.
        if type(value) is not float and not is_small(value):
            return False
    return len(args) < FEW


def _error(failed: Failed) -> LearnBlockError:
    kind = getattr(errors, failed.error, RobotConnectionError)
    # Not through its own constructor, which may need more than the phrase.
    error: LearnBlockError = kind.__new__(kind)
    LearnBlockError.__init__(error, failed.phrase.code, **failed.phrase.values)
    return error
