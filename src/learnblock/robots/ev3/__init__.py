"""LEGO's EV3: with ev3dev (LearnBlock's agent or rpyc) or with LEGO's own firmware."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from learnblock.client import Rights, RobotStatus, skill_sets
from learnblock.devices import (
    NOTHING_SEEN,
    Base,
    Bumper,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    Screen,
    Speaker,
)
from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots.calibration import Calibration
from learnblock.robots.ev3.brick import Drive, Say, Show, State, Tone, Word
from learnblock.robots.ev3.link import BrickLink
from learnblock.robots.ev3.settings import Settings
from learnblock.robots.ev3.ways import open_link
from learnblock.robots.real import RealRobot
from learnblock.robots.wheel_counts import WheelCounts, drivetrain_of, reachable_speeds
from learnblock.wheels import Drivetrain

__all__ = ["Robot", "Settings"]


class Robot(RealRobot[Settings], skill_sets.Ev3):
    """A brick with two motors for the wheels and up to four sensors."""

    settings_type = Settings
    model = "ev3"
    calibration = Calibration(distance="wheel_radius", angle="track")
    # Six cells or LEGO's accumulator; below 6.2 V, ev3dev switches off.
    battery_range = (6.2, 8.2)
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
                "Screen:ROBOT",
                "Speaker:ROBOT",
            }
        )

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return frozenset(
            {"DistanceSensors:front", "GroundSensors:line", "Speaker:say", "Speaker:tone"}
        )

    def connect(self) -> None:
        self._link: BrickLink | None = None
        self._counts = WheelCounts(self.settings.wheel_radius, self.settings.track)
        link = self._link = open_link(self.settings, self._follow, self.steady_clock)
        state = link.begin()
        self.add(Base(self._drive, self._pose, self.drivetrain_for(self.settings)))
        self._add_sensors(state)
        self.add(Speaker(say=self._say if link.speaks else None, tone=self._tone))
        self.add(Screen(self._show if link.shows else None))

    def disconnect(self) -> None:
        if self._link:
            self._link.close()

    def check_link(self) -> None:
        if self._link:
            self._link.check()

    def status(self) -> RobotStatus:
        link = self._link
        if link is None:
            return RobotStatus()
        state = link.known
        return RobotStatus(battery=state.battery if state else None, round_trip=link.round_trip)

    @classmethod
    def drivetrain_for(cls, settings: Settings) -> Drivetrain:
        return drivetrain_of(settings)

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
            # The sensor's own reset takes a second and makes it drift.
            self.add(Gyroscope.counting(partial(self._reading, "gyroscope")), "Z_AXIS")
        if state.touch is not None:
            self.add(Bumper(self._touched))

    def _follow(self, state: State) -> None:
        self._counts.follow(state.left, state.right)

    def _drive(self, adv: float, rot: float) -> None:
        self._send(Drive(*reachable_speeds(self.settings, adv, rot)))

    def _say(self, text: str) -> None:
        self._send(Say(text))

    def _tone(self, hertz: float, milliseconds: float) -> None:
        self._send(Tone(hertz, milliseconds))

    def _show(self, text: str) -> None:
        self._send(Show(text))

    def _touched(self) -> bool:
        return self._reading("touch") > 0

    def _pose(self) -> tuple[float, float, float]:
        self._now()
        return self._counts.pose

    def _distances(self) -> dict[str, list[float]]:
        return {"front": [min(self._reading("ultrasonic"), NOTHING_SEEN)]}

    def _ground(self) -> dict[str, float | None]:
        return {"left": None, "central": self._reading("colour"), "right": None}

    def _reading(self, sensor: str) -> float:
        reading: float | None = getattr(self._now(), sensor)
        if reading is None:
            raise RobotConnectionError("ev3-sensor-lost", sensor=sensor)
        return reading

    def _now(self) -> State:
        assert self._link  # noqa: S101 - devices exist only with a link
        return self._link.latest()

    def _send(self, word: Word) -> None:
        """Send a command, and ignore the brick's state in the answer."""
        assert self._link  # noqa: S101 - devices exist only with a link
        self._link.say(word)
