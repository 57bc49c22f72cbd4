"""Ways driven, thinned so that a class's fit into one page."""

from collections.abc import Sequence

import cv2
import numpy as np

#: The mm by which thinning may move a way.
TOLERANCE = 6.0
#: The most points of a way.
MOST = 300


def thinned(path: Sequence[tuple[float, float]]) -> tuple[tuple[int, int], ...]:
    """The points of a way that matter, in whole mm."""
    if len(path) < 2:
        return tuple((round(x), round(y)) for x, y in path)
    points = np.array(path, np.float32)[:, None]
    corners = np.asarray(cv2.approxPolyDP(points, TOLERANCE, closed=False)).reshape(-1, 2)
    if len(corners) > MOST:
        corners = corners[np.linspace(0, len(corners) - 1, MOST).round().astype(int)]
    return tuple((round(x), round(y)) for x, y in corners.tolist())
