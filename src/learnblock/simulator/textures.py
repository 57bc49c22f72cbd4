"""Pictures for the surfaces of a world: tags, faces, and floors with lines."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.errors import TagNumberError, UnknownNameError
from learnblock.simulator.faces import EXPRESSIONS, Person, portrait

Image = NDArray[np.uint8]
Colour = tuple[int, int, int]
Point = tuple[float, float]

# A tag is 8 by 8 cells with its black border; one white cell around them is the quiet zone.
TAG_CELLS = 10
TAG_COUNT = 587
# The length in pixels of the pieces in which lines on a floor are drawn.
PIECE = 64
#: The emotions of drawn faces.
EMOTIONS = tuple(EXPRESSIONS)


def tag(number: int, pixels: int = 80) -> Image:
    """The AprilTag of family 36h11 with this number, in its white quiet zone.

    It is upright as OpenCV draws it, rotated by 180 degrees from libapriltag's tags; detectors
    recognise either. The black square takes 8/10 of the side: a tag of 80 mm is a poster of 100 mm.

    Args:
        number: 0 to 586.
        pixels: the side of the square picture, quiet zone included; multiples of 10 give equal
            cells.

    Returns:
        RGB, uint8, shape (pixels, pixels, 3).

    Raises:
        TagNumberError: the family has no such number.
        ValueError: the picture is too small to show a tag.
    """
    if not 0 <= number < TAG_COUNT:
        raise TagNumberError("world-no-tag", number=str(number), last=str(TAG_COUNT - 1))
    if pixels < TAG_CELLS:
        raise ValueError(
            f"a tag of {pixels} pixels cannot be read; it needs at least {TAG_CELLS}, one each cell"
        )
    family = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
    cells = np.full((TAG_CELLS, TAG_CELLS), 255, np.uint8)
    cells[1:-1, 1:-1] = cv2.aruco.generateImageMarker(family, number, TAG_CELLS - 2)
    grey = cv2.resize(cells, (pixels, pixels), interpolation=cv2.INTER_NEAREST)
    return np.asarray(cv2.cvtColor(grey, cv2.COLOR_GRAY2RGB), np.uint8)


@dataclass(frozen=True, slots=True)
class FloorLine:
    """A line on the floor with round ends and joints.

    Args:
        points: at least two, (x, y) in world mm.
        width: mm.
        colour: RGB.
    """

    points: Sequence[Point]
    width: float
    colour: Colour = (0, 0, 0)

    def __post_init__(self) -> None:
        if len(self.points) < 2:
            raise ValueError(f"a floor line has {len(self.points)} points; it needs two or more")
        if not self.width > 0:
            raise ValueError(f"a floor line is {self.width} mm wide; it must be above 0")


def floor(
    size: tuple[float, float],
    colour: Colour,
    lines: Iterable[FloorLine] = (),
    pixels_per_mm: float = 1.0,
    picture: Image | None = None,
) -> Image:
    """A floor seen from above, north up and (0, 0) mm in the middle, anti-aliased.

    Args:
        size: (east to west, north to south) in mm.
        colour: RGB of the ground.
        lines: drawn in this order, later ones on top.
        pixels_per_mm: the resolution.
        picture: RGB uint8 of any shape (height, width, 3), stretched over the ground below the
            lines.

    Returns:
        RGB, uint8, shape (size[1] * pixels_per_mm, size[0] * pixels_per_mm, 3) rounded; row 0 is
        the north edge.

    Raises:
        ValueError: the floor would have no pixels.
    """
    width, height = (round(length * pixels_per_mm) for length in size)
    if width < 1 or height < 1:
        raise ValueError(
            f"a floor of {size[0]} by {size[1]} mm at {pixels_per_mm} pixels per mm has no pixels"
        )
    image = _ground(width, height, colour, picture)
    for line in lines:
        _draw_line(image, line, pixels_per_mm)
    return image


def _ground(width: int, height: int, colour: Colour, picture: Image | None) -> Image:
    if picture is None:
        image = np.empty((height, width, 3), np.uint8)
        cv2.rectangle(image, (0, 0), (width, height), colour, cv2.FILLED)
        return image
    shrinks = width < picture.shape[1] or height < picture.shape[0]
    method = cv2.INTER_AREA if shrinks else cv2.INTER_LINEAR
    return np.array(cv2.resize(picture, (width, height), interpolation=method), np.uint8)


def _draw_line(image: Image, line: FloorLine, pixels_per_mm: float) -> None:
    points = _to_pixels(np.asarray(line.points, np.float64), image, pixels_per_mm)
    coverage = np.zeros(image.shape[:2], np.float32)
    for begin, end in pairwise(_pieces(points)):
        _cover(coverage, begin, end, 0.5 * line.width * pixels_per_mm)
    # Few pixels of a floor: their numbers select them faster than a mask of all.
    touched = np.flatnonzero(coverage)
    pixels, parts = image.reshape(-1, 3), coverage.reshape(-1, 1)[touched]
    beneath = pixels[touched].astype(np.float32)
    colour = np.array(line.colour, np.float32)
    pixels[touched] = np.rint(beneath + parts * (colour - beneath))


def _pieces(points: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """The same line in short steps: the rectangle around a long slanted line is mostly empty."""
    steps = [points[:1]]
    for begin, end in pairwise(points):
        count = max(1, int(np.ceil(np.hypot(*(end - begin)) / PIECE)))
        steps.append(np.linspace(begin, end, count + 1)[1:])
    return list(np.vstack(steps))


def _cover(
    coverage: NDArray[np.float32],
    begin: NDArray[np.float64],
    end: NDArray[np.float64],
    radius: float,
) -> None:
    """The part of each pixel within `radius` of a piece, from the distance of its centre."""
    low = np.floor(np.minimum(begin, end) - radius - 1).astype(int).clip(0)
    high = np.ceil(np.maximum(begin, end) + radius + 2).astype(int).clip(0)
    window = coverage[low[1] : high[1], low[0] : high[0]]
    x = low[0] + np.arange(window.shape[1]) - begin[0]
    y = low[1] + np.arange(window.shape[0])[:, None] - begin[1]
    dx, dy = end - begin
    along = ((x * dx + y * dy) / max(dx * dx + dy * dy, 1e-12)).clip(0, 1)
    distance = np.hypot(x - along * dx, y - along * dy)
    np.maximum(window, (radius + 0.5 - distance).clip(0, 1), out=window, casting="same_kind")


def _to_pixels(
    points: NDArray[np.float64], image: Image, pixels_per_mm: float
) -> NDArray[np.float64]:
    """World mm to (column, row), where integers are pixel centres."""
    middle = 0.5 * np.array([image.shape[1] - 1, image.shape[0] - 1])
    return middle + points * (pixels_per_mm, -pixels_per_mm)


def face(emotion: str, pixels: int = 200, person: int = 0) -> Image:
    """A drawn face that shows an emotion: a poster for a world.

    Args:
        emotion: fear, surprise, anger, sadness, disgust, joy or neutral.
        pixels: the side of the square picture.
        person: the number of the person, from 0.

    Returns:
        RGB, uint8, shape (pixels, pixels, 3).

    Raises:
        UnknownNameError: there is no such emotion.
        ValueError: `pixels` is below 1, or `person` below 0.
    """
    if emotion not in EXPRESSIONS:
        raise UnknownNameError("emotion", emotion, EMOTIONS)
    if pixels < 1:
        raise ValueError(f"a face of {pixels} pixels has none; it needs at least 1")
    if person < 0:
        raise ValueError(f"there is no person {person}; they count from 0")
    return portrait(EXPRESSIONS[emotion], Person.number(person)).scaled(pixels)
