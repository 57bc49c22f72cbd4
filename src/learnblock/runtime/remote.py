"""The robot as the child sees it: the generic client, its devices being calls over the link."""

import threading
from collections.abc import Callable, Collection
from contextlib import suppress
from functools import partial
from threading import get_ident
from time import monotonic
from typing import Any

import msgspec

from learnblock import errors
from learnblock.client import Client
from learnblock.clock import Clock, WallClock
from learnblock.devices import DEVICE_TYPES, Device, Function
from learnblock.errors import LearnBlockError, ProgramStopped, RobotConnectionError
from learnblock.runtime.link import Link
from learnblock.runtime.lockstep import LockStepClock
from learnblock.runtime.messages import (
    Answer,
    Ask,
    Called,
    Connect,
    Connected,
    Continue,
    Control,
    DeviceOffer,
    Disconnect,
    Failed,
    FromHost,
    Interrupted,
    Line,
    Lines,
    Message,
    Missing,
    ShowVariables,
    Sleep,
    Stop,
    Tell,
    Variables,
)
from learnblock.runtime.values import plain

#: Events wait for the next call, but not while more than this many bytes or seconds pile up.
MOST_QUEUED = 65536
LONGEST_WAIT = 0.05


class Turn:
    """A lock that refuses a thread to whom it is forbidden, and that no signal breaks into.

    A signal's handler runs in the main thread, between any two of its steps. If it raised while
    half a message is sent, or before the lock can be given back, nobody would understand the
    program or hear of it any more; so it `postpones` that until the turn is over.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        #: The thread that may not even wait for it.
        self.forbidden_to: int | None = None
        #: Whether the main thread has the lock, or waits for it.
        self._main_inside = False
        self._postponed: BaseException | None = None

    def __enter__(self) -> None:
        if self.forbidden_to is not None and self.forbidden_to == get_ident():
            raise LearnBlockError("a variable's description cannot ask the robot or print")
        self.take()

    def __exit__(self, *error: object) -> None:
        self.give_back()

    def take(self, *, wait: bool = True) -> bool:
        """Take the turn; whether it was to be had, where one does not wait for it."""
        in_main = _in_main_thread()
        if in_main:
            self._main_inside = True
        taken = self._lock.acquire(blocking=wait)
        if in_main and not taken:
            self._leave()
        return taken

    def give_back(self) -> None:
        """End the turn, and raise what was postponed."""
        self._lock.release()
        if _in_main_thread():
            self._leave()

    def postpones(self, error: BaseException) -> bool:
        """Whether a signal's handler must not raise `error`: it is raised at the turn's end.

        What describes a variable is the program's own code, which may be interrupted anywhere.
        """
        if not self._main_inside or self.forbidden_to == get_ident():
            return False
        self._postponed = error
        return True

    def _leave(self) -> None:
        self._main_inside = False
        postponed, self._postponed = self._postponed, None
        if postponed:
            raise postponed


def _in_main_thread() -> bool:
    return get_ident() == threading.main_thread().ident


class Wire:
    """The child's side of the conversation; several threads of a program may use it.

    Args:
        link: our end of the link.
        show: makes the program's variables as text.
    """

    def __init__(self, link: Link[FromHost], show: Callable[[], Variables]) -> None:
        self._link = link
        self._show = show
        #: Whose turn it is to speak.
        self.turn = Turn()
        #: Where the program is to be held.
        self.control = Control()
        self._flushed = 0.0
        self._lines: list[int] = []
        #: The devices read since the program last slept, in order.
        self._used: dict[int, None] = {}
        #: Readings that came with the last waking, until they are used or out of date.
        self._fresh: dict[int, Any] = {}
        #: Whether commands may wait for the next question, since until then no time passes.
        self.lockstep = False

    def ask(self, message: Message) -> Any:
        """Send a question and wait for its answer.

        Raises:
            ProgramStopped: the program is over.
            LearnBlockError: what was asked for failed.
        """
        with self.turn:
            self._put(message)
            self._flush()
            answer = self._receive()
        if type(answer) is Answer:
            return answer.value
        if isinstance(answer, Failed):
            raise _error(answer.error, answer.text)
        return answer

    def sleep(self, steps: int) -> int:
        """Park for that many steps; answer the world's step counter on waking."""
        reads, self._used = tuple(self._used), {}
        woke, readings = self.ask(Sleep(steps, reads))
        self._fresh = dict(zip(reads, readings, strict=True))
        return int(woke)

    def read(self, index: int) -> Any:
        """The reading of a device, which may have come with the last waking."""
        self._used[index] = None
        if index in self._fresh:
            return self._fresh.pop(index)
        return self.ask(Ask(index, "read", ()))

    def tell(self, message: Message) -> None:
        """Send a command: at once, or in lock-step with the next question."""
        # A command such as a gyroscope's reset changes what is read.
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
        """Queue an event that somebody is waiting to see, such as a print."""
        with self.turn:
            if self._put(message) > MOST_QUEUED or self._is_late():
                self._flush_now()

    def flush(self) -> None:
        """Send what is queued."""
        with self.turn:
            self._flush_now()

    def send(self, message: Message) -> None:
        """Send a message that cannot wait."""
        with self.turn:
            self._put(message)
            self._flush()

    def note_line(self, number: int) -> None:
        """Note that a line is about to run; lines travel together, before the next message."""
        self._lines.append(number)
        if not self.lockstep and self._is_late():
            with self.turn:
                self._put_lines()
                self._flush_now()

    def hold(self, number: int, depth: int) -> None:
        """Announce a line, and return when the program may run it."""
        with self.turn:
            self._put(Line(number, depth, self._variables()))
            self._flush()
            while not isinstance(self._receive(), Continue):
                # Nothing else is said to a program that is held.
                continue

    def listen(self) -> None:
        """Hear what the host has said unasked, without waiting for it."""
        if self.turn.take(wait=False):
            try:
                while message := self._heard():
                    self._obey(message)
            finally:
                self.turn.give_back()

    def interrupted(self, line: int, file: str, file_line: int) -> None:
        """Say where a signal found the program, unless another thread is speaking."""
        if self.turn.take(wait=False):
            try:
                self._put(Interrupted(line, file, file_line))
                self._flush()
            finally:
                self.turn.give_back()

    # With the lock held.

    def _put(self, message: Message) -> int:
        if self._lines:
            self._put_lines()
        return self._link.put(message)

    def _put_lines(self) -> None:
        lines, self._lines = self._lines, []
        self._link.put(Lines(tuple(lines)))

    def _receive(self) -> FromHost:
        """The answer to what was asked."""
        while True:
            try:
                message = self._link.receive()
            except EOFError as error:
                raise ProgramStopped("the robot's host is gone") from error
            if message is None:
                raise ProgramStopped("the link is silent")
            if type(message) is Answer or not self._obey(message):
                return message

    def _heard(self) -> FromHost | None:
        try:
            return self._link.receive_now()
        except EOFError as error:
            raise ProgramStopped("the robot's host is gone") from error

    def _obey(self, message: FromHost) -> bool:
        """Do what the host may say at any time; whether it was that."""
        match message:
            case Stop(reason):
                raise ProgramStopped(reason)
            case Control():
                self.control = message
            case ShowVariables():
                self._put(self._variables())
                self._flush()
            case _:
                return False
        return True

    def _variables(self) -> Variables:
        """The variables, whose own code may do nothing that others would notice."""
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


