"""The pose of a tag, from the positions of its corners."""

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.perception.detections import TagPose


def pose_of(
    corners: NDArray[np.float64], frame_size: tuple[int, int], focal: float, size: float
) -> TagPose | None:
    """A tag's pose by IPPE (Collins and Bartoli 2014).

    Args:
        corners: (column, row) of the black square's top left, top right, bottom right and bottom
            left, shape (4, 2).
        frame_size: (width, height) in pixels.
        focal: the lens's focal length in pixels.
        size: the side of the black square in mm.
    """
    half = 0.5 * size
    square = np.array([(-half, half, 0), (half, half, 0), (half, -half, 0), (-half, -half, 0)])
    column, row = (0.5 * (length - 1) for length in frame_size)
    lens = np.array([(focal, 0, column), (0, focal, row), (0, 0, 1)])
    solved, rotation, place = cv2.solvePnP(
        square, corners, lens, None, flags=cv2.SOLVEPNP_IPPE_SQUARE
    )
    if not solved:
        return None
    x, y, z = place.ravel().tolist()
    return TagPose(x, y, z, *_angles(cv2.Rodrigues(rotation)[0]))


def _angles(rotation: cv2.typing.MatLike) -> tuple[float, float, float]:
    """Yaw, pitch and roll in degrees.

    The square's axes are to the right, up, and out of its face, towards the lens; those of the
    lens to the right, down, and ahead.
    """
    right, _, out = np.asarray(rotation, np.float64).T
    yaw = np.arctan2(-out[0], -out[2])
    pitch = np.arctan2(-out[1], np.hypot(out[0], out[2]))
    # The direction of the square's right side if it were not rolled.
    level = np.array([np.cos(yaw), 0.0, -np.sin(yaw)])
    roll = np.arctan2(right @ np.cross(level, out), right @ level)
    return float(np.degrees(yaw)), float(np.degrees(pitch)), float(np.degrees(roll))
