"""A projective camera: planar quads with textures in, an RGB picture out.

World coordinates are mm: x east, y north, z up. Headings and pitches are degrees: a heading grows
clockwise seen from above, so forward is (cos h, -sin h), and a pitch above zero looks up. Pixel
(0, 0) is the top left one; integer pixel coordinates are pixel centres, and the optical axis meets
the picture in its middle, at ((width - 1) / 2, (height - 1) / 2).

On a plane 1/z is affine in pixel coordinates, so the depth test is exact for every pixel; the
texture comes through the plane's homography, from that level of its mip chain whose texels are
about a pixel large there.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from statistics import NormalDist

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.errors import LearnBlockError

Image = NDArray[np.uint8]
Colour = tuple[int, int, int]
Point = tuple[float, float]
Vector = tuple[float, float, float]

# Nothing nearer to the lens than this many mm is drawn.
NEAR = 1.0
# Pixels whose centre lies on an edge belong to both neighbours, so that no crack opens between.
EDGE_SLACK = 1e-3
# How much finer than a pixel, in powers of two, the texels are chosen: sharp tags before smooth.
SHARPNESS = 0.25
# A pixel takes up to so many samples a side (a power of two), so many texels apart.
MOST_SAMPLES = 4
SPACING = 2.5
# One minus the cosine by which the normals at a quad's corners may differ.
FLATNESS = 1e-6
# Towards a light in the south-west above; scaled so that a floor keeps its colours as they are.
LIGHT = (-0.35, -0.2, 1.0)
AMBIENT = 0.82
# Of the standard normal distribution: the middles of 256 equally likely steps.
QUANTILES = np.array([NormalDist().inv_cdf((step + 0.5) / 256) for step in range(256)])


class CameraError(LearnBlockError, ValueError):
    """A surface or a camera that cannot be drawn."""


@dataclass(frozen=True, slots=True)
class CameraModel:
    """The lens: a pinhole without distortion.

    Args:
        width: columns of the picture.
        height: rows of the picture.
        focal: the focal length in pixels; half of the width seen at 45 degrees is one focal.
    """

    width: int
    height: int
    focal: float

    def __post_init__(self) -> None:
        for name in ("width", "height", "focal"):
            if not getattr(self, name) > 0:
                raise CameraError(f"camera {name} is {getattr(self, name)}; it must be above 0")


@dataclass(frozen=True, slots=True)
class CameraPose:
    """Where the lens is (mm) and where it looks (degrees; right and up are positive)."""

    x: float
    y: float
    z: float
    heading: float = 0.0
    pitch: float = 0.0

    @property
    def axes(self) -> NDArray[np.float64]:
        """Rows are the directions right, down and forward in the world: a rotation matrix."""
        heading, pitch = math.radians(self.heading), math.radians(self.pitch)
        cos_h, sin_h = math.cos(heading), math.sin(heading)
        cos_p, sin_p = math.cos(pitch), math.sin(pitch)
        return np.array(
            [
                (-sin_h, -cos_h, 0.0),
                (sin_p * cos_h, -sin_p * sin_h, -cos_p),
                (cos_p * cos_h, -cos_p * sin_h, sin_p),
            ]
        )


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """A flat convex quad with a picture on its front.

    Args:
        corners: shape (4, 3), world mm: top left, top right, bottom right and bottom left as seen
            from the front.
        texture: RGB, uint8, shape (height, width, 3). It fills the parallelogram that the top left,
            top right and bottom left corners span; where the fourth corner lies elsewhere the quad
            cuts the picture, or repeats its last pixels.
        name: for messages.
        two_sided: the back shows the front's picture mirrored; otherwise the back is not drawn.

    Raises:
        CameraError: the corners are no flat convex quad, or the texture is no RGB image.
    """

    corners: NDArray[np.float64]
    texture: Image
    name: str = ""
    two_sided: bool = True
    _levels: dict[int, Image] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        _check_corners(self)
        _check_texture(self)
        self._levels.setdefault(0, self.texture)

    def moved(self, corners: NDArray[np.float64]) -> "Surface":
        """The same surface elsewhere; it shares the mip chain, which is what is dear about one."""
        return Surface(corners, self.texture, self.name, self.two_sided, self._levels)

    @property
    def last_level(self) -> int:
        """The level of the mip chain that is a single pixel in its longer direction."""
        return int(max(self.texture.shape[:2]).bit_length()) - 1

    def level(self, number: int) -> Image:
        """The texture at 1/2**number of its size, made when first asked for."""
        if number not in self._levels:
            finer = self.level(number - 1)
            height, width = (max(1, size // 2) for size in finer.shape[:2])
            # Bound to the one array even if two threads make it at once.
            self._levels.setdefault(number, _shrunk(finer, width, height))
        return self._levels[number]


@dataclass(frozen=True, slots=True)
class View:
    """A picture about to be drawn: see `render`."""

    surfaces: tuple[Surface, ...]
    model: CameraModel
    pose: CameraPose
    noise: tuple[np.random.Generator, float] | None = None

    def picture(self) -> Image:
        """Draw it, once: the noise is used up by it."""
        return render(self.surfaces, self.model, self.pose, noise=self.noise)


def render(
    surfaces: Iterable[Surface],
    model: CameraModel,
    pose: CameraPose,
    background: Colour = (200, 215, 230),
    noise: tuple[np.random.Generator, float] | None = None,
) -> Image:
    """What a camera with lens `model` at `pose` sees of `surfaces`.

    The same arguments give the same picture. Of surfaces in the same plane the first one wins: put
    a poster 1 mm before its wall.

    Args:
        surfaces: in any order.
        model: the lens.
        pose: where it is.
        background: RGB where there is no surface.
        noise: a generator and the standard deviation of the sensor's Gaussian noise, in grey
            levels; None for a perfect sensor.

    Returns:
        RGB, uint8, shape (model.height, model.width, 3).
    """
    canvas = _Canvas.blank(model, background)
    for facet in _facets(tuple(surfaces), model, pose):
        for patch in facet.patches(model):
            canvas.paint(facet, patch)
    if noise is not None:
        _add_noise(canvas.image, *noise)
    return canvas.image


def _check_corners(surface: Surface) -> None:
    corners = np.asarray(surface.corners, dtype=np.float64)
    if corners.shape != (4, 3) or not np.isfinite(corners).all():
        raise CameraError(
            f"surface `{surface.name}` has corners {surface.corners!r}; "
            "expected four points of finite x, y, z in mm"
        )
    object.__setattr__(surface, "corners", corners)
    if not _is_flat_and_convex(corners.tolist()):
        raise CameraError(
            f"surface `{surface.name}` has corners {corners.tolist()}; expected a flat convex "
            "quad: top left, top right, bottom right, bottom left"
        )


def _is_flat_and_convex(points: Sequence[Vector]) -> bool:
    """Whether the sides turn at every corner, and about the same direction."""
    sides = [_minus(points[(i + 1) % 4], points[i]) for i in range(4)]
    turns = [_cross(sides[i - 1], sides[i]) for i in range(4)]
    sizes = [math.hypot(*turn) for turn in turns]
    if min(sizes) == 0:
        return False
    return all(
        _dot(turns[0], turn) > (1 - FLATNESS) * sizes[0] * size
        for turn, size in zip(turns, sizes, strict=True)
    )


def _check_texture(surface: Surface) -> None:
    texture = surface.texture
    if texture.dtype != np.uint8 or texture.ndim != 3 or texture.shape[2] != 3 or not texture.size:
        raise CameraError(
            f"surface `{surface.name}` has a texture of {texture.dtype} and shape {texture.shape}; "
            "expected RGB uint8 of shape (height, width, 3)"
        )


def _shrunk(texture: Image, width: int, height: int) -> Image:
    return np.asarray(cv2.resize(texture, (width, height), interpolation=cv2.INTER_AREA), np.uint8)


@dataclass(frozen=True, slots=True)
class _Patch:
    """A part of a facet whose pixels cover about equally many texels.

    Args:
        outline: convex, in pixels, clockwise as the picture is looked at.
        depths: its least and its greatest z.
    """

    outline: Sequence[Point]
    depths: tuple[float, float]


@dataclass(frozen=True, slots=True)
class _Facet:
    """A surface as one camera sees it: x right, y down, z forward, in mm.

    With `side` and `down` the texture's two edges from the corner `origin` and r the ray of a
    pixel at z = 1, Cramer's rule gives 1/z = (side x down) . r / det, and the place in the texture
    as ((down x origin) . r, (origin x side) . r) / det * z.
    """

    surface: Surface
    corners: Sequence[Vector]
    pixel_to_texture: tuple[Vector, Vector, Vector]
    texels_per_pixel: float
    shade: float
    is_front: bool

    def patches(self, model: CameraModel) -> Iterator[_Patch]:
        """Cut by depth wherever a pixel covers four times as many texels as before."""
        depths = [z for _, _, z in self.corners]
        nearest, farthest = max(NEAR, min(depths)), max(depths)
        first, last = self._octave(nearest), self._octave(farthest)
        for octave in range(first, last + 1):
            begin = nearest if octave == first else self._depth(octave)
            end = farthest if octave == last else self._depth(octave + 1)
            corners = _cut(self.corners, begin, end)
            if len(corners) >= 3:
                outline = _projected(corners, model, clockwise=self.is_front)
                yield _Patch(outline, (begin, end))

    def _octave(self, depth: float) -> int:
        fineness = math.floor(0.5 * math.log2(self.texels_per_pixel * depth**3))
        return min(max(0, fineness), self.surface.last_level)

    def _depth(self, octave: int) -> float:
        return float((4.0**octave / self.texels_per_pixel) ** (1 / 3))


def _facets(surfaces: Sequence[Surface], model: CameraModel, pose: CameraPose) -> Iterator[_Facet]:
    """Those surfaces that are before the camera, within its picture and face it."""
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
) -> _Facet | None:
    """None where it shows nothing: seen edge-on, or a back that is not to be drawn."""
    origin = corners[0]
    side, down = _minus(corners[1], origin), _minus(corners[3], origin)
    # In camera coordinates it points away from who stands before the surface.
    normal = _cross(side, down)
    determinant = _dot(normal, origin)
    size = math.hypot(*normal)
    if abs(determinant) < 1e-6 * size or (determinant < 0 and not surface.two_sided):
        return None
    rays = (_cross(down, origin), _cross(origin, side), normal)
    height, width = surface.texture.shape[:2]
    is_front = determinant > 0
    return _Facet(
        surface,
        corners,
        _over_pixels(rays, determinant, model),
        width * height / (abs(determinant) * model.focal**2),
        _shade(-_dot(normal, light) / size * (1 if is_front else -1)),
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
    """1 for a floor, less the more a surface turns away, never so dark that a tag is lost."""
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
    """In pixels, clockwise as the picture is looked at."""
    column, row, focal = 0.5 * (model.width - 1), 0.5 * (model.height - 1), model.focal
    points = [(column + focal * x / z, row + focal * y / z) for x, y, z in corners]
    return points if clockwise else points[::-1]


def _minus(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@dataclass(frozen=True, slots=True)
class _Window:
    """Columns left..right and rows top..bottom of the picture; the last ones are not in it."""

    left: int
    top: int
    right: int
    bottom: int

    @classmethod
    def around(cls, outline: Sequence[Point], width: int, height: int) -> "_Window":
        xs, ys = [x for x, _ in outline], [y for _, y in outline]
        return cls(
            max(0, math.ceil(min(xs) - EDGE_SLACK)),
            max(0, math.ceil(min(ys) - EDGE_SLACK)),
            min(width, math.floor(max(xs) + EDGE_SLACK) + 1),
            min(height, math.floor(max(ys) + EDGE_SLACK) + 1),
        )

    @property
    def is_empty(self) -> bool:
        return self.left >= self.right or self.top >= self.bottom

    @property
    def slices(self) -> tuple[slice, slice]:
        return slice(self.top, self.bottom), slice(self.left, self.right)

    def shift(self, plane: Vector) -> Vector:
        """An affine function of the picture's pixels as one of the window's."""
        a, b, c = plane
        return a, b, c + a * self.left + b * self.top


@dataclass(frozen=True, slots=True)
class _Canvas:
    """The picture so far and, for every pixel, 1/z of what is nearest (0 for the background)."""

    image: Image
    nearness: NDArray[np.float32]
    columns: NDArray[np.float32]
    rows: NDArray[np.float32]

    @classmethod
    def blank(cls, model: CameraModel, background: Colour) -> "_Canvas":
        image = np.empty((model.height, model.width, 3), np.uint8)
        cv2.rectangle(image, (0, 0), (model.width, model.height), background, cv2.FILLED)
        return cls(
            image,
            np.zeros((model.height, model.width), np.float32),
            np.arange(model.width, dtype=np.float32)[None, :],
            np.arange(model.height, dtype=np.float32)[:, None],
        )

    def paint(self, facet: _Facet, patch: _Patch) -> None:
        """Draw `patch` where it is nearer than what is there."""
        window = _Window.around(patch.outline, self.image.shape[1], self.image.shape[0])
        if window.is_empty:
            return
        nearness = self._affine(window, facet.pixel_to_texture[2])
        visible = nearness > self.nearness[window.slices]
        for edge in _edges(patch.outline, window):
            visible &= self._affine(window, edge) >= 0
        mask = visible.view(np.uint8)
        if cv2.hasNonZero(mask):
            cv2.copyTo(_texels(facet, patch, window), mask, self.image[window.slices])
            cv2.copyTo(nearness, mask, self.nearness[window.slices])

    def _affine(self, window: _Window, plane: Vector) -> NDArray[np.float32]:
        """The affine function a * column + b * row + c over the window's pixels."""
        a, b, c = window.shift(plane)
        columns = self.columns[:, : window.right - window.left] * np.float32(a)
        rows = self.rows[: window.bottom - window.top] * np.float32(b) + np.float32(c)
        return columns + rows


