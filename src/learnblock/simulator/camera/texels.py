"""The texture of a facet, sampled for the pixels of a window."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from learnblock.simulator.camera.facet import Facet, Patch
from learnblock.simulator.camera.vectors import Image, Vector
from learnblock.simulator.camera.window import Window

# Texels are finer than a pixel by this power of two, so that tags are sharp rather than smooth.
SHARPNESS = 0.25
# The maximum number of samples per side of a pixel (a power of two), and the texels between them.
MOST_SAMPLES = 4
SPACING = 2.5
# The texels beside a sample that may have a part in it, and more.
AROUND = 3


def texels(facet: Facet, patch: Patch, window: Window) -> Image:
    """The shaded texture over the whole window."""
    size = (window.right - window.left, window.bottom - window.top)
    mips = facet.surface.mips
    if mips.is_plain:
        return _plain(size, _shaded(mips.level(mips.last), facet.shade))
    seen = _shaded(_warped(facet, _sampling(facet, patch, window), window, size), facet.shade)
    return _coloured(seen) if seen.ndim == 2 else seen


@dataclass(frozen=True, slots=True)
class Sampling:
    """The level of the mip chain, and the number of samples of it for the columns and the rows
    of a pixel: a floor seen at a flat angle covers many texels one way and few the other.
    """

    level: int
    columns: int
    rows: int

    def over_samples(self, plane: Vector) -> Vector:
        """An affine function of pixels as one of samples, evenly spaced around pixel centres."""
        a, b, c = plane[0] / self.columns, plane[1] / self.rows, plane[2]
        return a, b, c + 0.5 * (a - plane[0]) + 0.5 * (b - plane[1])


def _sampling(facet: Facet, patch: Patch, window: Window) -> Sampling:
    right, down = _footprint(facet, patch, window)
    narrow, wide = min(right, down), max(right, down)
    fineness = math.log2(max(narrow, wide / (MOST_SAMPLES * SPACING), 1e-9)) - SHARPNESS
    level = min(max(0, math.floor(fineness + 0.5)), facet.surface.mips.last)

    def samples(footprint: float) -> int:
        texels = footprint / 2**level / SPACING
        return 1 if texels <= 1 else 2 if texels <= 2 else MOST_SAMPLES

    return Sampling(level, samples(right), samples(down))


def _footprint(facet: Facet, patch: Patch, window: Window) -> tuple[float, float]:
    """The texels of the full texture that one pixel to the right, and one pixel down, covers."""
    column, row = 0.5 * (window.left + window.right - 1), 0.5 * (window.top + window.bottom - 1)
    across, along, nearness = facet.pixel_to_texture
    # The middle of the window may be outside the patch, whose depths limit the value.
    inverse = clamped(_at(nearness, column, row), 1 / patch.depths[1], 1 / patch.depths[0])
    s, t = (clamped(_at(plane, column, row) / inverse, 0, 1) for plane in (across, along))
    height, width = facet.surface.texture.shape[:2]
    right, down = (
        math.hypot(
            width * (across[i] - s * nearness[i]) / inverse,
            height * (along[i] - t * nearness[i]) / inverse,
        )
        for i in (0, 1)
    )
    return right, down


def _at(plane: Sequence[float], column: float, row: float) -> float:
    return plane[0] * column + plane[1] * row + plane[2]


def clamped(value: float, low: float, high: float) -> float:
    return min(max(value, low), high)


def _warped(
    facet: Facet, sampling: Sampling, window: Window, size: tuple[int, int]
) -> cv2.typing.MatLike:
    height, width = facet.surface.mips.level(sampling.level).shape[:2]
    across, along, nearness = (
        sampling.over_samples(window.shift(plane)) for plane in facet.pixel_to_texture
    )
    # A texel's centre is half a texel from its edge, as always in OpenCV.
    homography = np.array(
        [
            [width * s - 0.5 * w for s, w in zip(across, nearness, strict=True)],
            [height * t - 0.5 * w for t, w in zip(along, nearness, strict=True)],
            nearness,
        ]
    )
    finer = (size[0] * sampling.columns, size[1] * sampling.rows)
    region = _region(homography.tolist(), finer, (width, height))
    texture = facet.surface.mips.samples(sampling.level, region)
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    samples = cv2.warpPerspective(
        texture, homography, finer, flags=flags, borderMode=cv2.BORDER_REPLICATE
    )
    return _averaged(samples, sampling.columns, sampling.rows)


def _region(
    homography: Sequence[Sequence[float]], size: tuple[int, int], texture: tuple[int, int]
) -> Window:
    """The texels from which a picture is sampled, and some around them.

    Args:
        homography: from samples to texels.
        size: the columns and rows of samples.
        texture: the columns and rows of texels; what is beside them repeats the nearest.
    """
    across, along, nearness = homography
    right, bottom = size[0] - 1, size[1] - 1
    corners = [(0, 0), (right, 0), (right, bottom), (0, bottom)]
    scales = [_at(nearness, *corner) for corner in corners]
    if min(scales) <= 0:
        # Beyond the horizon, what is seen is not between what is seen in the corners.
        return Window(0, 0, *texture)
    limits = []
    for plane, count in ((across, texture[0]), (along, texture[1])):
        places = [
            _at(plane, *corner) / scale for corner, scale in zip(corners, scales, strict=True)
        ]
        low, high = (clamped(place, 0, count - 1) for place in (min(places), max(places)))
        limits.append((int(low) - AROUND, int(high) + 1 + AROUND))
    (left, right), (top, bottom) = limits
    return Window(left, top, right, bottom)


def _averaged(samples: cv2.typing.MatLike, columns: int, rows: int) -> cv2.typing.MatLike:
    """One pixel for each block of samples: 1, 2 or 4 columns by 1, 2 or 4 rows."""
    while columns > 1 or rows > 1:
        across, along = min(columns, 2), min(rows, 2)
        size = (samples.shape[1] // across, samples.shape[0] // along)
        # At half the size, linear interpolation equals the mean and is faster than computing it.
        samples = cv2.resize(samples, size, interpolation=cv2.INTER_LINEAR)
        columns, rows = columns // across, rows // along
    return samples


def _shaded(seen: cv2.typing.MatLike, shade: float) -> Image:
    return np.asarray(cv2.convertScaleAbs(seen, alpha=shade) if shade < 1 else seen, np.uint8)


def _coloured(seen: Image) -> Image:
    return np.asarray(cv2.cvtColor(seen, cv2.COLOR_GRAY2RGB), np.uint8)


def _plain(size: tuple[int, int], pixel: Image) -> Image:
    image = np.empty((size[1], size[0], 3), np.uint8)
    cv2.rectangle(image, (0, 0), size, pixel[0, 0].tolist(), cv2.FILLED)
    return image
