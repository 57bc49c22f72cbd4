"""A picture drawn in layers."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

Image = NDArray[np.uint8]
Colour = tuple[int, int, int]
Point = tuple[float, float]

# Faces are drawn on a canvas of this side and scaled from there.
CANVAS = 400
# OpenCV draws at fractions of a pixel when coordinates are given in 1/2**SHIFT.
SHIFT = 6


@dataclass(frozen=True, slots=True)
class Easel:
    """A square picture drawn in layers; coordinates run from 0 to 1, right and down."""

    image: Image

    @classmethod
    def blank(cls, colour: Colour) -> "Easel":
        return cls(np.full((CANVAS, CANVAS, 3), colour, np.uint8))

    def ellipse(
        self,
        center: Point,
        axes: Point,
        colour: Colour,
        *,
        opacity: float = 1.0,
        blur: float = 0.0,
    ) -> None:
        self.polygon(oval(center, axes), colour, opacity=opacity, blur=blur)

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
        thickness = max(1, round(width * CANVAS))
        points = _on_canvas(path)
        cv2.polylines(mask, [points], False, 255, thickness, cv2.LINE_AA, SHIFT)  # noqa: FBT003 - OpenCV's own order
        self._blend(mask, colour, opacity, blur)

    def scaled(self, pixels: int) -> Image:
        method = cv2.INTER_AREA if pixels < CANVAS else cv2.INTER_CUBIC
        return np.asarray(cv2.resize(self.image, (pixels, pixels), interpolation=method), np.uint8)

    def inlay(self, other: "Easel", outline: NDArray[np.float64]) -> None:
        """Show `other` within an outline."""
        mask = np.zeros(self.image.shape[:2], np.uint8)
        cv2.fillPoly(mask, [_on_canvas(outline)], 255, cv2.LINE_AA, SHIFT)
        cover = mask[..., None] * np.float32(1 / 255)
        blended = self.image + cover * (other.image - self.image.astype(np.float32))
        self.image[:] = np.rint(blended).astype(np.uint8)

    def _blend(self, mask: Image, colour: Colour, opacity: float, blur: float) -> None:
        """Draw `colour` where `mask` is white, with soft edges for a `blur` above 0."""
        reach = round(3 * blur * CANVAS)
        left, top, width, height = cv2.boundingRect(mask)
        window = (
            slice(max(0, top - reach), top + height + reach),
            slice(max(0, left - reach), left + width + reach),
        )
        cover = mask[window].astype(np.float32) * (opacity / 255)
        if blur > 0:
            cover = np.asarray(cv2.GaussianBlur(cover, (0, 0), blur * CANVAS), np.float32)
        beneath = self.image[window].astype(np.float32)
        blended = beneath + cover[..., None] * (np.array(colour, np.float32) - beneath)
        self.image[window] = np.rint(blended).astype(np.uint8)


def _on_canvas(outline: NDArray[np.float64]) -> NDArray[np.int32]:
    return np.asarray(np.rint((outline * CANVAS - 0.5) * 2**SHIFT), np.int32)


def oval(center: Point, axes: Point) -> NDArray[np.float64]:
    angles = np.linspace(0, 2 * np.pi, 73)[:-1]
    return np.column_stack([np.cos(angles), np.sin(angles)]) * axes + center


def arc(begin: Point, middle: Point, end: Point) -> NDArray[np.float64]:
    """A quadratic curve through three points, the middle one halfway."""
    t = np.linspace(0, 1, 25)[:, None]
    control = 2 * np.array(middle) - 0.5 * (np.array(begin) + np.array(end))
    return np.asarray(
        (1 - t) ** 2 * np.array(begin) + 2 * t * (1 - t) * control + t**2 * np.array(end)
    )
