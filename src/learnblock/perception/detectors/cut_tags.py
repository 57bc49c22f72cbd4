"""Tags that the edge of the frame cuts: their number can't be read, but they are no line.

A tag is a dark square with light cells inside, and what the frame's edge leaves of it has straight,
dark sides and light inside, or is a dark strip along the edge. A line has neither.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

Mask = cv2.typing.MatLike

# The frame is searched with about this many rows, in whose pixels all lengths here are.
ROWS = 120
# The distance of something cut from the edge: a tag so near can't be read either.
EDGE = 2
# The share of light pixels inside: cells that are cut leave less than a whole tag has.
LIGHT = (0.12, 0.55)
# The most corners, with this tolerance; a square that is cut has six at most.
CORNERS = 6
TOLERANCE = 1.2
# The share of the sides that is dark.
DARK_SIDES = 0.9
# The shortest side along an edge that has room for cells.
SHORTEST = 15
# A part with only one light area is at most this many times as deep as it is long: two lines that
# meet are often deeper.
DEEPEST = 1.3
# A strip is this many times as long as it is deep, or no deeper than this; most of its length is
# at the edge.
STRIP = 5
DEEPEST_TIP = 8
CONTACT = 0.7
# The smallest light area, as a share of the part's box.
LIGHT_AREA = 0.01

_AROUND = np.ones((3, 3), np.uint8)
# Light areas that are narrower are steps of a slanted side.
_NARROW = np.ones((2, 2), np.uint8)


def cut_tags(brightest: Mask, darkest: int) -> Iterator[NDArray[np.float64]]:
    """Find tags that are cut by an edge of the frame.

    Args:
        brightest: the brightest channel of each pixel of the frame.
        darkest: the highest value of a dark pixel there.

    Returns:
        The outline of each, in pixels of the frame.
    """
    step = max(1, round(brightest.shape[0] / ROWS))
    searched = np.ascontiguousarray(brightest[::step, ::step])
    dark = cv2.threshold(searched, darkest, 1, cv2.THRESH_BINARY_INV)[1]
    height, width = dark.shape
    for contour in cv2.findContours(dark, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]:
        x, y, columns, rows = cv2.boundingRect(contour)
        edges = _Edges(x <= EDGE, y <= EDGE, x + columns >= width - EDGE, y + rows >= height - EDGE)
        if edges.count == 0 or max(rows, columns) <= EDGE:
            continue
        outline = cv2.convexHull(contour - np.array((x, y)))
        if _is_tag(dark[y : y + rows, x : x + columns], outline, edges):
            yield step * (outline.reshape(-1, 2) + np.array((x + 0.5, y + 0.5)))


@dataclass(frozen=True, slots=True)
class _Edges:
    """The edges of the frame that cut a part."""

    left: bool
    top: bool
    right: bool
    bottom: bool

    @property
    def count(self) -> int:
        return self.left + self.top + self.right + self.bottom

    def within(self, shape: tuple[int, ...]) -> tuple[slice, slice]:
        """The rows and columns that are not at these edges."""
        height, width = shape
        return (
            slice(EDGE * self.top, height - EDGE * self.bottom),
            slice(EDGE * self.left, width - EDGE * self.right),
        )


def _is_tag(dark: Mask, outline: Mask, edges: _Edges) -> bool:
    """Whether a part is of a tag.

    Args:
        dark: the mask of its box, 1 where it is dark.
        outline: its convex outline, in pixels of the box.
        edges: those that it reaches.
    """
    inside, light = _areas(dark, outline)
    if light < LIGHT[0]:
        return _is_strip(cv2.bitwise_and(dark, inside), edges)
    if edges.count == 2 and edges.top:
        outline = _with_corner(outline, dark.shape, edges)
        inside, light = _areas(dark, outline)
    corners = cv2.approxPolyDP(outline, TOLERANCE, closed=True)
    return (
        light <= LIGHT[1]
        and len(corners) <= CORNERS
        and _is_long(dark.shape, edges)
        and _has_dark_sides(dark, inside, edges)
        and (_has_areas(dark, inside) or _is_corner_of_square(corners, dark.shape, edges))
    )


def _areas(dark: Mask, outline: Mask) -> tuple[Mask, float]:
    """The mask of what is within an outline, and the share of it that is light."""
    inside = cv2.fillConvexPoly(np.zeros_like(dark), outline, 1)
    return inside, cv2.countNonZero(_light(dark, inside)) / cv2.countNonZero(inside)


def _light(dark: Mask, inside: Mask) -> Mask:
    return cv2.morphologyEx(cv2.subtract(inside, dark), cv2.MORPH_OPEN, _NARROW)


def _is_strip(dark: Mask, edges: _Edges) -> bool:
    """Whether a part without light is along an edge.

    Not along the lower edge, where lines are nearest and so wide that their ends look like that.
    """
    if edges.count != 1 or edges.bottom:
        return False
    # Turned so that the edge is a column.
    along = dark.T if edges.top else dark
    length, depth = along.shape
    edge = along[:, -EDGE:] if edges.right else along[:, :EDGE]
    is_tip = depth <= DEEPEST_TIP and not edges.top
    shortest = depth if is_tip else STRIP * depth
    contact = int(np.count_nonzero(edge.any(axis=1)))
    return bool(length >= shortest and contact >= CONTACT * length)


def _with_corner(outline: Mask, shape: tuple[int, ...], edges: _Edges) -> Mask:
    """The outline of a part in an upper corner of the frame, which cuts a light cell there."""
    if not edges.left and not edges.right:
        return outline
    corner = np.array([[[(shape[1] - 1) * edges.right, 0]]], outline.dtype)
    return cv2.convexHull(np.vstack([outline, corner]))


def _is_long(shape: tuple[int, ...], edges: _Edges) -> bool:
    """Whether a part has room for cells at the edge that cuts it."""
    height, _ = shape
    return max(shape) >= SHORTEST if edges.top or edges.bottom else height >= SHORTEST


def _has_dark_sides(dark: Mask, inside: Mask, edges: _Edges) -> bool:
    """Whether its sides in sight are dark."""
    within = edges.within(dark.shape)
    inner = cv2.erode(inside, _AROUND, borderType=cv2.BORDER_CONSTANT, borderValue=0)
    sides = cv2.subtract(inside, inner)[within]
    count = cv2.countNonZero(sides)
    dark_sides = cv2.countNonZero(cv2.bitwise_and(sides, cv2.dilate(dark, _AROUND)[within]))
    return 0 < DARK_SIDES * count <= dark_sides


def _has_areas(dark: Mask, inside: Mask) -> bool:
    """Whether there are several light areas, as only cells make them."""
    _, _, measures, _ = cv2.connectedComponentsWithStats(_light(dark, inside), connectivity=4)
    smallest = max(4, LIGHT_AREA * inside.size)
    return int(np.count_nonzero(measures[1:, cv2.CC_STAT_AREA] >= smallest)) > 1


def _is_corner_of_square(corners: Mask, shape: tuple[int, ...], edges: _Edges) -> bool:
    """Whether two corners are in sight, and the part is not deep."""
    rows, columns = edges.within(shape)
    in_sight = [
        rows.start <= y < rows.stop and columns.start <= x < columns.stop
        for x, y in corners.reshape(-1, 2).tolist()
    ]
    height, width = shape
    depth = width / height if edges.left or edges.right else height / width
    return sum(in_sight) > 1 and edges.count == 1 and depth <= DEEPEST