def _edges(outline: Sequence[Point], window: _Window) -> Iterator[Vector]:
    """For each side of the outline that crosses the window, its distance to a pixel as an affine
    function, at least zero inside.
    """
    for (x, y), (next_x, next_y) in zip(outline, (*outline[1:], outline[0]), strict=True):
        length = math.hypot(next_x - x, next_y - y)
        if length == 0:
            continue
        a, b = (y - next_y) / length, (next_x - x) / length
        edge = (a, b, EDGE_SLACK - a * x - b * y)
        if not _is_nowhere_negative(edge, window):
            yield edge


def _is_nowhere_negative(plane: Vector, window: _Window) -> bool:
    a, b, c = plane
    column = window.left if a > 0 else window.right - 1
    row = window.top if b > 0 else window.bottom - 1
    return a * column + b * row + c >= 0


def _texels(facet: _Facet, patch: _Patch, window: _Window) -> Image:
    """The shaded texture over all of the window."""
    size = (window.right - window.left, window.bottom - window.top)
    if facet.surface.last_level == 0:
        return _plain(size, facet.surface.texture[0, 0] * facet.shade)
    seen = _warped(facet, _sampling(facet, patch, window), window, size)
    if facet.shade < 1:
        cv2.convertScaleAbs(seen, seen, facet.shade)
    return np.asarray(seen, np.uint8)


