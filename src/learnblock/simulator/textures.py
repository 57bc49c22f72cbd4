"""Pictures for the surfaces of a world: tags, faces, and floors with lines."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.errors import LearnBlockError, UnknownNameError

Image = NDArray[np.uint8]
Colour = tuple[int, int, int]
Point = tuple[float, float]

# A tag is 8 by 8 cells with its black border; one white cell around them is the quiet zone.
TAG_CELLS = 10
TAG_COUNT = 587
# OpenCV draws at fractions of a pixel when coordinates are given in 1/2**SHIFT.
SHIFT = 6
# Lines on a floor are drawn in pieces of so many pixels.
PIECE = 64
# Faces are drawn on a canvas of this side and scaled from there.
FACE_CANVAS = 400


class TextureError(LearnBlockError, ValueError):
    """A picture that cannot be drawn."""


def tag(number: int, pixels: int = 80) -> Image:
    """The AprilTag of family 36h11 with this number, in its white quiet zone.

    It stands as OpenCV draws it, turned by 180 degrees from libapriltag's printed tags; detectors
    recognise either. The black square takes 8/10 of the side: a tag of 80 mm is a poster of 100 mm.

    Args:
        number: 0 to 586.
        pixels: the side of the square picture, quiet zone included; multiples of 10 give even
            cells.

    Returns:
        RGB, uint8, shape (pixels, pixels, 3).

    Raises:
        TextureError: the family has no such number, or the picture is too small to show it.
    """
    if not 0 <= number < TAG_COUNT:
        raise TextureError(f"there is no tag {number}; family 36h11 has 0 to {TAG_COUNT - 1}")
    if pixels < TAG_CELLS:
        raise TextureError(
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
            raise TextureError(f"a floor line has {len(self.points)} points; it needs two or more")
        if not self.width > 0:
            raise TextureError(f"a floor line is {self.width} mm wide; it must be above 0")


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
        picture: RGB uint8 of any shape (height, width, 3), stretched over the ground beneath the
            lines.

    Returns:
        RGB, uint8, shape (size[1] * pixels_per_mm, size[0] * pixels_per_mm, 3) rounded; row 0 is
        the north edge.

    Raises:
        TextureError: the floor would have no pixels.
    """
    width, height = (round(length * pixels_per_mm) for length in size)
    if width < 1 or height < 1:
        raise TextureError(
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
    touched = coverage > 0
    beneath = image[touched].astype(np.float32)
    colour = np.array(line.colour, np.float32)
    image[touched] = np.rint(beneath + coverage[touched, None] * (colour - beneath))


def _pieces(points: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """The same way in short steps: the rectangle round a long slanting one is nearly all empty."""
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
    """How much of each pixel lies within `radius` of a piece, by its centre's distance from it."""
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


def _fixed(pixels: NDArray[np.float64]) -> NDArray[np.int32]:
    return np.asarray(np.rint(pixels * 2**SHIFT), np.int32)


@dataclass(frozen=True, slots=True)
class _Expression:
    """How a face shows an emotion, in parts of the face's width, downwards positive.

    Args:
        brow_inner: how far the brow's inner end lies beneath its place at rest.
        brow_outer: the same of its outer end.
        eye: how wide the eye is open, 1 at rest.
        mouth_width: half of it.
        corners: how far the mouth's corners lie beneath its middle.
        gap: how far the lips are apart.
        sneer: how far the upper lip and the wings of the nose are drawn up.
        blush: how red the cheeks are, 0 to 1.
    """

    brow_inner: float = 0.0
    brow_outer: float = 0.0
    eye: float = 1.0
    mouth_width: float = 0.105
    corners: float = 0.0
    gap: float = 0.0
    sneer: float = 0.0
    blush: float = 0.15


_EXPRESSIONS = MappingProxyType(
    {
        "fear": _Expression(-0.04, 0.015, 1.35, 0.10, 0.02, 0.035, 0.0, 0.0),
        "surprise": _Expression(-0.045, -0.04, 1.5, 0.06, 0.0, 0.10),
        "anger": _Expression(0.04, -0.025, 0.85, 0.095, 0.018, 0.0, 0.0, 0.5),
        "sadness": _Expression(-0.03, 0.025, 0.75, 0.095, 0.035, 0.0, 0.0, 0.1),
        "disgust": _Expression(0.02, 0.0, 0.65, 0.09, 0.03, 0.012, 0.025),
        "joy": _Expression(-0.01, -0.015, 0.85, 0.13, -0.05, 0.045, 0.0, 0.45),
        "neutral": _Expression(),
    }
)
EMOTIONS = tuple(_EXPRESSIONS)

_SKIN = (228, 184, 152)
_SHADOW = (120, 72, 56)
_LIGHT = (255, 228, 205)
_HAIR = (58, 38, 28)
_LIP = (176, 84, 80)
_BACKDROP = (196, 212, 222)
_SHIRT = (64, 104, 148)


def face(emotion: str, pixels: int = 200) -> Image:
    """A drawn face that shows an emotion: a poster for a world.

    Args:
        emotion: fear, surprise, anger, sadness, disgust, joy or neutral.
        pixels: the side of the square picture.

    Returns:
        RGB, uint8, shape (pixels, pixels, 3).

    Raises:
        UnknownNameError: there is no such emotion.
        TextureError: `pixels` is below 1.
    """
    if emotion not in _EXPRESSIONS:
        raise UnknownNameError("emotion", emotion, EMOTIONS)
    if pixels < 1:
        raise TextureError(f"a face of {pixels} pixels has none; it needs at least 1")
    easel = _Easel.blank(_BACKDROP)
    expression = _EXPRESSIONS[emotion]
    _draw_head(easel)
    _draw_shading(easel, expression)
    for side in (-1, 1):
        _draw_eye(easel, expression, side)
        _draw_brow(easel, expression, side)
    _draw_nose(easel, expression)
    _draw_mouth(easel, expression)
    return easel.scaled(pixels)


@dataclass(frozen=True, slots=True)
class _Easel:
    """A square picture drawn in layers; coordinates run from 0 to 1, right and down."""

    image: Image

    @classmethod
    def blank(cls, colour: Colour) -> "_Easel":
        return cls(np.full((FACE_CANVAS, FACE_CANVAS, 3), colour, np.uint8))

    def ellipse(
        self,
        center: Point,
        axes: Point,
        colour: Colour,
        *,
        opacity: float = 1.0,
        blur: float = 0.0,
    ) -> None:
        self.polygon(_oval(center, axes), colour, opacity=opacity, blur=blur)

    def polygon(
        self,
        outline: NDArray[np.float64],
        colour: Colour,
        *,
        opacity: float = 1.0,
        blur: float = 0.0,
    ) -> None:
        mask = np.zeros(self.image.shape[:2], np.uint8)
        cv2.fillPoly(mask, [_on_canvas(outline)], 255, cv2.LINE_AA, SHIFT)
        self._blend(mask, colour, opacity, blur)

    def stroke(
        self,
        path: NDArray[np.float64],
        width: float,
        colour: Colour,
        *,
        opacity: float = 1.0,
        blur: float = 0.0,
    ) -> None:
        mask = np.zeros(self.image.shape[:2], np.uint8)
        thickness = max(1, round(width * FACE_CANVAS))
        points = _on_canvas(path)
        cv2.polylines(mask, [points], False, 255, thickness, cv2.LINE_AA, SHIFT)  # noqa: FBT003 - OpenCV's own order
        self._blend(mask, colour, opacity, blur)

    def scaled(self, pixels: int) -> Image:
        method = cv2.INTER_AREA if pixels < FACE_CANVAS else cv2.INTER_CUBIC
        return np.asarray(cv2.resize(self.image, (pixels, pixels), interpolation=method), np.uint8)

    def inlay(self, other: "_Easel", outline: NDArray[np.float64]) -> None:
        """Show `other` within an outline."""
        mask = np.zeros(self.image.shape[:2], np.uint8)
        cv2.fillPoly(mask, [_on_canvas(outline)], 255, cv2.LINE_AA, SHIFT)
        cover = mask[..., None] * np.float32(1 / 255)
        blended = self.image + cover * (other.image - self.image.astype(np.float32))
        self.image[:] = np.rint(blended).astype(np.uint8)

    def _blend(self, mask: Image, colour: Colour, opacity: float, blur: float) -> None:
        """Let `colour` cover the picture where `mask` is white, softly for a `blur` above 0."""
        reach = round(3 * blur * FACE_CANVAS)
        left, top, width, height = cv2.boundingRect(mask)
        window = (
            slice(max(0, top - reach), top + height + reach),
            slice(max(0, left - reach), left + width + reach),
        )
        cover = mask[window].astype(np.float32) * (opacity / 255)
        if blur > 0:
            cover = np.asarray(cv2.GaussianBlur(cover, (0, 0), blur * FACE_CANVAS), np.float32)
        beneath = self.image[window].astype(np.float32)
        blended = beneath + cover[..., None] * (np.array(colour, np.float32) - beneath)
        self.image[window] = np.rint(blended).astype(np.uint8)


def _on_canvas(outline: NDArray[np.float64]) -> NDArray[np.int32]:
    return _fixed(outline * FACE_CANVAS - 0.5)


def _oval(center: Point, axes: Point) -> NDArray[np.float64]:
    angles = np.linspace(0, 2 * np.pi, 73)[:-1]
    return np.column_stack([np.cos(angles), np.sin(angles)]) * axes + center


def _arc(begin: Point, middle: Point, end: Point) -> NDArray[np.float64]:
    """A quadratic curve through three points, the middle one halfway."""
    t = np.linspace(0, 1, 25)[:, None]
    control = 2 * np.array(middle) - 0.5 * (np.array(begin) + np.array(end))
    return np.asarray(
        (1 - t) ** 2 * np.array(begin) + 2 * t * (1 - t) * control + t**2 * np.array(end)
    )


_HEAD = _oval((0.5, 0.50), (0.275, 0.365))


def _draw_head(easel: _Easel) -> None:
    easel.ellipse((0.5, 1.12), (0.44, 0.24), _SHIRT)
    easel.ellipse((0.5, 0.43), (0.325, 0.36), _HAIR)
    easel.polygon(np.array([(0.4, 0.75), (0.6, 0.75), (0.63, 0.95), (0.37, 0.95)]), _SKIN)
    easel.ellipse((0.5, 0.87), (0.09, 0.05), _SHADOW, opacity=0.6, blur=0.02)
    for side in (-1, 1):
        easel.ellipse((0.5 + side * 0.285, 0.53), (0.035, 0.065), _SKIN)
        easel.ellipse((0.5 + side * 0.287, 0.53), (0.018, 0.04), _SHADOW, opacity=0.5, blur=0.008)
    easel.polygon(_HEAD, _SKIN)


def _draw_shading(easel: _Easel, expression: _Expression) -> None:
    """The relief of a face lit from above: what the detector of real faces goes by."""
    relief = _Easel(easel.image.copy())
    for side in (-1, 1):
        relief.ellipse((0.5 + side * 0.27, 0.58), (0.05, 0.24), _SHADOW, opacity=0.45, blur=0.03)
        relief.ellipse(
            (0.5 + side * 0.125, 0.445), (0.085, 0.045), _SHADOW, opacity=0.6, blur=0.018
        )
        relief.ellipse((0.5 + side * 0.15, 0.575), (0.075, 0.05), _LIGHT, opacity=0.8, blur=0.025)
        relief.ellipse(
            (0.5 + side * 0.165, 0.61),
            (0.065, 0.045),
            (214, 96, 90),
            opacity=0.6 * expression.blush,
            blur=0.025,
        )
    relief.ellipse((0.5, 0.28), (0.19, 0.085), _LIGHT, opacity=0.8, blur=0.03)
    relief.ellipse((0.5, 0.80), (0.07, 0.035), _LIGHT, opacity=0.6, blur=0.02)
    easel.inlay(relief, _HEAD)
    easel.polygon(_fringe(), _HAIR)
    easel.stroke(_arc((0.26, 0.27), (0.5, 0.215), (0.74, 0.27)), 0.02, _SHADOW, opacity=0.35,
                 blur=0.012)  # fmt: skip


def _fringe() -> NDArray[np.float64]:
    lower = _arc((0.215, 0.40), (0.5, 0.195), (0.785, 0.40))
    upper = _arc((0.785, 0.30), (0.5, 0.07), (0.215, 0.30))
    return np.vstack([lower, upper])


def _draw_eye(easel: _Easel, expression: _Expression, side: int) -> None:
    x, y = 0.5 + side * 0.12, 0.455
    half, height = 0.056, 0.026 * expression.eye
    upper = _arc((x - half, y), (x, y - height), (x + half, y))
    lower = _arc((x + half, y), (x, y + 0.8 * height), (x - half, y))
    white = _Easel(easel.image.copy())
    opening = np.vstack([upper, lower])
    white.polygon(opening, (236, 232, 228))
    iris = min(0.027, 1.1 * height)
    white.ellipse((x, y - 0.002), (0.027, 0.027), (70, 48, 34))
    white.ellipse((x, y - 0.002), (0.013, 0.013), (12, 8, 8))
    white.ellipse((x - 0.008, y - 0.3 * iris - 0.002), (0.006, 0.006), (250, 250, 250))
    white.stroke(upper + np.array([0, 0.006]), 0.012, _SHADOW, opacity=0.5, blur=0.005)
    easel.inlay(white, opening)
    easel.stroke(upper, 0.012, (40, 24, 20))
    easel.stroke(lower, 0.005, _SHADOW, opacity=0.8)
    easel.stroke(lower + np.array([0, 0.022]), 0.006, _SHADOW, opacity=0.35, blur=0.004)


def _draw_brow(easel: _Easel, expression: _Expression, side: int) -> None:
    y = 0.385
    inner = (0.5 + side * 0.055, y + 0.8 * expression.brow_inner)
    outer = (0.5 + side * 0.19, y + 0.015 + 0.8 * expression.brow_outer)
    rise = 0.5 * (inner[1] + outer[1]) - 0.018
    path = _arc(inner, (0.5 + side * 0.125, rise), outer)
    easel.stroke(path, 0.028, _HAIR, opacity=0.95, blur=0.003)
    if expression.brow_inner > 0:
        frown = np.array([(0.5 + side * 0.018, 0.36), (0.5 + side * 0.022, 0.41)])
        easel.stroke(frown, 0.008, _SHADOW, opacity=0.7, blur=0.003)


def _draw_nose(easel: _Easel, expression: _Expression) -> None:
    easel.ellipse((0.5, 0.50), (0.018, 0.09), _LIGHT, opacity=0.9, blur=0.01)
    lift = 0.5 * expression.sneer
    for side in (-1, 1):
        bridge = np.array([(0.5 + side * 0.04, 0.43), (0.5 + side * 0.045, 0.56)])
        easel.stroke(bridge, 0.015, _SHADOW, opacity=0.4, blur=0.01)
        easel.ellipse((0.5 + side * 0.024, 0.607 - lift), (0.014, 0.008), (70, 34, 28), blur=0.003)
        wing = _arc(
            (0.5 + side * 0.045, 0.575 - lift),
            (0.5 + side * 0.055, 0.595 - lift),
            (0.5 + side * 0.042, 0.612 - lift),
        )
        easel.stroke(wing, 0.008, _SHADOW, opacity=0.7, blur=0.003)
        if expression.sneer:
            fold = np.array([(0.5 + side * 0.015, 0.475), (0.5 + side * 0.04, 0.50)])
            easel.stroke(fold, 0.007, _SHADOW, opacity=0.8, blur=0.002)
    easel.ellipse((0.5, 0.575), (0.025, 0.02), _LIGHT, opacity=0.7, blur=0.008)
    easel.ellipse((0.5, 0.628), (0.045, 0.008), _SHADOW, opacity=0.5, blur=0.008)


def _draw_mouth(easel: _Easel, expression: _Expression) -> None:
    y, half, gap = 0.70, expression.mouth_width, expression.gap
    left = (0.5 - half, y + expression.corners)
    right = (0.5 + half, y + expression.corners)
    top = _arc(left, (0.5, y - 0.5 * gap - expression.sneer), right)
    bottom = _arc(right, (0.5, y + 0.5 * gap), left)
    upper_lip = _arc(left, (0.5, y - 0.5 * gap - expression.sneer - 0.02), right)
    lower_lip = _arc(right, (0.5, y + 0.5 * gap + 0.028), left)
    easel.polygon(np.vstack([upper_lip, lower_lip]), _LIP, blur=0.002)
    easel.polygon(np.vstack([top, bottom]), (66, 22, 24))
    if gap > 0.01 and half > 0.08:
        teeth = np.vstack([top, bottom * (1, 0.35) + top[::-1] * (0, 0.65)])
        easel.polygon(teeth, (244, 240, 234))
    easel.stroke(top, 0.008, (96, 36, 36))
    easel.ellipse((0.5, y + 0.5 * gap + 0.047), (0.06, 0.01), _SHADOW, opacity=0.45, blur=0.01)
    for side in (-1, 1):
        corner = (0.5 + side * (half + 0.005), y + expression.corners)
        easel.ellipse(corner, (0.01, 0.01), _SHADOW, opacity=0.6, blur=0.006)
        if expression.corners < 0 or expression.sneer:
            fold = _arc(
                (0.5 + side * 0.065, 0.60),
                (0.5 + side * (half + 0.02), 0.65),
                (0.5 + side * (half + 0.03), 0.70),
            )
            easel.stroke(fold, 0.008, _SHADOW, opacity=0.5, blur=0.004)
