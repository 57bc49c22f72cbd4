"""The picture so far, and its depth."""

from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.camera.facet import Facet, Patch
from learnblock.simulator.camera.lens import CameraModel
from learnblock.simulator.camera.texels import texels
from learnblock.simulator.camera.vectors import Colour, Image, Vector
from learnblock.simulator.camera.window import Window, edges


@dataclass(frozen=True, slots=True)
class Canvas:
    """The picture so far and 1/z of the nearest surface at every pixel (0 for the background)."""

    image: Image
    nearness: NDArray[np.float32]
    columns: NDArray[np.float32]
    rows: NDArray[np.float32]

    @classmethod
    def blank(cls, model: CameraModel, background: Colour) -> "Canvas":
        return cls(
            _plain(model.width, model.height, background).copy(),
            np.zeros((model.height, model.width), np.float32),
            np.arange(model.width, dtype=np.float32)[None, :],
            np.arange(model.height, dtype=np.float32)[:, None],
        )

    def paint(self, facet: Facet, patch: Patch) -> None:
        """Draw `patch` at the pixels where it is nearer than the picture so far."""
        window = Window.around(patch.outline, self.image.shape[1], self.image.shape[0])
        if window.is_empty:
            return
        nearness = self._affine(window, facet.pixel_to_texture[2])
        visible = nearness > self.nearness[window.slices]
        for edge in edges(patch.outline, window):
            visible &= self._affine(window, edge) >= 0
        mask = visible.view(np.uint8)
        count = cv2.countNonZero(mask)
        if count == mask.size:
            # As below, without the mask.
            self.image[window.slices] = texels(facet, patch, window)
            self.nearness[window.slices] = nearness
        elif count:
            cv2.copyTo(texels(facet, patch, window), mask, self.image[window.slices])
            cv2.copyTo(nearness, mask, self.nearness[window.slices])

    def _affine(self, window: Window, plane: Vector) -> NDArray[np.float32]:
        """The affine function a * column + b * row + c over the window's pixels."""
        a, b, c = window.shift(plane)
        columns = self.columns[:, : window.right - window.left] * np.float32(a)
        rows = self.rows[: window.bottom - window.top] * np.float32(b) + np.float32(c)
        return columns + rows


# Every frame of a camera begins with the same one; a copy takes a fifth of the time.
@lru_cache(maxsize=16)
def _plain(width: int, height: int, colour: Colour) -> Image:
    image = np.empty((height, width, 3), np.uint8)
    cv2.rectangle(image, (0, 0), (width, height), colour, cv2.FILLED)
    return image
