"""The lens of a camera, and its pose."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class CameraModel:
    """The lens: a pinhole without distortion.

    Args:
        width: columns of the picture.
        height: rows of the picture.
        focal: the focal length in pixels, which is also the offset at 45 degrees from the axis.
    """

    width: int
    height: int
    focal: float

    def __post_init__(self) -> None:
        for name in ("width", "height", "focal"):
            if not getattr(self, name) > 0:
                raise ValueError(f"camera {name} is {getattr(self, name)}; it must be above 0")


@dataclass(frozen=True, slots=True)
class CameraPose:
    """The position of the lens (mm) and its direction (degrees; right and up are positive)."""

    x: float
    y: float
    z: float
    heading: float = 0.0
    pitch: float = 0.0

    @property
    def axes(self) -> NDArray[np.float64]:
        """The rotation matrix, whose rows are right, down and forward in the world."""
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
