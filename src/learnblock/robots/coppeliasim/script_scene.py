"""Our own scene: the robot that `scene.lua`, in this folder, builds and drives.

Its functions speak our units and signs, and its motors stop when nothing was heard for 0.35 s:
with what it takes to notice and to slow down they stand within half a second.
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
    NonsenseError,
    Turning,
    converted,
    finite,
    percent,
    picture,
)
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.robots.coppeliasim.script import Script, understood
from learnblock.robots.coppeliasim.settings import Settings

_ADVICE = "`learnblock robots setup coppeliasim` says how it gets there"
_SIDES = ("front", "left", "right", "back")
#: The brightest that a light sensor reads.
_BRIGHTEST = 1023.0


class Description(msgspec.Struct, frozen=True):
    """What the script says about its robot: its devices, and its camera's handle if it has one."""

    devices: tuple[str, ...]
    camera: int = -1


class Senses(msgspec.Struct, frozen=True):
    """Everything that the robot senses, at one moment: mm, degrees clockwise, 0 to 100."""

    pose: tuple[float, float, float]
    distances: Mapping[str, tuple[float, ...]] = {}
    ground: Mapping[str, float] = {}
    light: float = 0.0


class ScriptScene:
    """The robot of our own scene script."""

    has_watchdog = True

    def __init__(self, remote: Remote, settings: Settings) -> None:
        self._remote = remote
        self._script = Script(remote, settings.script or "/LearnBlock", _ADVICE)
        self._about = self._script.ask(_description, "describe")
        self._turning = Turning(lambda: self._sense().pose[2], lambda: None)

    def devices(self) -> Iterator[tuple[Device, str]]:
        known = self._known()
        for name in self._about.devices:
            if name in known:
                yield known[name], "Z_AXIS" if name == "Gyroscope" else DEFAULT_KEY

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

    def _sense(self) -> Senses:
        return self._script.ask(_senses, "sense")

    def _distances(self) -> Mapping[str, Sequence[float]]:
        seen = self._sense().distances
        return {side: list(seen.get(side, ())) for side in _SIDES}

    def _ground(self) -> Mapping[str, float | None]:
        seen = self._sense().ground
        return {side: seen.get(side) for side in ("left", "central", "right")}

    def _picture(self) -> Any:
        image = self._remote.call("getVisionSensorImg", self._about.camera)
        return understood(self._remote, picture, "sim.getVisionSensorImg", image)

    def _show(self, emotion: str) -> None:
        self._script.call("show", emotion)


def _description(reply: Any) -> Description:
    about: Description = converted(reply, Description)
    if "Base" not in about.devices:
        raise NonsenseError(f"{about.devices!r:.80} are devices without a Base")
    return about


def _senses(reply: Any) -> Senses:
    senses: Senses = converted(reply, Senses)
    return Senses(
        pose=_pose(senses.pose),
        distances={side: _distances(seen) for side, seen in senses.distances.items()},
        ground={side: percent(seen) for side, seen in senses.ground.items()},
        light=min(max(finite(senses.light), 0.0), _BRIGHTEST),
    )


def _pose(pose: Pose) -> Pose:
    x, y, heading = map(finite, pose)
    return x, y, heading


def _distances(seen: Sequence[float]) -> tuple[float, ...]:
    return tuple(min(max(finite(one), 0.0), NOTHING_SEEN) for one in seen)
