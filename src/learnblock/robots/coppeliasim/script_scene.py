"""Our own scene: the robot that the script `scene.lua` in this folder builds and drives.

Its functions use our units and signs. Its motors stop after 0.35 s without a call, so the robot
has stopped within half a second.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import msgspec

from learnblock.devices import (
    DEFAULT_KEY,
    NOTHING_SEEN,
    Base,
    Camera,
    Device,
    Display,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    LightSensor,
    Pose,
)
from learnblock.robots.coppeliasim.readings import (
    BadReplyError,
    Turning,
    converted,
    finite,
    percent,
    picture,
)
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.robots.coppeliasim.script import Script, understood
from learnblock.robots.coppeliasim.settings import Settings

_SIDES = ("front", "left", "right", "back")
#: The largest reading of a light sensor.
_BRIGHTEST = 1023.0


class Description(msgspec.Struct, frozen=True):
    """The script's description of its robot: the devices, and the camera's handle or -1."""

    devices: tuple[str, ...]
    camera: int = -1


class SceneReadings(msgspec.Struct, frozen=True):
    """All readings of the robot at one moment: mm, degrees clockwise, 0 to 100."""

    pose: tuple[float, float, float]
    distances: Mapping[str, tuple[float, ...]] = {}
    ground: Mapping[str, float] = {}
    light: float = 0.0


class ScriptScene:
    """The robot of our own scene script."""

    has_watchdog = True

    def __init__(self, remote: Remote, settings: Settings) -> None:
        self._remote = remote
        path = settings.script or "/LearnBlock"
        self._script = Script(remote, path, missing="coppeliasim-no-script")
        self._about = self._script.ask(_description, "describe")
        self._turning = Turning(lambda: self._sense().pose[2], lambda: None)

    def devices(self) -> Iterator[tuple[Device, str]]:
        devices = self._known()
        for name in self._about.devices:
            if name in devices:
                yield devices[name], "Z_AXIS" if name == "Gyroscope" else DEFAULT_KEY

    def move(self, adv: float, rot: float) -> None:
        self._script.call("drive", adv, rot)

    def beat(self) -> object:
        return self._turning.read()

    def _known(self) -> Mapping[str, Device]:
        return {
            "Base": Base(self.move, lambda: self._sense().pose),
            "Camera": Camera(self._picture),
            "Display": Display(show_emotion=self._show),
            "DistanceSensors": DistanceSensors(self._distances),
            "GroundSensors": GroundSensors(self._ground),
            "Gyroscope": Gyroscope(self._turning.read, self._turning.reset),
            "LightSensor": LightSensor(lambda: self._sense().light),
        }

    def _sense(self) -> SceneReadings:
        return self._script.ask(_senses, "sense")

    def _distances(self) -> Mapping[str, Sequence[float]]:
        readings = self._sense().distances
        return {side: list(readings.get(side, ())) for side in _SIDES}

    def _ground(self) -> Mapping[str, float | None]:
        readings = self._sense().ground
        return {side: readings.get(side) for side in ("left", "central", "right")}

    def _picture(self) -> Any:
        image = self._remote.call("getVisionSensorImg", self._about.camera)
        return understood(self._remote, picture, "sim.getVisionSensorImg", image)

    def _show(self, emotion: str) -> None:
        self._script.call("show", emotion)


def _description(reply: Any) -> Description:
    about: Description = converted(reply, Description)
    if "Base" not in about.devices:
        raise BadReplyError(about.devices)
    return about


def _senses(reply: Any) -> SceneReadings:
    senses: SceneReadings = converted(reply, SceneReadings)
    return SceneReadings(
        pose=_pose(senses.pose),
        distances={side: _distances(readings) for side, readings in senses.distances.items()},
        ground={side: percent(reading) for side, reading in senses.ground.items()},
        light=min(max(finite(senses.light), 0.0), _BRIGHTEST),
    )


def _pose(pose: Pose) -> Pose:
    x, y, heading = map(finite, pose)
    return x, y, heading


def _distances(readings: Sequence[float]) -> tuple[float, ...]:
    return tuple(min(max(finite(reading), 0.0), NOTHING_SEEN) for reading in readings)
