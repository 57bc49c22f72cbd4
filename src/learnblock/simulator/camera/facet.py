"""Surfaces as seen by one camera, cut into patches of about equal detail."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from learnblock.simulator.camera.lens import CameraModel, CameraPose
from learnblock.simulator.camera.surface import Surface
from learnblock.simulator.camera.vectors import Point, Vector, cross, dot, minus
from learnblock.simulator.camera.window import Window, bounds

# Nothing nearer to the lens than this many mm is drawn.
NEAR = 1.0
# Points to a light above in the south-west; scaled so that a floor keeps its colours.
LIGHT = (-0.35, -0.2, 1.0)
AMBIENT = 0.82
# Patches that are this many pixels beside the picture are not drawn.
BESIDE = 16
# The share by which a depth may be wrong, and much more.
ROUNDING = 1e-6


@dataclass(frozen=True, slots=True)
class Patch:
    """A part of a facet whose pixels cover about the same number of texels.

    Args:
        outline: convex, in pixels, clockwise in the picture.
        depths: its minimum and maximum z.
    """

    outline: Sequence[Point]
    depths: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Facet:
    """A surface as seen by one camera: x right, y down, z forward, in mm.

    With `side` and `down` the texture's two edges from the corner `origin` and r the ray of a
    pixel at z = 1, Cramer's rule gives 1/z = (side x down) . r / det, and the texture position
    as ((down x origin) . r, (origin x side) . r) / det * z.
    """

    surface: Surface
    corners: Sequence[Vector]
    pixel_to_texture: tuple[Vector, Vector, Vector]
    texels_per_pixel: float
    shade: float
    is_front: bool

    def patches(self, model: CameraModel) -> Iterator[Patch]:
        """Cut the facet by depth wherever a pixel covers four times as many texels."""
        depths = [z for _, _, z in self.corners]
        nearest, farthest = max(NEAR, min(depths)), max(depths)
        seen = self._seen_depths(model)
        first, last = self._octave(nearest), self._octave(farthest)
        for octave in range(first, last + 1):
            begin = nearest if octave == first else self._depth(octave)
            end = farthest if octave == last else self._depth(octave + 1)
            if end < seen[0] or begin > seen[1]:
                continue
            corners = _cut(self.corners, begin, end)
            if len(corners) >= 3:
                outline = _projected(corners, model, clockwise=self.is_front)
                yield Patch(outline, (begin, end))

    def _seen_depths(self, model: CameraModel) -> tuple[float, float]:
        """Between which depths it may be in the picture, and a little beside it."""
        picture = Window(-BESIDE, -BESIDE, model.width + BESIDE, model.height + BESIDE)
        farthest, nearest = bounds(self.pixel_to_texture[2], picture)
        return (
            (1 - ROUNDING) / nearest if nearest > 0 else math.inf,
            (1 + ROUNDING) / farthest if farthest > 0 else math.inf,
        )

    def _octave(self, depth: float) -> int:
        fineness = math.floor(0.5 * math.log2(self.texels_per_pixel * depth**3))
        return min(max(0, fineness), self.surface.mips.last)

    def _depth(self, octave: int) -> float:
        return float((4.0**octave / self.texels_per_pixel) ** (1 / 3))


def facets(surfaces: Sequence[Surface], model: CameraModel, pose: CameraPose) -> Iterator[Facet]:
    """The surfaces that are in front of the camera, within its picture, and that face it."""
    if not surfaces:
        return
    axes = pose.axes
    corners = np.stack([surface.corners for surface in surfaces]) - (pose.x, pose.y, pose.z)
    light = tuple((axes @ LIGHT).tolist())
    for surface, seen in zip(surfaces, (corners @ axes.T).tolist(), strict=True):
        if _is_within_picture(seen, model):
            facet = _facet(surface, seen, model, light)
            if facet is not None:
                yield facet


def _is_within_picture(corners: Sequence[Vector], model: CameraModel) -> bool:
    right, down = 0.5 * model.width / model.focal, 0.5 * model.height / model.focal
    return (
        any(z > NEAR for _, _, z in corners)
        and any(x < right * z for x, _, z in corners)
        and any(-x < right * z for x, _, z in corners)
        and any(y < down * z for _, y, z in corners)
        and any(-y < down * z for _, y, z in corners)
    )


def _facet(
    surface: Surface, corners: Sequence[Vector], model: CameraModel, light: Vector
) -> Facet | None:
    """None if nothing is visible: it is seen edge-on, or from a back that is not drawn."""
    origin = corners[0]
    side, down = minus(corners[1], origin), minus(corners[3], origin)
    # In camera coordinates it points away from a camera in front of the surface.
    normal = cross(side, down)
    determinant = dot(normal, origin)
    size = math.hypot(*normal)
    if abs(determinant) < 1e-6 * size or (determinant < 0 and not surface.two_sided):
        return None
    rays = (cross(down, origin), cross(origin, side), normal)
    height, width = surface.texture.shape[:2]
    is_front = determinant > 0
    return Facet(
        surface,
        corners,
        _over_pixels(rays, determinant, model),
        width * height / (abs(determinant) * model.focal**2),
        _shade(-dot(normal, light) / size * (1 if is_front else -1)),
        is_front,
    )


def _over_pixels(
    rays: tuple[Vector, Vector, Vector], determinant: float, model: CameraModel
) -> tuple[Vector, Vector, Vector]:
    """Functionals of a ray as affine functions of (column, row, 1)."""
    column, row = 0.5 * (model.width - 1), 0.5 * (model.height - 1)

    def over_pixels(ray: Vector) -> Vector:
        a, b = (ray[i] / (determinant * model.focal) for i in (0, 1))
        return a, b, ray[2] / determinant - a * column - b * row

    return over_pixels(rays[0]), over_pixels(rays[1]), over_pixels(rays[2])


def _shade(towards_light: float) -> float:
    """The brightness: 1 for a floor, less for surfaces turned away, but enough to see tags."""
    return min(1.0, AMBIENT + (1 - AMBIENT) * towards_light)


def _cut(corners: Sequence[Vector], begin: float, end: float) -> Sequence[Vector]:
    """The part of a convex polygon with begin <= z <= end (Sutherland and Hodgman 1974)."""
    if all(begin <= z <= end for _, _, z in corners):
        return corners
    return _clip(_clip(corners, begin, 1.0), -end, -1.0)


def _clip(corners: Sequence[Vector], limit: float, sign: float) -> list[Vector]:
    """The part of a convex polygon with sign * z >= limit."""
    kept: list[Vector] = []
    for a, b in zip(corners, (*corners[1:], *corners[:1]), strict=True):
        inside_a, inside_b = sign * a[2] >= limit, sign * b[2] >= limit
        if inside_a:
            kept.append(a)
        if inside_a != inside_b:
            kept.append(_between(a, b, (limit - sign * a[2]) / (sign * (b[2] - a[2]))))
    return kept


def _between(a: Vector, b: Vector, part: float) -> Vector:
    return (a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2]))


def _projected(
    corners: Sequence[Vector], model: CameraModel, *, clockwise: bool
) -> Sequence[Point]:
    """The outline in pixels, clockwise in the picture."""
    column, row, focal = 0.5 * (model.width - 1), 0.5 * (model.height - 1), model.focal
    points = [(column + focal * x / z, row + focal * y / z) for x, y, z in corners]
    return points if clockwise else points[::-1]
