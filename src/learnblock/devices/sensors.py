"""The devices that measure, in the order in which the page shows their readings."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, Self

from learnblock.devices.device import Sensor
from learnblock.devices.readings import (
    Axes,
    Buttons,
    ByPlace,
    CodeOrNone,
    Form,
    SeveralByPlace,
    YesOrNo,
)
from learnblock.devices.values import whole

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from learnblock.perception.sources import Vision

    Frame = NDArray[np.uint8]

#: The reading of a distance sensor that sees nothing, in mm.
NOTHING_SEEN = 2000.0

_SIDES = ("front", "left", "right", "back")
_UNDER = ("left", "central", "right")
_BUTTONS = ("lUp", "lLeft", "lRight", "lDown", "rUp", "rLeft", "rRight", "rDown")


class Camera(Sensor["Frame | None"]):
    """A camera.

    Args:
        read: returns the newest frame, uint8 RGB (height, width, 3), 320 by 240 by default, or None
            before the first one; every new frame is a new object.
        detect: `detect(name)` returns the result of a detector (``lines``, ``tags``, ``faces``,
            ...) for the newest frame, or None without a frame or such a detector; by default the
            frame is searched in this process.
        drawn: whether it sees only drawn and simulated faces, whose emotions may be recognised
            regardless of the settings.
        focal: the focal length of the lens in pixels, if known; the distance to tags needs it.
        close: switches the camera off, if necessary.
    """

    def __init__(
        self,
        read: "Callable[[], Frame | None]",
        detect: Callable[[str], Any] | None = None,
        *,
        drawn: bool = False,
        focal: float | None = None,
        close: Callable[[], None] | None = None,
    ) -> None:
        super().__init__(read, detect=detect or self._detect)
        self.detect: Callable[[str], Any] = self.functions["detect"]
        #: Whether it sees only drawn and simulated faces.
        self.drawn = drawn
        self._focal = focal
        self._switch_off = close
        self._vision: Vision | None = None

    def close(self) -> None:
        """Stop detecting and switch the camera off; calling it twice is harmless."""
        if self._vision:
            self._vision.close()
        if self._switch_off:
            self._switch_off()

    def _detect(self, name: str) -> Any:
        if self._vision is None:
            # Imported on first use: programs that do not use the camera start faster without it.
            from learnblock.perception.sources import Vision  # noqa: PLC0415

            self._vision = Vision(self.read, drawn=self.drawn, focal=self._focal)
        return self._vision.detect(name)


class DistanceSensors(Sensor[Mapping[str, Sequence[float]]]):
    """Distance sensors: `read` returns front, left, right and back, each a list of mm.

    A sensor between two directions is listed in both; 2000 means that it sees nothing.
    """

    form = SeveralByPlace(
        0,
        NOTHING_SEEN,
        "mm",
        places=_SIDES,
        quiet={side: [NOTHING_SEEN] for side in _SIDES},
    )


class GroundSensors(Sensor[Mapping[str, float | None]]):
    """Ground sensors: brightness left, central and right, 0 (dark) to 100, None if absent."""

    form = ByPlace(0, 100, "%", places=_UNDER, quiet=dict.fromkeys(_UNDER, 100.0))


class _Count:
    """Where a count of degrees began."""

    start = 0.0

    def begin(self, turned: Callable[[], float]) -> None:
        self.start = turned()

    def since(self, turned: Callable[[], float]) -> float:
        return turned() - self.start


class Gyroscope(Sensor[float]):
    """A gyroscope: `read` returns the degrees turned since `reset`; clockwise is positive.

    The angle is not wrapped. The usual key is ``Z_AXIS``, the axis that points up.
    """

    form = Form(-360, 360, "°", 1, is_limited=False)

    def __init__(self, read: Callable[[], float], reset: Callable[[], None]) -> None:
        super().__init__(read, reset=reset)

    @classmethod
    def counting(cls, turned: Callable[[], float]) -> Self:
        """A gyroscope whose own count goes on at a reset.

        Args:
            turned: returns the degrees turned since the robot was connected.
        """
        # Partials show the driver's function, not these, in the graph of calls.
        count = _Count()
        return cls(partial(count.since, turned), partial(count.begin, turned))

    def reset(self) -> None:
        """Set the current heading to 0."""
        self.functions["reset"]()


class Accelerometer(Sensor[tuple[float, float, float]]):
    """An accelerometer: `read` returns (x forward, y left, z up) in m/s2; z is 9.81 at rest."""

    form = Axes(
        -20,
        20,
        "m/s²",
        2,
        places=("forward", "left", "up"),
        is_limited=False,
        quiet=(0.0, 0.0, 9.81),
    )


class Bumper(Sensor[bool]):
    """A bumper: `read` returns True while it touches something."""

    form = YesOrNo(quiet=False)


class LightSensor(Sensor[float]):
    """A light sensor: `read` returns 0 (dark) to 1023."""

    form = Form(0, 1023, quiet=0.0)


class Controller(Sensor[Mapping[str, bool]]):
    """A hand controller: `read` returns which of its eight buttons are pressed.

    The buttons are lUp, lLeft, lRight, lDown, rUp, rLeft, rRight and rDown.
    """

    form = Buttons(places=_BUTTONS, quiet=dict.fromkeys(_BUTTONS, False))


class Infrared(Sensor[int | None]):
    """An infrared remote control: `read` returns the last code received, `send` sends one."""

    form = CodeOrNone(0, 255)

    def __init__(
        self, read: Callable[[], int | None], send: Callable[[int], None] | None = None
    ) -> None:
        super().__init__(read, send=send)

    def send(self, code: int) -> bool:
        """Send a code; return False if the robot can only receive."""
        return self._do("send", whole("code", code))
