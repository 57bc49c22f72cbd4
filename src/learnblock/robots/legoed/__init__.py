"""LEGO Education's Double Motor, and what belongs to it, by Bluetooth."""

from collections.abc import Iterator, Mapping
from typing import Any

from learnblock.client import Rights, RobotStatus, skill_sets
from learnblock.devices import (
    Base,
    Controller,
    GroundSensors,
    Gyroscope,
    JointMotor,
    RGBLed,
    Speaker,
)
from learnblock.robots import settings as user_settings
from learnblock.robots.calibration import Calibration
from learnblock.robots.legoed import colours, messages, nearby
from learnblock.robots.legoed.kit import Kit
from learnblock.robots.legoed.messages import KitReport, Product
from learnblock.robots.legoed.settings import Settings
from learnblock.robots.legoed.yaw import YawCount
from learnblock.robots.real import RealRobot
from learnblock.robots.wheel_counts import WheelCounts, drivetrain_of, reachable_speeds
from learnblock.wheels import Drivetrain

__all__ = ["Robot", "Settings"]

#: The % of its way from which a lever counts as a pressed button.
PRESSED = 30


class Robot(RealRobot[Settings], skill_sets.Legoed):
    """A Double Motor with two wheels, and the devices with the same connection card."""

    settings_type = Settings
    model = "legoed"
    add_on = ("bleak", "legoeducation")
    scan_seconds = 5.0
    calibration = Calibration(distance="wheel_radius", angle="track")
    rights = Rights(network=True)
    _kit: Kit | None = None

    @classmethod
    def device_names(cls) -> frozenset[str]:
        kinds = "Base Controller GroundSensors Speaker"
        return frozenset(
            {f"{kind}:ROBOT" for kind in kinds.split()}
            | {"Gyroscope:Z_AXIS", "JointMotor:ARM", "RGBLed:Status"}
        )

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return frozenset({"GroundSensors:line", "Speaker:tone"})

    @classmethod
    def drivetrain_for(cls, settings: Settings) -> Drivetrain:
        return drivetrain_of(settings)

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        yield from nearby.scan(user_settings.load(cls.name(), Settings), seconds)

    def connect(self) -> None:
        self._counts = WheelCounts(self.settings.wheel_radius, self.settings.track)
        self._turning = YawCount()
        kit = self._kit = Kit(self.settings, self._follow, self.steady_clock)
        self.add(Base(self._drive, self._pose, self.drivetrain_for(self.settings)))
        self.add(Gyroscope.counting(self._turned), "Z_AXIS")
        self.add(Speaker(tone=self._beep))
        self.add(RGBLed(self._light), "Status")
        if kit.has(Product.COLOUR_SENSOR):
            self.add(GroundSensors(self._ground))
        if kit.has(Product.CONTROLLER):
            self.add(Controller(self._levers))
        if kit.has(Product.SINGLE_MOTOR):
            self.add(JointMotor(self._bend, self._bent), "ARM")

    def disconnect(self) -> None:
        if self._kit:
            self._kit.close()

    def check_link(self) -> None:
        if self._kit:
            self._kit.check()

    def status(self) -> RobotStatus:
        if self._kit is None:
            return RobotStatus()
        base = self._kit.base
        battery = base.known.battery if base.known else None
        charge = None if battery is None else battery / 100
        return RobotStatus(charge=charge, signal=base.signal)

    def _follow(self, report: KitReport) -> None:
        if report.left is not None and report.right is not None:
            self._counts.follow(*self._facing(report.left, report.right))
        if report.yaw is not None:
            self._turning.follow(report.yaw)

    def _facing(self, left: float, right: float) -> tuple[float, float]:
        """What the robot's left and right wheel do, or the other way round."""
        return (left, right) if self.settings.front == "forward" else (-right, -left)

    def _drive(self, adv: float, rot: float) -> None:
        self._there.drive(*self._facing(*reachable_speeds(self.settings, adv, rot)))

    def _pose(self) -> tuple[float, float, float]:
        self._there.base.latest()
        return self._counts.pose

    def _turned(self) -> float:
        self._there.base.latest()
        return self._turning.degrees

    def _ground(self) -> dict[str, float | None]:
        reading = self._there.part(Product.COLOUR_SENSOR).latest().reflection
        return {"left": None, "central": float(reading or 0), "right": None}

    def _levers(self) -> dict[str, bool]:
        report = self._there.part(Product.CONTROLLER).latest()
        buttons: dict[str, bool] = {}
        for side, lever in (("l", report.left_lever or 0), ("r", report.right_lever or 0)):
            up, down = lever >= PRESSED, lever <= -PRESSED
            buttons |= {f"{side}Up": up, f"{side}Down": down}
            buttons |= {f"{side}Left": False, f"{side}Right": False}
        return buttons

    def _bend(self, degrees: float) -> None:
        self._there.part(Product.SINGLE_MOTOR).say(messages.turn_to(round(degrees)))

    def _bent(self) -> float:
        return float(self._there.part(Product.SINGLE_MOTOR).latest().left or 0)

    def _beep(self, hertz: float, milliseconds: float) -> None:
        del milliseconds
        self._there.base.say(messages.beep(min(round(hertz), messages.HIGHEST)))

    def _light(self, red: int, green: int, blue: int) -> None:
        self._there.base.say(messages.light(*colours.nearest((red, green, blue))))

    @property
    def _there(self) -> Kit:
        assert self._kit  # noqa: S101 - devices exist only with a kit
        return self._kit