@dataclass(frozen=True, slots=True)
class _Sampling:
    """From which level of the mip chain, and how many samples of it for the columns and the rows
    of a pixel: a floor seen flat along covers many texels one way and few the other.
    """

    level: int
    columns: int
    rows: int

    def over_samples(self, plane: Vector) -> Vector:
        """An affine function of pixels as one of samples, which lie evenly about pixel centres."""
        a, b, c = plane[0] / self.columns, plane[1] / self.rows, plane[2]
        return a, b, c + 0.5 * (a - plane[0]) + 0.5 * (b - plane[1])


def _sampling(facet: _Facet, patch: _Patch, window: _Window) -> _Sampling:
    right, down = _footprint(facet, patch, window)
    narrow, wide = min(right, down), max(right, down)
    fineness = math.log2(max(narrow, wide / (MOST_SAMPLES * SPACING), 1e-9)) - SHARPNESS
    level = min(max(0, math.floor(fineness + 0.5)), facet.surface.last_level)

    def samples(footprint: float) -> int:
        texels = footprint / 2**level / SPACING
        return 1 if texels <= 1 else 2 if texels <= 2 else MOST_SAMPLES

    return _Sampling(level, samples(right), samples(down))


def _footprint(facet: _Facet, patch: _Patch, window: _Window) -> tuple[float, float]:
    """How many texels of the full texture one pixel to the right, and one down, leads on."""
    column, row = 0.5 * (window.left + window.right - 1), 0.5 * (window.top + window.bottom - 1)
    across, along, nearness = facet.pixel_to_texture
    # The window's middle may lie beside the patch, but the patch knows what it can be at most.
    inverse = _clamped(_at(nearness, column, row), 1 / patch.depths[1], 1 / patch.depths[0])
    s, t = (_clamped(_at(plane, column, row) / inverse, 0, 1) for plane in (across, along))
    height, width = facet.surface.texture.shape[:2]
    right, down = (
        math.hypot(
            width * (across[i] - s * nearness[i]) / inverse,
            height * (along[i] - t * nearness[i]) / inverse,
        )
        for i in (0, 1)
    )
    return right, down


