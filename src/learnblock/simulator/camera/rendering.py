"""Draws the view of a camera."""

from collections.abc import Iterable
from dataclasses import dataclass
from statistics import NormalDist

import cv2
import numpy as np

from learnblock.simulator.camera.canvas import Canvas
from learnblock.simulator.camera.facet import facets
from learnblock.simulator.camera.lens import CameraModel, CameraPose
from learnblock.simulator.camera.surface import Surface
from learnblock.simulator.camera.vectors import Colour, Image

# The midpoints of 256 equally likely intervals of the standard normal distribution.
QUANTILES = np.array([NormalDist().inv_cdf((step + 0.5) / 256) for step in range(256)])


@dataclass(frozen=True, slots=True)
class CameraView:
    """A picture about to be drawn: see `render`."""

    surfaces: tuple[Surface, ...]
    model: CameraModel
    pose: CameraPose
    noise: tuple[np.random.Generator, float] | None = None

    def picture(self) -> Image:
        """Draw it; only once, because that uses up the noise."""
        return render(self.surfaces, self.model, self.pose, noise=self.noise)


def render(
    surfaces: Iterable[Surface],
    model: CameraModel,
    pose: CameraPose,
    background: Colour = (200, 215, 230),
    noise: tuple[np.random.Generator, float] | None = None,
) -> Image:
    """The view of `surfaces` by a camera with lens `model` at `pose`.

    The same arguments give the same picture. Of surfaces in the same plane, the first one wins: put
    a poster 1 mm before its wall.

    Args:
        surfaces: the surfaces, in any order.
        model: the lens.
        pose: the pose of the lens.
        background: the RGB colour where there is no surface.
        noise: a generator and the standard deviation of the sensor's Gaussian noise, in grey
            levels; None for a perfect sensor.

    Returns:
        RGB, uint8, shape (model.height, model.width, 3).
    """
    canvas = Canvas(model, background)
    for facet in facets(tuple(surfaces), model, pose):
        for patch in facet.patches(model):
            canvas.paint(facet, patch)
    if noise is not None:
        _add_noise(canvas.image, *noise)
    return canvas.image


def _add_noise(image: Image, generator: np.random.Generator, sigma: float) -> None:
    """Gaussian noise in whole grey levels, by 256 equally likely quantiles.

    A random byte for every value is several times faster to draw than a normal deviate, and what
    the 256 steps cut off is beyond 2.9 standard deviations.
    """
    table = np.clip(np.rint(sigma * QUANTILES), -128, 127).astype(np.int8)
    draws = np.frombuffer(generator.bytes(image.size), np.uint8).reshape(image.shape)
    cv2.add(image, cv2.LUT(draws, table), image, dtype=cv2.CV_8U)
