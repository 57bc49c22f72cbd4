"""The child's robot: the generic client, whose devices are calls over the link."""

from collections.abc import Callable, Collection
from contextlib import suppress
from functools import partial
from typing import Any

import msgspec

from learnblock.client import Client
from learnblock.client.clock import Clock, WallClock
from learnblock.devices import DEVICE_TYPES, Device, Function
from learnblock.errors import ProgramStopped, RobotConnectionError
from learnblock.runtime.lockstep import LockStepClock
from learnblock.runtime.messages import (
    Ask,
    Called,
    Command,
    Connect,
    Connected,
    DeviceOffer,
    Disconnect,
    Missing,
)
from learnblock.runtime.values import plain
from learnblock.runtime.wire import LONGEST_WAIT, Wire

#: Seconds of waiting on a real robot after which the program handles the host's messages.
LISTENING_PERIOD = 0.1


class RemoteRobot(Client):
    """A robot whose devices are functions of the host.

    Args:
        wire: the wire to the host.
        offer: the devices of the host's robot.
        skills: the names of the skills the program uses.
    """

    sensing_period = None
    # The camera that the user's settings add is in the host.
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
        # A host that has exited has already stopped the robot.
        with suppress(ProgramStopped):
            self._wire.send(Disconnect())

    def _stop_motors(self) -> None:
        """Do nothing: the host does that on `Disconnect`, and even if this process is dead."""


def connect(
    wire: Wire, skills: Collection[str], module: str, arguments: dict[str, Any]
) -> RemoteRobot:
    """Make the host create the robot of `module`, and return its counterpart here."""
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


class _HostedWallClock(WallClock):
    """The time of a real robot, for a program that is watched while it waits.

    A long wait begins with everything that happened before it, so that the page shows the line that
    is waiting; meanwhile the host may ask for the variables.

    Args:
        wire: the wire to the host.
    """

    def __init__(self, wire: Wire) -> None:
        super().__init__()
        self._wire = wire

    def sleep(self, seconds: float) -> None:
        if seconds <= LONGEST_WAIT:
            super().sleep(seconds)
            return
        self._wire.catch_up()
        until = self.time() + seconds
        while (left := until - self.time()) > 0:
            super().sleep(min(left, LISTENING_PERIOD))
            self._wire.listen()


def _clock(wire: Wire, offer: Connected) -> Clock:
    if offer.steps is None:
        return _HostedWallClock(wire)
    return LockStepClock(wire.sleep, offer.steps, offer.dt)


def _device(wire: Wire, index: int, offer: DeviceOffer) -> Device:
    if offer.type not in DEVICE_TYPES:
        known = tuple(sorted(DEVICE_TYPES))
        raise RobotConnectionError("run-unknown-device", device=offer.type, known=known)
    functions: dict[str, Function] = {
        name: _function(wire, index, offer.type, name) for name in offer.functions
    }
    return DEVICE_TYPES[offer.type](**functions)


def _function(wire: Wire, index: int, kind: str, name: str) -> Function:
    if name == "detect":
        return partial(_detect, wire, index)
    if name == "read" and kind == "Camera":
        # A frame is taken when it is requested, and never before.
        return partial(wire.ask, Ask(index, "read", ()))
    if name == "read":
        return partial(_read, wire, index, _CONVERSIONS.get(kind, _unchanged))
    return partial(_command, wire, index, name)


def _command(wire: Wire, index: int, name: str, *args: Any) -> None:
    wire.command(Command(index, name, args))


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


#: For readings that msgpack returns as another type.
_CONVERSIONS: dict[str, Callable[[Any], Any]] = {"Base": _tuple, "Accelerometer": _tuple}
