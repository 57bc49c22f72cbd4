"""LEGO's EV3: with ev3dev, by our agent on the brick or by rpyc, or with LEGO's own firmware."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

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
from learnblock.robots.ev3.brick import Say, State, Tone
from learnblock.robots.ev3.link import Link
from learnblock.robots.ev3.settings import Settings
from learnblock.robots.ev3.ways import find_way
from learnblock.robots.ev3.wheels import Odometry, turns
from learnblock.robots.real import RealRobot

__all__ = ["Robot", "Settings"]


class Robot(RealRobot[Settings]):
    """A brick with two motors as wheels, and those of the four sensors that are plugged in."""

    settings_type = Settings

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
        link = self._link = find_way(self.settings, self._odometry.follow)
        state = link.begin()
        self.add(
            Base(
                move=lambda adv, rot: _say(link, turns(adv, rot, radius, track)),
                read=self._pose,
            )
        )
        self._add_sensors(state)
        self.add(
            Speaker(
                say=(lambda text: _say(link, Say(text))) if link.speaks else None,
                tone=lambda hertz, milliseconds: _say(link, Tone(hertz, milliseconds)),
            )
        )

    def disconnect(self) -> None:
        if self._link:
            self._link.close()

    def check_link(self) -> None:
        if self._link:
            self._link.check()

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        from learnblock.robots.ev3.scan import scan  # noqa: PLC0415 - for who looks

        yield from scan(seconds)

    @classmethod
    def set_up(cls, settings: Settings, tell: Callable[[str], object]) -> None:
        from learnblock.robots.ev3.setup import set_up  # noqa: PLC0415 - once in a brick's life

        set_up(settings, tell)

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
        # Here and not in the sensor, whose own reset takes a second and lets it drift.
        self._zero = self._reading("gyroscope")

    def _reading(self, sensor: str) -> float:
        reading: float | None = getattr(self._now(), sensor)
        if reading is None:
            raise RobotConnectionError(
                f"the sensor `{sensor}` of the EV3 is gone: is its cable in?"
            )
        return reading

    def _now(self) -> State:
        assert self._link  # noqa: S101 - there are no devices without
        return self._link.latest()


def _say(link: Link, word: Any) -> None:
    """A word whose answer nobody waits for but the link."""
    link.say(word)
