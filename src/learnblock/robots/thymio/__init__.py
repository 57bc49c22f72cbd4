"""Thymio, over a cable, its radio, the network or Thymio Suite.

from learnblock.robots.thymio import Robot

robot = Robot()
robot.move_straight(50)
robot.sleep(2)
"""

from collections.abc import Iterator, Mapping
from contextlib import ExitStack
from functools import partial
from typing import Any

from learnblock.client import Rights, skill_sets
from learnblock.devices import (
    Accelerometer,
    Base,
    Controller,
    Display,
    DistanceSensors,
    GroundSensors,
    RGBLed,
    Speaker,
)
from learnblock.robots import settings as user_settings
from learnblock.robots.calibration import Calibration
from learnblock.robots.real import RealRobot
from learnblock.robots.thymio import equipment, finding, opening, units
from learnblock.robots.thymio.link import ThymioLink
from learnblock.robots.thymio.motors import Motors
from learnblock.robots.thymio.settings import ThymioSettings
from learnblock.wheels import Drivetrain

__all__ = ["Robot", "ThymioSettings"]


class Robot(RealRobot[ThymioSettings], skill_sets.Thymio):
    """A Thymio II."""

    settings_type = ThymioSettings
    model = "thymio"
    add_on = ("serial", "thymiodirect", "tdmclient")
    calibration = Calibration(distance="speed_unit", angle="track")
    # Thymio Suite and simulators; the cable and the radio's dongle.
    rights = Rights(network=True, devices=("/dev/ttyACM*", "/dev/ttyUSB*"))
    _link: ThymioLink | None = None
    _motors: Motors | None = None

    @classmethod
    def device_names(cls) -> frozenset[str]:
        lamps = {f"RGBLed:{slot}" for slot in equipment.SLOTS}
        kinds = "Accelerometer Base Controller Display DistanceSensors GroundSensors Speaker"
        return frozenset(lamps | {f"{kind}:ROBOT" for kind in kinds.split()})

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return frozenset(
            [f"DistanceSensors:{side}" for side in ("front", "left", "right", "back")]
            + ["GroundSensors:line", "Speaker:play", "Speaker:tone"]
        )

    @classmethod
    def drivetrain_for(cls, settings: ThymioSettings) -> Drivetrain:
        return units.drivetrain(settings.track, settings.speed_unit)

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        yield from finding.scan(user_settings.load(cls.name(), ThymioSettings), seconds)

    def connect(self) -> None:
        link = self._link = opening.open_link(self.settings, self.steady_clock)
        motors = self._motors = Motors(
            link, self.settings.track, self.settings.speed_unit, self.steady_clock
        )
        drivetrain = self.drivetrain_for(self.settings)
        self.add(Base(partial(self._move, motors), motors.pose, drivetrain))
        self.add(DistanceSensors(partial(self._distances, link)))
        self.add(GroundSensors(partial(self._ground, link)))
        self.add(Accelerometer(partial(self._acceleration, link)))
        self.add(Controller(partial(equipment.buttons, link)))
        self.add(Speaker(play=partial(equipment.play, link), tone=partial(equipment.tone, link)))
        lamps = {slot: equipment.Lamp(link, event) for slot, event in equipment.SLOTS.items()}
        self.add(Display(partial(equipment.show, lamps.values())))
        for slot, lamp in lamps.items():
            self.add(RGBLed(lamp.light), slot)

    def disconnect(self) -> None:
        with ExitStack() as ending:
            if self._link:
                ending.callback(self._link.close)
            if self._motors:
                ending.callback(self._motors.close)

    def check_link(self) -> None:
        if self._link:
            self._link.check()

    def _move(self, motors: Motors, adv: float, rot: float) -> None:
        track, unit = self.settings.track, self.settings.speed_unit
        motors.drive(*units.wheels(adv, rot, track=track, unit=unit))

    def _distances(self, link: ThymioLink) -> dict[str, list[float]]:
        return units.distances(link.read("prox.horizontal"))

    def _ground(self, link: ThymioLink) -> dict[str, float | None]:
        return units.ground(link.read("prox.ground.delta"))

    def _acceleration(self, link: ThymioLink) -> tuple[float, float, float]:
        return units.acceleration(link.read("acc"))
