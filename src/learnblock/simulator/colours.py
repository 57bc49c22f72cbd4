"""The colours that worlds and robots may name."""

from types import MappingProxyType
from typing import Annotated, Literal

from msgspec import Meta

RGB = tuple[int, int, int]
"""Red, green and blue, 0 to 255."""

ColourName = Literal[
    "white", "black", "grey", "red", "green", "blue", "yellow", "orange", "brown", "purple"
]
Level = Annotated[int, Meta(ge=0, le=255)]
Colour = ColourName | tuple[Level, Level, Level]
"""A name, or [red, green, blue]."""

# Black, red and blue are well within the thresholds of the line detector.
_NAMED: MappingProxyType[str, RGB] = MappingProxyType(
    {
        "white": (240, 240, 240),
        "black": (20, 20, 20),
        "grey": (150, 150, 150),
        "red": (215, 25, 25),
        "green": (40, 150, 60),
        "blue": (25, 70, 215),
        "yellow": (240, 205, 40),
        "orange": (240, 135, 30),
        "brown": (140, 95, 60),
        "purple": (130, 60, 160),
    }
)


def rgb(colour: Colour) -> RGB:
    """Its red, green and blue."""
    return _NAMED[colour] if isinstance(colour, str) else colour


def reflectance(colour: tuple[float, float, float]) -> float:
    """The reading of a ground sensor, 0 (black) to 100 (white): the luma of ITU-R BT.601."""
    red, green, blue = colour
    return (0.299 * red + 0.587 * green + 0.114 * blue) / 2.55
