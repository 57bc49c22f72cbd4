"""LEGO's EV3: with ev3dev (LearnBlock's agent or rpyc) or with LEGO's own firmware."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from learnblock.client import Rights, RobotStatus
from learnblock.devices import (
    NOTHING_SEEN,
    Base,
    Bumper,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    Speaker,
)
from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots.ev3.brick import Say, State, Tone, Word
from learnblock.robots.ev3.link import Link
from learnblock.robots.ev3.settings import Settings
from learnblock.robots.ev3.ways import open_link
from learnblock.robots.ev3.wheels import Odometry, turns
from learnblock.robots.real import RealRobot

__all__ = ["Robot", "Settings"]


class Robot(RealRobot[Settings]):
    """A brick with two motors for the wheels and up to four sensors."""

    settings_type = Settings
    model = "ev3"
    # Bluetooth's serial port, and the USB cable.
    rights = Rights(network=True, devices=("/dev/rfcomm*", "/dev/hidraw*"))

    @classmethod
    def device_names(cls) -> frozenset[str]:
        return frozenset(
            {
                "Base:ROBOT",
                "Bumper:ROBOT",
                "DistanceSensors:ROBOT",
                "GroundSensors:ROBOT",
                "Gyroscope:Z_AXIS",
                "Speaker:ROBOT",
            }
        )

    def connect(self) -> None:
        self._link: Link | None = None
        radius, track = self.settings.wheel_radius, self.settings.track
        self._odometry = Odometry(radius, track)
        self._zero = 0.0
        link = self._link = open_link(self.settings, self._odometry.follow)
        state = link.begin()
        self.add(
            Base(
                move=lambda adv, rot: _send(link, turns(adv, rot, radius, track)),
                read=self._pose,
            )
        )
        self._add_sensors(state)
        self.add(
            Speaker(
                say=(lambda text: _send(link, Say(text))) if link.speaks else None,
                tone=lambda hertz, milliseconds: _send(link, Tone(hertz, milliseconds)),
            )
        )

    def disconnect(self) -> None:
        if self._link:
            self._link.close()

    def check_link(self) -> None:
        if self._link:
            self._link.check()

    def status(self) -> RobotStatus:
        state = self._link.known if self._link else None
        return RobotStatus(battery=state.battery if state else None)

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        from learnblock.robots.ev3.scan import scan  # noqa: PLC0415 - needed only to scan

        yield from scan(seconds)

    @classmethod
    def set_up(cls, settings: Settings, report: Callable[[Phrase], object]) -> None:
        from learnblock.robots.ev3.setup import set_up  # noqa: PLC0415 - needed once per brick

        set_up(settings, report)

    def _add_sensors(self, state: State) -> None:
        if state.ultrasonic is not None:
            self.add(DistanceSensors(self._distances))
        if state.colour is not None:
            self.add(GroundSensors(self._ground))
        if state.gyroscope is not None:
            self.add(Gyroscope(read=self._angle, reset=self._reset_angle), "Z_AXIS")
        if state.touch is not None:
            self.add(Bumper(lambda: self._reading("touch") > 0))

    def _pose(self) -> tuple[float, float, float]:
        self._now()
        return self._odometry.pose

    def _distances(self) -> dict[str, list[float]]:
        return {"front": [min(self._reading("ultrasonic"), NOTHING_SEEN)]}

    def _ground(self) -> dict[str, float | None]:
        return {"left": None, "central": self._reading("colour"), "right": None}

    def _angle(self) -> float:
        return self._reading("gyroscope") - self._zero

    def _reset_angle(self) -> None:
        # The sensor's own reset takes a second and makes it drift.
        self._zero = self._reading("gyroscope")

    def _reading(self, sensor: str) -> float:
        reading: float | None = getattr(self._now(), sensor)
        if reading is None:
            raise RobotConnectionError("ev3-sensor-lost", sensor=sensor)
        return reading

    def _now(self) -> State:
        assert self._link  # noqa: S101 - devices exist only with a link
        return self._link.latest()


def _send(link: Link, word: Word) -> None:
    """Send a command, and ignore the brick's state in the answer."""
    link.say(word)