def _at(plane: Vector, column: float, row: float) -> float:
    return plane[0] * column + plane[1] * row + plane[2]


def _clamped(value: float, low: float, high: float) -> float:
    return min(max(value, low), high)


def _warped(
    facet: _Facet, sampling: _Sampling, window: _Window, size: tuple[int, int]
) -> cv2.typing.MatLike:
    texture = facet.surface.level(sampling.level)
    height, width = texture.shape[:2]
    across, along, nearness = (
        sampling.over_samples(window.shift(plane)) for plane in facet.pixel_to_texture
    )
    # A texel's centre is half a texel from its edge, as everywhere in OpenCV.
    homography = np.array(
        [
            [width * s - 0.5 * w for s, w in zip(across, nearness, strict=True)],
            [height * t - 0.5 * w for t, w in zip(along, nearness, strict=True)],
            nearness,
        ]
    )
    finer = (size[0] * sampling.columns, size[1] * sampling.rows)
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    samples = cv2.warpPerspective(
        texture, homography, finer, flags=flags, borderMode=cv2.BORDER_REPLICATE
    )
    return _averaged(samples, sampling.columns, sampling.rows)


def _averaged(samples: cv2.typing.MatLike, columns: int, rows: int) -> cv2.typing.MatLike:
    """One pixel for each block of samples: 1, 2 or 4 columns by 1, 2 or 4 rows."""
    while columns > 1 or rows > 1:
        across, along = min(columns, 2), min(rows, 2)
        size = (samples.shape[1] // across, samples.shape[0] // along)
        # At half the size linear interpolation is the mean, and quicker than asking for the mean.
        samples = cv2.resize(samples, size, interpolation=cv2.INTER_LINEAR)
        columns, rows = columns // across, rows // along
    return samples


def _plain(size: tuple[int, int], colour: NDArray[np.float64]) -> Image:
    image = np.empty((size[1], size[0], 3), np.uint8)
    cv2.rectangle(image, (0, 0), size, np.rint(colour).tolist(), cv2.FILLED)
    return image


def _add_noise(image: Image, generator: np.random.Generator, sigma: float) -> None:
    """Gaussian noise in whole grey levels, by 256 equally likely quantiles.

    A random byte for every value is several times faster to draw than a normal deviate, and what
    the 256 steps cut off lies beyond 2.9 standard deviations.
    """
    table = np.clip(np.rint(sigma * QUANTILES), -128, 127).astype(np.int8)
    draws = np.frombuffer(generator.bytes(image.size), np.uint8).reshape(image.shape)
    cv2.add(image, cv2.LUT(draws, table), image, dtype=cv2.CV_8U)
