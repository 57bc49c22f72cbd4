"""The child's robot: the generic client, whose devices are calls over the link."""

from collections.abc import Callable, Collection, Iterable
from contextlib import suppress
from functools import partial
from typing import Any

import msgspec

from learnblock import skills as our_skills
from learnblock.client import Client
from learnblock.client.clock import Clock, WallClock
from learnblock.client.game import Game
from learnblock.client.keyboard import Keyboard
from learnblock.client.mailbox import Mailbox
from learnblock.devices import DEVICE_TYPES, Base, Device, Function
from learnblock.errors import (
    DeviceValueError,
    MissingDeviceError,
    ProgramStopped,
    RobotConnectionError,
)
from learnblock.i18n import Phrase
from learnblock.runtime.claims import is_need
from learnblock.runtime.hosts_play import HostsPlay
from learnblock.runtime.lines import without_line_events
from learnblock.runtime.lockstep import LockStepClock
from learnblock.runtime.log.noted_calls import noted_function, noted_skill
from learnblock.runtime.log.noting import Noting
from learnblock.runtime.messages import (
    Collect,
    Connect,
    Connected,
    DeviceOffer,
    Disconnect,
    Keys,
    Missing,
    Send,
)
from learnblock.runtime.values import described, plain
from learnblock.runtime.wire import LONGEST_WAIT, Wire
from learnblock.senses import is_decoration

#: Seconds of waiting on a real robot after which the program handles the host's messages.
LISTENING_PERIOD = 0.1
#: Values that cannot run code of the program, unlike those of its own classes.
SIMPLE = frozenset({type(None), bool, int, float, str})


