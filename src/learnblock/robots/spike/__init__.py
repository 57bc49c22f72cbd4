"""LEGO's SPIKE Prime and Robot Inventor, with Pybricks' firmware, by Bluetooth."""

import colorsys
from collections.abc import Iterator, Mapping
from typing import Any

from learnblock.client import Rights, RobotStatus, skill_sets
from learnblock.devices import (
    NOTHING_SEEN,
    Base,
    Bumper,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    RGBLed,
    Screen,
    Speaker,
)
from learnblock.errors import RobotConnectionError
from learnblock.robots import bluetooth
from learnblock.robots import settings as user_settings
from learnblock.robots.calibration import Calibration
from learnblock.robots.real import RealRobot
from learnblock.robots.spike import lines, profile
from learnblock.robots.spike.hub import Hub
from learnblock.robots.spike.lines import HubState
from learnblock.robots.spike.settings import Settings
from learnblock.robots.wheel_counts import WheelCounts, drivetrain_of, reachable_speeds
from learnblock.wheels import Drivetrain

__all__ = ["Robot", "Settings"]


class Robot(RealRobot[Settings], skill_sets.Spike):
    """A hub with two motors for the wheels and up to three sensors."""

    settings_type = Settings
    model = "spike"
    add_on = ("bleak",)
    scan_seconds = 5.0
    calibration = Calibration(distance="wheel_radius", angle="track")
    # Two lithium cells; below 6 V the hub switches off.
    battery_range = (6.0, 8.3)
    rights = Rights(network=True)
    _hub: Hub | None = None

    @classmethod
    def device_names(cls) -> frozenset[str]:
        kinds = "Base Bumper DistanceSensors GroundSensors Screen Speaker"
        return frozenset(
            {f"{kind}:ROBOT" for kind in kinds.split()} | {"Gyroscope:Z_AXIS", "RGBLed:Status"}
        )

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return frozenset({"DistanceSensors:front", "GroundSensors:line", "Speaker:tone"})

    @classmethod
    def drivetrain_for(cls, settings: Settings) -> Drivetrain:
        return drivetrain_of(settings)

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        address = user_settings.load(cls.name(), Settings).address
        yield from bluetooth.scan(cls.name(), address, profile.SERVICE, seconds)

    def connect(self) -> None:
        self._counts = WheelCounts(self.settings.wheel_radius, self.settings.track)
        hub = self._hub = Hub(self.settings, self._follow, self.steady_clock)
        self.add(Base(self._drive, self._pose, self.drivetrain_for(self.settings)))
        if hub.ports["distance"]:
            self.add(DistanceSensors(self._distances))
        if hub.ports["colour"]:
            self.add(GroundSensors(self._ground))
        if hub.ports["force"]:
            self.add(Bumper(self._pressed))
        self.add(Gyroscope.counting(self._heading), "Z_AXIS")
        self.add(Speaker(tone=self._tone))
        self.add(Screen(self._show))
        self.add(RGBLed(self._light), "Status")

    def disconnect(self) -> None:
        if self._hub:
            self._hub.close()

    def check_link(self) -> None:
        if self._hub:
            self._hub.check()

    def status(self) -> RobotStatus:
        if self._hub is None:
            return RobotStatus()
        state = self._hub.known
        return RobotStatus(battery=state.battery if state else None, signal=self._hub.signal)

    def _follow(self, state: HubState) -> None:
        self._counts.follow(state.left, state.right)

    def _drive(self, adv: float, rot: float) -> None:
        self._there.drive(*reachable_speeds(self.settings, adv, rot))

    def _pose(self) -> tuple[float, float, float]:
        self._there.latest()
        return self._counts.pose

    def _distances(self) -> dict[str, list[float]]:
        return {"front": [min(self._reading("distance"), NOTHING_SEEN)]}

    def _ground(self) -> dict[str, float | None]:
        return {"left": None, "central": self._reading("colour"), "right": None}

    def _pressed(self) -> bool:
        return self._reading("force") > 0

    def _heading(self) -> float:
        return self._there.latest().heading

    def _tone(self, hertz: float, milliseconds: float) -> None:
        self._there.say(lines.beep(hertz, milliseconds))

    def _show(self, text: str) -> None:
        self._there.say(lines.show(text))

    def _light(self, red: int, green: int, blue: int) -> None:
        hue, saturation, value = colorsys.rgb_to_hsv(red / 255, green / 255, blue / 255)
        self._there.say(lines.light(360 * hue, 100 * saturation, 100 * value))

    @property
    def _there(self) -> Hub:
        assert self._hub  # noqa: S101 - devices exist only with a hub
        return self._hub

    def _reading(self, sensor: str) -> float:
        reading: float | None = getattr(self._there.latest(), sensor)
        if reading is None:
            raise RobotConnectionError("spike-sensor-lost", sensor=sensor)
        return reading
