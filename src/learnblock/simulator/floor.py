"""The floor: its brightness for ground sensors, and its picture for cameras."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any
from weakref import WeakValueDictionary

from learnblock.errors import Diagnostic, WorldError
from learnblock.i18n import Phrase
from learnblock.simulator import world_description
from learnblock.simulator.colours import RGB, reflectance, rgb
from learnblock.simulator.geometry import Point
from learnblock.simulator.world_description import WorldDescription

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from learnblock.simulator import textures
    from learnblock.simulator.camera import MipChain
    from learnblock.simulator.polyline import Polyline

MAXIMUM_PIXELS = 4_000_000
"""The limit of the floor's picture in pixels: 12 MB, and 1 mm per pixel on a floor of 2 by 2 m."""

#: The pictures of floors that are in use, by what is painted on them. A process that was forked
#: from one with such a floor need not draw its own.
_DRAWN: "WeakValueDictionary[tuple[Any, ...], MipChain]" = WeakValueDictionary()


@dataclass(frozen=True, slots=True, eq=False)
class PaintedLine:
    """A line on the floor, with round ends.

    Args:
        middle: the polyline along which it runs.
        width: its width in mm.
        colour: the colour of the paint.
    """

    middle: "Polyline"
    width: float
    colour: RGB
    low: Point
    high: Point
    #: What a ground sensor reads above it.
    level: float

    @classmethod
    def from_description(cls, line: world_description.Line) -> "PaintedLine":
        middle = line.polyline()
        margin = line.width
        (west, south), (east, north) = middle.points.min(axis=0), middle.points.max(axis=0)
        low = float(west - margin), float(south - margin)
        high = float(east + margin), float(north + margin)
        colour = rgb(line.colour)
        return cls(middle, line.width, colour, low, high, reflectance(colour))

    def coverage(self, x: float, y: float, spot: float) -> float:
        """The part of a spot (diameter in mm) at (x, y) that is on the line, 0 to 1."""
        distance = self.middle.distance(x, y)
        return min(1.0, max(0.0, (self.width / 2 - distance) / spot + 0.5))


class Floor:
    """A world's floor, its middle at (0, 0)."""

    def __init__(self, world: WorldDescription) -> None:
        self.size = world.floor.size
        self._colour = rgb(world.floor.colour)
        self._level = reflectance(self._colour)
        self._lines = [PaintedLine.from_description(line) for line in world.line]
        self._picture = Path(world.folder, world.floor.picture) if world.floor.picture else None

    def reaches(self, x: float, y: float) -> bool:
        """Whether there is floor at (x, y)."""
        return abs(x) <= self.size[0] / 2 and abs(y) <= self.size[1] / 2

    def reflectance(self, x: float, y: float, spot: float = 1.0) -> float:
        """The brightness of a spot (diameter in mm) at (x, y), 0 to 100; 0 outside the floor."""
        if not self.reaches(x, y):
            return 0.0
        if self._picture is not None:
            return self._pictured(x, y, spot)
        level = self._level
        for line in self._lines:
            if line.low[0] < x < line.high[0] and line.low[1] < y < line.high[1]:
                level += line.coverage(x, y, spot) * (line.level - level)
        return level

    @property
    def image(self) -> "NDArray[np.uint8]":
        """RGB of shape (height, width, 3), row 0 in the north; do not modify it."""
        return self.mips.level(0)

    @cached_property
    def mips(self) -> "MipChain":
        """Its picture at all sizes; drawn when first used, unless another such floor has one."""
        # Imported here because a world without a camera does not need OpenCV.
        from learnblock.simulator import textures  # noqa: PLC0415 - see above
        from learnblock.simulator.camera import MipChain  # noqa: PLC0415 - as above

        lines = tuple(_floor_lines(textures.FloorLine, self._lines))
        design = (self.size, self._colour, lines, self._pixels_per_mm)
        if self._picture is not None:
            # The file may change.
            return MipChain(textures.floor(*design, _read(self._picture)))
        mips = _DRAWN.get(design)
        if mips is None:
            mips = _DRAWN[design] = MipChain(textures.floor(*design))
        return mips

    @property
    def _pixels_per_mm(self) -> float:
        return float(min(1.0, (MAXIMUM_PIXELS / (self.size[0] * self.size[1])) ** 0.5))

    def _pictured(self, x: float, y: float, spot: float) -> float:
        scale, (rows, columns) = self._pixels_per_mm, self.image.shape[:2]
        column, row = columns / 2 + x * scale, rows / 2 - y * scale
        radius = spot * scale / 2
        left, top = max(0, int(column - radius)), max(0, int(row - radius))
        window = self.image[top : int(row + radius) + 1, left : int(column + radius) + 1]
        red, green, blue = window.reshape(-1, 3).mean(axis=0).tolist()
        return reflectance((red, green, blue))


def _floor_lines(
    kind: "type[textures.FloorLine]", lines: Iterable[PaintedLine]
) -> "Iterable[textures.FloorLine]":
    for line in lines:
        points = tuple((float(x), float(y)) for x, y in line.middle.points)
        yield kind(points, line.width, line.colour)


def _read(file: Path) -> "NDArray[np.uint8]":
    import cv2  # noqa: PLC0415 - as above
    import numpy as np  # noqa: PLC0415 - as above

    # Through the bytes, because cv2.imread cannot open every path on Windows.
    picture = cv2.imdecode(np.frombuffer(file.read_bytes(), np.uint8), cv2.IMREAD_COLOR)
    if picture is None:
        message = Phrase("world-picture-damaged", picture=file.name)
        raise WorldError(file.name, [Diagnostic("wrong-picture", message)])
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB), np.uint8)