class RemoteRobot(Client):
    """A robot whose devices are functions of the host.

    Args:
        wire: the way to the host.
        offer: what the host's robot has.
        skills: the names of the skills the program uses.
    """

    sensing_period = None
    # The host has it.
    has_extra_camera = False

    def __init__(self, wire: Wire, offer: Connected, skills: Collection[str]) -> None:
        self._wire = wire
        self._offer = offer
        self.seed = offer.seed
        super().__init__(skills=skills, clock=_clock(wire, offer), observer=_Notes(wire))

    def connect(self) -> None:
        for index, device in enumerate(self._offer.devices):
            self.add(_device(self._wire, index, device), device.key)

    def disconnect(self) -> None:
        # A host that is gone has seen to its robot.
        with suppress(ProgramStopped):
            self._wire.send(Disconnect())

    def _stop_motors(self) -> None:
        """The host does, on hearing `Disconnect`: it can even when this process is dead."""


def connect(
    wire: Wire, skills: Collection[str], module: str, arguments: dict[str, Any]
) -> RemoteRobot:
    """Have the host make the robot of `module`, and answer its counterpart here."""
    offer: Connected = wire.ask(Connect(module, arguments))
    wire.lockstep = offer.steps is not None
    return RemoteRobot(wire, offer, skills)


class _Notes:
    """The observer of the program: the host writes the trace."""

    def __init__(self, wire: Wire) -> None:
        self._wire = wire

    def called(self, skill: str, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
        named = {name: plain(value) for name, value in kwargs.items()}
        self._wire.note(Called(skill, tuple(map(plain, args)), named))

    def missing(self, skill: str, device: str) -> None:
        self._wire.note(Missing(skill, device))


def _clock(wire: Wire, offer: Connected) -> Clock:
    if offer.steps is None:
        return WallClock()
    return LockStepClock(wire.sleep, offer.steps, offer.dt)


def _device(wire: Wire, index: int, offer: DeviceOffer) -> Device:
    if offer.type not in DEVICE_TYPES:
        raise RobotConnectionError(
            f"the robot has a {offer.type}, a type of device that programs cannot reach;"
            f" known are: {', '.join(sorted(DEVICE_TYPES))}"
        )
    functions: dict[str, Function] = {
        name: _function(wire, index, offer.type, name) for name in offer.functions
    }
    return DEVICE_TYPES[offer.type](**functions)


def _function(wire: Wire, index: int, kind: str, name: str) -> Function:
    if name == "detect":
        return partial(_detect, wire, index)
    if name == "read" and kind == "Camera":
        # A frame is taken when it is asked for, and never beforehand.
        return partial(wire.ask, Ask(index, "read", ()))
    if name == "read":
        return partial(_read, wire, index, _CONVERSIONS.get(kind, _unchanged))
    return partial(_tell, wire, index, name)


def _tell(wire: Wire, index: int, name: str, *args: Any) -> None:
    wire.tell(Tell(index, name, args))


def _read(wire: Wire, index: int, convert: Callable[[Any], Any]) -> Any:
    return convert(wire.read(index))


def _detect(wire: Wire, index: int, detector: str) -> Any:
    from learnblock.perception.detections import KINDS  # noqa: PLC0415 - few programs see

    found = wire.ask(Ask(index, "detect", (detector,)))
    return None if found is None else msgspec.convert(found, KINDS[detector])


def _tuple(value: list[float] | None) -> tuple[float, ...] | None:
    return None if value is None else tuple(value)


def _unchanged(value: Any) -> Any:
    return value


#: Of the readings that msgpack has no form of its own for.
_CONVERSIONS: dict[str, Callable[[Any], Any]] = {"Base": _tuple, "Accelerometer": _tuple}


def _error(name: str, text: str) -> LearnBlockError:
    kind = getattr(errors, name, RobotConnectionError)
    # The errors that carry more than a text were made for a person by the host: keep the sentence.
    error = kind.__new__(kind)
    Exception.__init__(error, text)
    return error  # type: ignore[no-any-return]
