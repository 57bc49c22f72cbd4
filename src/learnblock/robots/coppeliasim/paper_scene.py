"""The paper's scene of V-REP: an EV3 whose script `Funciones` has one function for each device.

The functions are written for the old remote API: each takes and returns lists of integers, of
floats and of strings, and a buffer. `On` takes mm/s and rad/s, clockwise positive as in the paper's
client; `SensorSonar` returns m, `SensorGyroA` degrees, `SensorLight` 0 to 100.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from learnblock.devices import (
    DEFAULT_KEY,
    NOTHING_SEEN,
    Base,
    Device,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
)
from learnblock.robots.coppeliasim.readings import (
    BadReplyError,
    Turning,
    finite,
    millimetres,
    percent,
)
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.robots.coppeliasim.script import Script
from learnblock.robots.coppeliasim.settings import Settings

#: The devices of the scene.
DEVICES = frozenset(
    {"Base:ROBOT", "DistanceSensors:ROBOT", "GroundSensors:ROBOT", "Gyroscope:Z_AXIS"}
)
_INTEGERS, _NUMBERS = 0, 1


class PaperScene:
    """The EV3 of the paper's scene; it has neither a watchdog nor odometry."""

    has_watchdog = False

    def __init__(self, remote: Remote, settings: Settings) -> None:
        path = settings.script or "/Funciones"
        self._script = Script(remote, path, missing="coppeliasim-no-paper-script")
        self._turning = Turning(self._heading, lambda: self._call("ResetGyroA"))

    def devices(self) -> Iterator[tuple[Device, str]]:
        yield Base(self.move), DEFAULT_KEY
        yield Gyroscope(self._turning.read, self._turning.reset), "Z_AXIS"
        yield DistanceSensors(self._distances), DEFAULT_KEY
        yield GroundSensors(self._ground), DEFAULT_KEY

    def move(self, adv: float, rot: float) -> None:
        self._call("On", adv, math.radians(rot))

    def beat(self) -> object:
        """Read the heading; the script has no watchdog."""
        return self._turning.read()

    def _heading(self) -> float:
        return self._script.ask(_first(_INTEGERS), "SensorGyroA", [], [], [], "")

    def _distances(self) -> Mapping[str, Sequence[float]]:
        return {"front": [self._script.ask(_sonar, "SensorSonar", [], [], [], "")]}

    def _ground(self) -> Mapping[str, float | None]:
        light = self._script.ask(_first(_INTEGERS), "SensorLight", [], [], [], "")
        return {"left": None, "central": percent(light), "right": None}

    def _call(self, function: str, *numbers: float) -> None:
        self._script.call(function, [], list(numbers), [], "")


def _sonar(reply: Any) -> float:
    """The distance in mm; both no value and 0 m mean that there was no echo."""
    if not _list(reply, _NUMBERS):
        return NOTHING_SEEN
    return millimetres(_list(reply, _NUMBERS)[0]) or NOTHING_SEEN


def _first(kind: int) -> Callable[[Any], float]:
    def read(reply: Any) -> float:
        values = _list(reply, kind)
        if not values:
            raise BadReplyError(reply)
        return finite(values[0])

    return read


def _list(reply: Any, kind: int) -> Sequence[Any]:
    """One of the lists of a reply; an empty list may arrive as an empty dictionary."""
    lists = reply if isinstance(reply, tuple) else (reply,)
    items = lists[kind] if len(lists) > kind else None
    if items == {}:
        return ()
    if not isinstance(items, list):
        raise BadReplyError(reply)
    return items
