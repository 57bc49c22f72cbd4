"""The picture so far, and its depth."""

from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.camera.facet import Facet, Patch
from learnblock.simulator.camera.lens import CameraModel
from learnblock.simulator.camera.texels import texels
from learnblock.simulator.camera.vectors import Colour, Image, Vector
from learnblock.simulator.camera.window import Window, bounds, edges

# The share of an affine function's terms by which single precision may be wrong, and much more.
ROUNDING = 1e-5


class Canvas:
    """The picture so far and 1/z of the nearest surface at every pixel (0 for the background).

    Often one surface fills the picture first, such as a floor on which the camera looks down. Then
    its plane says how near it is, and no pixel's depth is computed until another surface may be
    nearer.

    Args:
        model: the lens.
        background: the colour where there is no surface.
    """

    def __init__(self, model: CameraModel, background: Colour) -> None:
        self._whole = Window(0, 0, model.width, model.height)
        self._background = background
        self._image: Image | None = None
        self._nearness: NDArray[np.float32] | None = None
        #: The 1/z of the surface that fills the picture, as a function of pixels.
        self._filling: Vector | None = None

    @property
    def image(self) -> Image:
        if self._image is None:
            width, height = self._whole.right, self._whole.bottom
            self._image = _plain(width, height, self._background).copy()
        return self._image

    def paint(self, facet: Facet, patch: Patch) -> None:
        """Draw `patch` at the pixels where it is nearer than the picture so far."""
        window = Window.around(patch.outline, self._whole.right, self._whole.bottom)
        if window.is_empty:
            return
        plane = facet.pixel_to_texture[2]
        if self._filling and _is_behind(plane, self._filling, window):
            return
        sides = [*edges(patch.outline, window)]
        if self._image is None and not sides and window == self._whole and _is_ahead(plane, window):
            self._image, self._filling = texels(facet, patch, window), plane
        else:
            self._paint_where_nearest(facet, patch, window, sides)

    def _paint_where_nearest(
        self, facet: Facet, patch: Patch, window: Window, sides: list[Vector]
    ) -> None:
        image, nearest = self.image[window.slices], self._depth()[window.slices]
        nearness = _affine(window, facet.pixel_to_texture[2])
        visible = nearness > nearest
        for edge in sides:
            visible &= _affine(window, edge) >= 0
        mask = visible.view(np.uint8)
        count = cv2.countNonZero(mask)
        if count == mask.size:
            # As below, without the mask.
            image[:] = texels(facet, patch, window)
            nearest[:] = nearness
        elif count:
            cv2.copyTo(texels(facet, patch, window), mask, image)
            cv2.copyTo(nearness, mask, nearest)

    def _depth(self) -> NDArray[np.float32]:
        """1/z at every pixel so far."""
        if self._nearness is None:
            shape = (self._whole.bottom, self._whole.right)
            filling = self._filling
            self._nearness = (
                _affine(self._whole, filling) if filling else np.zeros(shape, np.float32)
            )
        return self._nearness


def _is_behind(plane: Vector, other: Vector, window: Window) -> bool:
    """Whether a plane is behind another one at all pixels of a window, however that is rounded."""
    a, b, c = (own - their for own, their in zip(plane, other, strict=True))
    return bounds((a, b, c), window)[1] < -ROUNDING * (_size(plane, window) + _size(other, window))


def _is_ahead(plane: Vector, window: Window) -> bool:
    """Whether a plane is in front of the camera at all pixels of a window."""
    return bounds(plane, window)[0] > ROUNDING * _size(plane, window)


def _size(plane: Vector, window: Window) -> float:
    """At least the size of each sum in which the plane's value at a pixel is computed."""
    a, b, c = plane
    return abs(a) * window.right + abs(b) * window.bottom + abs(c)


def _affine(window: Window, plane: Vector) -> NDArray[np.float32]:
    """The affine function a * column + b * row + c over the window's pixels."""
    a, b, c = window.shift(plane)
    columns = _numbers(window.right - window.left)[None, :] * np.float32(a)
    rows = _numbers(window.bottom - window.top)[:, None] * np.float32(b) + np.float32(c)
    return columns + rows


@lru_cache(maxsize=1024)
def _numbers(count: int) -> NDArray[np.float32]:
    return np.arange(count, dtype=np.float32)


# Every frame of a camera begins with the same one; a copy takes a fifth of the time.
@lru_cache(maxsize=16)
def _plain(width: int, height: int, colour: Colour) -> Image:
    image = np.empty((height, width, 3), np.uint8)
    cv2.rectangle(image, (0, 0), (width, height), colour, cv2.FILLED)
    return image