class RemoteRobot(Client):
    """A robot whose devices are functions of the host.

    Args:
        wire: the wire to the host.
        offer: the devices of the host's robot.
        skills: the names of the skills the program uses.
        noting: notes what the program does with the robot; None without a log.
        anyway: whether the program goes on where it asks for something that the robot lacks.
    """

    sensing_period = None
    # The camera that the user's settings add is in the host.
    has_extra_camera = False

    def __init__(
        self,
        wire: Wire,
        offer: Connected,
        skills: Collection[str],
        noting: Noting | None = None,
        *,
        anyway: bool = False,
    ) -> None:
        self._wire = wire
        self._anyway = anyway
        self._offer = offer
        self._noting = noting
        self.seed = offer.seed
        clock = _clock(wire, offer, noting)
        super().__init__(skills=skills, clock=clock, observer=_Notes(wire, noting))
        self.mailbox = Mailbox(partial(_send, wire, noting), _Letters(wire, self.clock).collect)
        self.keyboard = Keyboard(_HeldKeys(wire, self.clock).held)
        self.game = Game(HostsPlay(wire, self.clock))

    @property
    def equipment(self) -> frozenset[str]:
        return self._offer.equipment

    def connect(self) -> None:
        for index, device in enumerate(self._offer.devices):
            self.add(_device(self._wire, index, device, self._noting), device.key)

    def disconnect(self) -> None:
        # A host that has exited has already stopped the robot.
        with suppress(ProgramStopped):
            self._wire.send(Disconnect())

    def note_missing(self, device: str) -> None:
        super().note_missing(device)
        if not (self._anyway or _is_harmless(device)):
            raise self._missing(device)

    def _missing(self, device: str) -> MissingDeviceError:
        kind, _, key = device.partition(":")
        named = Phrase("check-device", kind=kind, key=key)
        known = tuple(own for own, instance in self.devices() if type(instance).__name__ == kind)
        if self._skill is None:
            return MissingDeviceError("robot-lacks", device=named)
        if known:
            return MissingDeviceError(
                "check-no-device-of-name", device=named, key=key, skill=self._skill, known=known
            )
        return MissingDeviceError("robot-lacks-for-skill", skill=self._skill, device=named)

    def _method(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        method = super()._method(name, function)
        if self._noting:
            method = noted_skill(self._noting, name, method)
        is_ours = function.__module__.startswith(our_skills.__name__)
        return without_line_events(method, _are_simple) if is_ours else method

    def _stop_motors(self) -> None:
        """Do nothing: the host does that on `Disconnect`, and even if this process is dead."""


def connect(
    wire: Wire,
    skills: Collection[str],
    module: str,
    arguments: dict[str, Any],
    noting: Noting | None = None,
    *,
    anyway: bool = False,
) -> RemoteRobot:
    """Make the host create the robot of `module`, and return its counterpart here."""
    offer: Connected = wire.ask(Connect(module, arguments))
    wire.lockstep = offer.steps is not None
    return RemoteRobot(wire, offer, skills, noting, anyway=anyway)


class _Notes:
    """The observer of the program: the host writes the trace."""

    def __init__(self, wire: Wire, noting: Noting | None) -> None:
        self._wire = wire
        self._noting = noting

    def called(self, skill: str, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
        if not args and not kwargs:
            self._wire.note_skill(skill)
            return
        try:
            self._note_call(skill, args, kwargs, plain)
        except DeviceValueError:
            # Too much for a message.
            self._note_call(skill, args, kwargs, described)

    def _note_call(
        self,
        skill: str,
        args: tuple[Any, ...],
        kwargs: dict[str, Any],
        convert: Callable[[Any], Any],
    ) -> None:
        named = {name: convert(value) for name, value in kwargs.items()}
        self._wire.note_call(skill, tuple(map(convert, args)), named)

    def missing(self, skill: str, device: str) -> None:
        if is_need(device):
            self._wire.note(Missing(skill, device))
        if self._noting:
            self._noting.missing(skill, device)


def _is_harmless(device: str) -> bool:
    """Whether a program can go on without a device; a camera may only need a moment to see."""
    return is_decoration(device) or device.startswith("Detector:")


class _Letters:
    """The messages of other robots, which the host keeps until they are collected."""

    def __init__(self, wire: Wire, clock: Clock) -> None:
        self._wire = wire
        self._clock = clock
        self._instant: int | None = None

    def collect(self) -> Iterable[tuple[str, Any]]:
        """What has arrived; within one instant of a simulated world nothing new arrives."""
        instant = self._clock.instant
        if instant is not None and instant == self._instant:
            return ()
        self._instant = instant
        return [(name, value) for name, value in self._wire.ask(Collect())]


class _HeldKeys:
    """The keys that a person holds down, as the host knows them."""

    def __init__(self, wire: Wire, clock: Clock) -> None:
        self._wire = wire
        self._clock = clock
        self._instant: int | None = None
        self._keys: Collection[str] = ()

    def held(self) -> Collection[str]:
        """The keys; within one instant of a simulated world they stay the same."""
        instant = self._clock.instant
        if instant is None or instant != self._instant:
            self._keys = self._wire.ask(Keys())
            self._instant = instant
        return self._keys


def _send(wire: Wire, noting: Noting | None, name: str, value: Any) -> None:
    if noting:
        noting.sent(name, value)
    # Where no time passes until the next request, it may wait for that.
    (wire.note if wire.lockstep else wire.send)(Send(name, value))


class _HostedWallClock(WallClock):
    """The time of a real robot, for a program that is watched while it waits.

    A long wait begins with everything that happened before it, so that the page shows the line that
    is waiting; meanwhile the host may ask for the variables.

    Args:
        wire: the wire to the host.
        noting: notes that time has passed.
    """

    def __init__(self, wire: Wire, noting: Noting | None) -> None:
        super().__init__()
        self._wire = wire
        self._noting = noting

    def sleep(self, seconds: float) -> None:
        self._sleep(seconds)
        if self._noting:
            self._noting.pass_time()

    def _sleep(self, seconds: float) -> None:
        if seconds <= LONGEST_WAIT:
            super().sleep(seconds)
            return
        if self._noting:
            self._noting.flush()
        self._wire.flush()
        until = self.time() + seconds
        while (left := until - self.time()) > 0:
            super().sleep(min(left, LISTENING_PERIOD))
            self._wire.listen()


def _are_simple(args: tuple[Any, ...], kwargs: dict[str, Any]) -> bool:
    """Whether one of our skills with these arguments runs nothing of the program."""
    return SIMPLE.issuperset(map(type, (*args, *kwargs.values())))


def _clock(wire: Wire, offer: Connected, noting: Noting | None) -> Clock:
    clock: Clock
    if offer.steps is None:
        clock = _HostedWallClock(wire, noting)
    else:
        wait = partial(_noted_wait, wire, noting) if noting else wire.sleep
        clock = LockStepClock(wait, offer.steps, offer.dt)
    if noting:
        noting.use_clock(clock)
    return clock


def _noted_wait(wire: Wire, noting: Noting, steps: int) -> int:
    noting.wait(steps)
    try:
        woke = wire.sleep(steps)
    except ProgramStopped:
        # What it still does happens at a time that it no longer learns.
        noting.end()
        raise
    noting.woke(woke)
    return woke


def _device(wire: Wire, index: int, offer: DeviceOffer, noting: Noting | None) -> Device:
    if offer.type not in DEVICE_TYPES:
        known = tuple(sorted(DEVICE_TYPES))
        raise RobotConnectionError("run-unknown-device", device=offer.type, known=known)
    functions: dict[str, Function] = {
        name: _function(wire, index, offer.type, name) for name in offer.functions
    }
    if noting:
        device = f"{offer.type}:{offer.key}"
        functions = {
            name: noted_function(noting, device, name, function)
            for name, function in functions.items()
        }
    if offer.type == "Base":
        return Base(**functions, drivetrain=offer.drivetrain)
    return DEVICE_TYPES[offer.type](**functions)


def _function(wire: Wire, index: int, kind: str, name: str) -> Function:
    if name == "detect":
        return partial(_detect, wire, index)
    if name == "read" and kind == "Camera":
        # A frame is taken when it is requested, and never before.
        return partial(wire.call, index, "read")
    if name == "read":
        return partial(_read, wire, index, _CONVERSIONS.get(kind, _unchanged))
    return partial(_command, wire, index, name)


def _command(wire: Wire, index: int, name: str, *args: Any) -> None:
    wire.command(index, name, args)


def _read(wire: Wire, index: int, convert: Callable[[Any], Any]) -> Any:
    return convert(wire.read(index))


def _detect(wire: Wire, index: int, detector: str) -> Any:
    from learnblock.perception.detections import KINDS  # noqa: PLC0415 - few programs see

    detections = wire.call(index, "detect", detector)
    return None if detections is None else msgspec.convert(detections, KINDS[detector])


def _tuple(value: list[float] | None) -> tuple[float, ...] | None:
    return None if value is None else tuple(value)


def _unchanged(value: Any) -> Any:
    return value


#: For readings that msgpack returns as another type.
_CONVERSIONS: dict[str, Callable[[Any], Any]] = {"Base": _tuple, "Accelerometer": _tuple}
