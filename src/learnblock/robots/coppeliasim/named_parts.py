"""Any differential robot of a scene, by the names of its parts.

The poses of the wheels' joints give the track, the robot's heading, and the direction in which each
joint turns, so that none of these needs a setting.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from learnblock.devices import (
    DEFAULT_KEY,
    Base,
    Camera,
    Device,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    Pose,
)
from learnblock.errors import RobotConnectionError, SceneCallError
from learnblock.robots.coppeliasim.readings import (
    Turning,
    brightness,
    distance,
    matrix,
    picture,
)
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.robots.coppeliasim.script import understood
from learnblock.robots.coppeliasim.settings import Settings
from learnblock.wheels import wheel_speeds

T = TypeVar("T")
Matrix = tuple[float, ...]
SIDES = ("front", "left", "right", "back")


def devices_of(settings: Settings) -> frozenset[str]:
    """The devices for which the settings name objects of the scene."""
    paths_by_device = {
        "DistanceSensors": (settings.front, settings.left, settings.right, settings.back),
        "GroundSensors": (settings.ground_left, settings.ground_central, settings.ground_right),
        "Camera": (settings.camera,),
    }
    devices = {f"{device}:ROBOT" for device, paths in paths_by_device.items() if any(paths)}
    return frozenset(devices | {"Base:ROBOT", "Gyroscope:Z_AXIS"})


def sides_of(settings: Settings) -> tuple[str, ...]:
    """The sides on which the settings name distance sensors."""
    return tuple(side for side in SIDES if getattr(settings, side))


@dataclass(frozen=True, slots=True)
class Axle:
    """The poses of the wheels' two joints.

    Args:
        left: the matrix of the left joint.
        right: the matrix of the right joint.
    """

    left: Matrix
    right: Matrix

    @property
    def to_the_left(self) -> tuple[float, float]:
        """The vector from the right wheel to the left one, in m."""
        return self.left[3] - self.right[3], self.left[7] - self.right[7]

    @property
    def track(self) -> float:
        """The distance between the wheels in mm."""
        return 1000 * math.hypot(*self.to_the_left)

    @property
    def pose(self) -> Pose:
        """The point between the wheels, x and y in mm, and the heading in degrees clockwise."""
        along, across = self.to_the_left
        x, y = (self.left[3] + self.right[3]) / 2, (self.left[7] + self.right[7]) / 2
        # Forward is 90 degrees to the right of left.
        return 1000 * x, 1000 * y, math.degrees(math.atan2(along, across))

    def direction(self, joint: Matrix) -> float:
        """1 if positive turns of a joint roll its wheel forward, else -1.

        That is so if the joint's z axis points to the left.
        """
        along, across = self.to_the_left
        return math.copysign(1.0, joint[2] * along + joint[6] * across)


class NamedParts:
    """The robot whose parts are named in the settings; it has no watchdog.

    Raises:
        RobotConnectionError: the scene has no such object.
    """

    has_watchdog = False

    def __init__(self, remote: Remote, settings: Settings) -> None:
        self._remote = remote
        self._settings = settings
        self._left = self._object(settings.left_wheel, "left_wheel")
        self._right = self._object(settings.right_wheel, "right_wheel")
        axle = self._axle()
        self._track = axle.track
        self._directions = axle.direction(axle.left), axle.direction(axle.right)
        self._turning = Turning(lambda: self._axle().pose[2], lambda: None)

    def devices(self) -> Iterator[tuple[Device, str]]:
        yield Base(self.move, lambda: self._axle().pose), DEFAULT_KEY
        yield Gyroscope(self._turning.read, self._turning.reset), "Z_AXIS"
        present = devices_of(self._settings)
        if "DistanceSensors:ROBOT" in present:
            yield DistanceSensors(self._distances()), DEFAULT_KEY
        if "GroundSensors:ROBOT" in present:
            yield GroundSensors(self._ground()), DEFAULT_KEY
        if "Camera:ROBOT" in present:
            yield Camera(self._camera()), DEFAULT_KEY

    def move(self, adv: float, rot: float) -> None:
        left, right = wheel_speeds(adv, rot, self._track)
        self._turn(self._left, self._directions[0] * left)
        self._turn(self._right, self._directions[1] * right)

    def beat(self) -> object:
        """Read the heading; such a scene has no watchdog."""
        return self._turning.read()

    def _turn(self, joint: int, speed: float) -> None:
        """Turn a wheel at a ground speed in mm/s."""
        self._remote.call("setJointTargetVelocity", joint, speed / self._settings.wheel_radius)

    def _axle(self) -> Axle:
        return Axle(self._place(self._left), self._place(self._right))

    def _place(self, joint: int) -> Matrix:
        return self._ask(matrix, "getObjectMatrix", joint, self._remote.constant("handle_world"))

    def _distances(self) -> Callable[[], Mapping[str, Sequence[float]]]:
        sides = {
            side: [self._object(path, side) for path in getattr(self._settings, side)]
            for side in SIDES
        }
        return lambda: {
            side: [self._ask(distance, "readProximitySensor", sensor) for sensor in sensors]
            for side, sensors in sides.items()
        }

    def _ground(self) -> Callable[[], Mapping[str, float | None]]:
        sensors = {}
        for side in ("left", "central", "right"):
            path = getattr(self._settings, f"ground_{side}")
            sensors[side] = self._object(path, f"ground_{side}") if path else None
        return lambda: {
            side: None if sensor is None else self._ask(brightness, "readVisionSensor", sensor)
            for side, sensor in sensors.items()
        }

    def _camera(self) -> Callable[[], Any]:
        sensor = self._object(self._settings.camera, "camera")
        return lambda: self._ask(picture, "getVisionSensorImg", sensor)

    def _ask(self, read: Callable[[Any], T], function: str, *arguments: Any) -> T:
        reply = self._remote.call(function, *arguments)
        return understood(self._remote, read, f"sim.{function}", reply)

    def _object(self, path: str, setting: str) -> int:
        try:
            handle: int = self._remote.call("getObject", path)
        except SceneCallError:
            raise RobotConnectionError(
                "coppeliasim-no-object", path=path, setting=setting
            ) from None
        return handle
