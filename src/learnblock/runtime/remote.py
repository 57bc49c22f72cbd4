"""The robot as the child sees it: the generic client, its devices being calls over the link."""

import threading
from collections.abc import Callable, Collection
from functools import partial
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
    DeviceOffer,
    Disconnect,
    Failed,
    FromHost,
    Message,
    Missing,
    Sleep,
    Stop,
    Tell,
)

#: Events wait for the next call, but not while more than this many bytes or seconds pile up.
MOST_QUEUED = 65536
LONGEST_WAIT = 0.05


class Wire:
    """The child's side of the conversation; several threads of a program may use it."""

    def __init__(self, link: Link[FromHost]) -> None:
        self._link = link
        self._lock = threading.RLock()
        self._flushed = monotonic()
        #: Whether commands may wait for the next question, since until then no time passes.
        self.lockstep = False

    def ask(self, message: Message) -> Any:
        """Send a question and wait for its answer.

        Raises:
            ProgramStopped: the program is over.
            LearnBlockError: what was asked for failed.
        """
        with self._lock:
            self.send(message)
            return self._answer()

    def tell(self, message: Message) -> None:
        """Send a command: at once, or in lock-step with the next question."""
        with self._lock:
            self.note(message)
            if not self.lockstep:
                self._flush()

    def note(self, message: Message) -> None:
        """Queue an event."""
        with self._lock:
            if self._link.put(message) > MOST_QUEUED:
                self._flush()

    def note_soon(self, message: Message) -> None:
        """Queue an event that somebody is waiting to see, such as a print."""
        with self._lock:
            self.note(message)
            now = monotonic()
            if now - self._flushed > LONGEST_WAIT:
                self._flushed = now
                self._flush()

    def send(self, message: Message) -> None:
        with self._lock:
            self._link.put(message)
            self._flush()

    def receive(self) -> FromHost:
        """The next message from the host."""
        try:
            message = self._link.receive()
        except EOFError as error:
            raise ProgramStopped("the robot's host is gone") from error
        if message is None or isinstance(message, Stop):
            raise ProgramStopped(message.reason if message else "the link is silent")
        return message

    def _flush(self) -> None:
        try:
            self._link.flush()
        except EOFError as error:
            raise ProgramStopped("the robot's host is gone") from error

    def _answer(self) -> Any:
        match self.receive():
            case Answer(value):
                return value
            case Failed(name, text):
                raise _error(name, text)
            case Connected() | Continue() as message:
                return message
            case message:
                raise RobotConnectionError(f"unexpected answer {type(message).__name__}")


class RemoteRobot(Client):
    """A robot whose devices are functions of the host.

    Args:
        wire: the way to the host.
        offer: what the host's robot has.
        skills: the names of the skills the program uses.
    """

    sensing_period = None

    def __init__(self, wire: Wire, offer: Connected, skills: Collection[str]) -> None:
        self._wire = wire
        self._offer = offer
        self.seed = offer.seed
        super().__init__(skills=skills, clock=_clock(wire, offer), observer=_Notes(wire))

    def connect(self) -> None:
        for index, device in enumerate(self._offer.devices):
            self.add(_device(self._wire, index, device), device.key)

    def disconnect(self) -> None:
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
        self._wire.note(Called(skill, args, kwargs))

    def missing(self, skill: str, device: str) -> None:
        self._wire.note(Missing(skill, device))


def _clock(wire: Wire, offer: Connected) -> Clock:
    if offer.steps is None:
        return WallClock()
    return LockStepClock(lambda steps: wire.ask(Sleep(steps)), offer.steps, offer.dt)


def _device(wire: Wire, index: int, offer: DeviceOffer) -> Device:
    functions: dict[str, Function] = {
        name: _function(wire, index, offer.type, name) for name in offer.functions
    }
    return DEVICE_TYPES[offer.type](**functions)


def _function(wire: Wire, index: int, kind: str, name: str) -> Function:
    if name == "detect":
        return partial(_detect, wire, index)
    if name == "read":
        return partial(_read, wire, index, _CONVERSIONS.get(kind, _unchanged))
    return partial(_tell, wire, index, name)


def _tell(wire: Wire, index: int, name: str, *args: Any) -> None:
    wire.tell(Tell(index, name, args))


def _read(wire: Wire, index: int, convert: Callable[[Any], Any]) -> Any:
    return convert(wire.ask(Ask(index, "read", ())))


def _detect(wire: Wire, index: int, detector: str) -> Any:
    from learnblock.perception.detections import Face, Lines, Tag  # noqa: PLC0415 - few programs see

    found = wire.ask(Ask(index, "detect", (detector,)))
    kinds: dict[str, Any] = {"lines": Lines, "tags": tuple[Tag, ...], "faces": tuple[Face, ...]}
    return None if found is None else msgspec.convert(found, kinds[detector])


def _frame(value: Any) -> Any:
    if value is None:
        return None
    import numpy as np  # noqa: PLC0415 - few programs look at the picture itself

    return np.frombuffer(value["pixels"], dtype=np.uint8).reshape(value["shape"])


def _tuple(value: list[float]) -> tuple[float, ...]:
    return tuple(value)


def _unchanged(value: Any) -> Any:
    return value


_CONVERSIONS: dict[str, Callable[[Any], Any]] = {
    "Base": _tuple,
    "Accelerometer": _tuple,
    "Camera": _frame,
}


def _error(name: str, text: str) -> LearnBlockError:
    kind = getattr(errors, name, RobotConnectionError)
    # The errors that carry more than a text were made for a person by the host: keep the sentence.
    error = kind.__new__(kind)
    Exception.__init__(error, text)
    return error  # type: ignore[no-any-return]
