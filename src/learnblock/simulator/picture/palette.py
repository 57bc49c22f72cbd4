"""The colours of the page and the colours of time."""

from types import MappingProxyType

import numpy as np

from learnblock.simulator.colours import RGB

PAPER: RGB = (253, 252, 249)
WHITE: RGB = (255, 255, 255)
BLACK: RGB = (0, 0, 0)
INK: RGB = (45, 48, 56)
PALE: RGB = (110, 114, 124)
GREEN: RGB = (30, 142, 84)
RED: RGB = (200, 48, 48)
# The page and what is written on it, for readers with a dark theme.
NIGHT = MappingProxyType({PAPER: (24, 27, 34), INK: (232, 234, 240), PALE: (164, 170, 184)})
# Goals as in the page's world: orange until they are reached, with golden stars.
ORANGE: RGB = (240, 140, 0)
STAR: RGB = (255, 201, 51)
STAR_EDGE: RGB = (154, 98, 0)

# Matplotlib's perceptually even map "plasma" (public domain, CC0) at 0/9, 1/9, ... 7/9: its
# yellow end is left out, because it is invisible on a white floor.
_PLASMA = (
    (13, 8, 135),
    (70, 3, 159),
    (114, 1, 168),
    (156, 23, 158),
    (189, 55, 134),
    (216, 87, 107),
    (237, 121, 83),
    (251, 159, 58),
)


def time_colour(part: float) -> RGB:
    """The colour of a time, from 0 for the path's start to 1 for its end."""
    place = part * (len(_PLASMA) - 1)
    stops = range(len(_PLASMA))
    red, green, blue = (
        round(float(np.interp(place, stops, levels))) for levels in zip(*_PLASMA, strict=True)
    )
    return red, green, blue


def is_dark(colour: RGB) -> bool:
    """Whether white is easier to read on it than black."""
    return sum(colour) < 330
