"""What the drivers of Root and Create 3 share."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack
from functools import partial
from typing import Annotated, Any, ClassVar

import msgspec
from msgspec import Meta

from learnblock.client import Rights, RobotStatus
from learnblock.devices import Base, Bumper, Pose, RGBLed, Speaker
from learnblock.errors import RobotConnectionError
from learnblock.robots import bluetooth
from learnblock.robots import settings as user_settings
from learnblock.robots.bluetooth import Radio
from learnblock.robots.guardian import Guardian
from learnblock.robots.irobot import messages
from learnblock.robots.irobot.link import PacketLink
from learnblock.robots.irobot.messages import RobotMessage
from learnblock.robots.irobot.packets import Packet
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import Patience, RobotSettings
from learnblock.wheels import Drivetrain, wheel_speeds


class IRobotSettings(RobotSettings, frozen=True, kw_only=True):
    """Which robot."""

    address: Annotated[str, Meta(max_length=100, description="robot-setting-irobot-address")] = ""
    patience: Patience = 5.0


class IRobot(RealRobot[IRobotSettings]):
    """A robot with two wheels, bumpers, lights and a sounder.

    Its protocol has no watchdog, so a guardian stops it if the program's process is gone or frozen.
    """

    settings_type = IRobotSettings
    add_on = ("bleak",)
    scan_seconds = 5.0
    # Its guardian.
    rights = Rights(network=True, programs=True)
    #: What its motors can do.
    motors: ClassVar[Drivetrain]
    #: Whether it is a Root.
    is_root: ClassVar[bool]
    #: The types of the devices that only it has.
    kinds: ClassVar[tuple[str, ...]]
    _link: PacketLink | None = None
    _guardian: Guardian | None = None

    @classmethod
    def device_names(cls) -> frozenset[str]:
        kinds = ("Base", "Bumper", "Speaker", *cls.kinds)
        return frozenset({*(f"{kind}:ROBOT" for kind in kinds), f"RGBLed:{messages.LAMP}"})

    @classmethod
    def drivetrain_for(cls, settings: IRobotSettings) -> Drivetrain:  # noqa: ARG003 - always the same
        return cls.motors

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        address = user_settings.load(cls.name(), IRobotSettings).address
        yield from bluetooth.scan(cls.name(), address, messages.SERVICE, seconds, cls.fits)

    @classmethod
    def fits(cls, advertised: Mapping[int, bytes]) -> bool:
        """Whether a robot that advertises this may be one of these; older firmware says nothing."""
        kind = advertised.get(messages.MAKER)
        return kind is None or kind.startswith(messages.ROOT) == cls.is_root

    @classmethod
    def standby(cls, settings: IRobotSettings) -> Callable[[], object]:
        return bluetooth.standby(
            cls.name(),
            settings.address,
            messages.TO_ROBOT,
            Packet(*messages.STOP[:2], 0).encoded,
            settings.patience,
        )

    def connect(self) -> None:
        self._pressed = False
        settings = self.settings
        radio = Radio(
            self.name(),
            settings.address,
            messages.SERVICE,
            self.steady_clock,
            settings.patience,
            fits=self.fits,
        )
        link = self._link = PacketLink(radio, settings.patience, self.note, self.steady_clock)
        self._require_kind(link)
        there = msgspec.structs.replace(settings, address=link.address)
        self._guardian = Guardian(type(self), there, self.steady_clock)
        link.say(messages.STOP)
        link.say(messages.RESET_POSITION)
        self.prepare(link)
        self.add(Bumper(self._bumped))
        self.add(RGBLed(self._shine), messages.LAMP)
        self.add(Speaker(tone=self._play))
        # It must not drive without one.
        self._guardian.wait_for_standby(settings.patience)

    def _require_kind(self, link: PacketLink) -> None:
        """Check that it is not the other one of iRobot's robots."""
        is_root = link.serial_number().startswith(messages.ROOT.decode())
        if is_root and not self.is_root:
            raise RobotConnectionError("irobot-is-root", place=link.place)
        # Only Create 3 answers this.
        if self.is_root and not is_root and link.probe(messages.PROXIMITY) is not None:
            raise RobotConnectionError("irobot-is-create3", place=link.place)

    def prepare(self, link: PacketLink) -> None:
        """Check what the robot is, watch its readings, and add the devices that only it has."""
        raise NotImplementedError

    def disconnect(self) -> None:
        # Both run even if one fails, in reverse order.
        with ExitStack() as ending:
            if self._guardian:
                ending.callback(self._guardian.dismiss)
            if self._link:
                ending.callback(self._link.close)

    def check_link(self) -> None:
        if self._guardian:
            self._guardian.check()
        if self._link:
            self._link.check()

    def status(self) -> RobotStatus:
        return RobotStatus(battery=self._link.battery if self._link else None)

    def add_base(self, link: PacketLink, pose: Callable[[bytes], Pose] | None) -> None:
        """Add the wheels; the robot's answer to `POSITION` says where it is."""

        def read(parsed: Callable[[bytes], Pose]) -> Pose:
            return parsed(link.latest(messages.POSITION))

        self.add(Base(self._drive, partial(read, pose) if pose else None, self.motors))

    def note(self, event: Packet) -> None:
        """Take what the robot reports by itself, in the thread of the connection."""
        if event[:2] == messages.BUMPER_EVENT:
            self._pressed = bool(messages.state(event.payload) & messages.BUMPERS)

    def reading(self, question: RobotMessage) -> bytes:
        """The latest answer to a question."""
        return self._there.latest(question)

    @property
    def _there(self) -> PacketLink:
        assert self._link  # noqa: S101 - devices exist only with a connection
        return self._link

    def _drive(self, adv: float, rot: float) -> None:
        if self._guardian and (adv or rot):
            self._guardian.check()
        # The robot limits each wheel by itself, which would bend a curve.
        speeds = self.motors.reachable(adv, rot)
        self._there.say(messages.drive(*wheel_speeds(*speeds, self.motors.track)))

    def _shine(self, red: int, green: int, blue: int) -> None:
        self._there.say(messages.lights(red, green, blue))

    def _play(self, hertz: float, milliseconds: float) -> None:
        self._there.say(messages.note(hertz, milliseconds))

    def _bumped(self) -> bool:
        self._there.check()
        return self._pressed
