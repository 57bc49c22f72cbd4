"""A flat surface with a picture on it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.camera.mip_chain import MipChain
from learnblock.simulator.camera.vectors import Image, Vector, cross, dot, minus

# One minus the cosine by which the normals at a quad's corners may differ.
FLATNESS = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """A flat convex quad with a picture on its front.

    Args:
        corners: shape (4, 3), world mm: top left, top right, bottom right and bottom left as seen
            from the front.
        texture: RGB, uint8, shape (height, width, 3). It fills the parallelogram that the top left,
            top right and bottom left corners span; if the fourth corner is elsewhere, the quad
            cuts the picture, or repeats its last pixels.
        name: the name in messages.
        two_sided: whether the back shows the front's picture mirrored; otherwise it is not drawn.

    Raises:
        ValueError: the corners are not a flat convex quad, or the texture is not an RGB image.
    """

    corners: NDArray[np.float64]
    texture: Image
    name: str = ""
    two_sided: bool = True
    mips: MipChain = field(init=False, repr=False)

    def __post_init__(self) -> None:
        _check_corners(self)
        _check_texture(self)
        object.__setattr__(self, "mips", MipChain(self.texture))

    @classmethod
    def showing(
        cls,
        mips: MipChain,
        corners: NDArray[np.float64],
        name: str = "",
        *,
        two_sided: bool = True,
    ) -> "Surface":
        """A surface with a texture that others show, too: the mip chain is slow to compute."""
        surface = cls(corners, mips.level(0), name, two_sided)
        object.__setattr__(surface, "mips", mips)
        return surface

    def moved(self, corners: NDArray[np.float64]) -> "Surface":
        """The same surface elsewhere."""
        return Surface.showing(self.mips, corners, self.name, two_sided=self.two_sided)


def _check_corners(surface: Surface) -> None:
    corners = np.asarray(surface.corners, dtype=np.float64)
    if corners.shape != (4, 3) or not np.isfinite(corners).all():
        raise ValueError(
            f"surface `{surface.name}` has corners {surface.corners!r}; "
            "expected four points of finite x, y, z in mm"
        )
    object.__setattr__(surface, "corners", corners)
    if not _is_flat_and_convex(corners.tolist()):
        raise ValueError(
            f"surface `{surface.name}` has corners {corners.tolist()}; expected a flat convex "
            "quad: top left, top right, bottom right, bottom left"
        )


def _is_flat_and_convex(points: Sequence[Vector]) -> bool:
    """Whether the sides turn at every corner, always in the same direction."""
    sides = [minus(points[(i + 1) % 4], points[i]) for i in range(4)]
    turns = [cross(sides[i - 1], sides[i]) for i in range(4)]
    sizes = [math.hypot(*turn) for turn in turns]
    if min(sizes) == 0:
        return False
    return all(
        dot(turns[0], turn) > (1 - FLATNESS) * sizes[0] * size
        for turn, size in zip(turns, sizes, strict=True)
    )


def _check_texture(surface: Surface) -> None:
    texture = surface.texture
    if texture.dtype != np.uint8 or texture.ndim != 3 or texture.shape[2] != 3 or not texture.size:
        raise ValueError(
            f"surface `{surface.name}` has a texture of {texture.dtype} and shape {texture.shape}; "
            "expected RGB uint8 of shape (height, width, 3)"
        )
