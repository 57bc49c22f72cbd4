"""The look of the themes of worlds: the colours in which the page draws them too.

The page's are in frontend/src/views/world/scenery/palette.ts and colours.ts.
"""

from dataclasses import dataclass
from types import MappingProxyType

from learnblock.simulator.colours import RGB, Colour, ColourName, rgb
from learnblock.simulator.world_description import Theme, Wall

_DEFAULT_WALL = rgb(Wall(points=((0, 0), (1, 0))).colour)
_SHADED = 0.92
"""The brightness of every second square of a floor with a colour of its own."""


@dataclass(frozen=True, slots=True)
class ThemeColours:
    """The colours that a world's file leaves to its theme.

    Args:
        squares: of the floor.
        rim: of the wall around it, or of its edge.
        walls: of walls without a colour of their own, in turn.
    """

    squares: tuple[RGB, RGB]
    rim: RGB
    walls: tuple[RGB, ...]

    def floor(self, colour: Colour) -> tuple[RGB, RGB]:
        """The squares of a floor; a white one is left to the theme."""
        if colour == "white":
            return self.squares
        red, green, blue = own = shown(colour)
        return own, (round(_SHADED * red), round(_SHADED * green), round(_SHADED * blue))

    def wall(self, colour: Colour, index: int) -> RGB:
        """The colour of a wall, the world's `index`th."""
        is_plain = rgb(colour) == _DEFAULT_WALL
        return self.walls[index % len(self.walls)] if is_plain else shown(colour)


def look_of(theme: Theme) -> ThemeColours:
    """The colours of a theme; a dark floor is lighter than on the page, since paths are dark."""
    return _LOOKS[theme]


def shown(colour: Colour) -> RGB:
    """A colour as it is drawn: a named one in the page's shade."""
    return _FRIENDLY[colour] if isinstance(colour, str) else colour


_FRIENDLY: MappingProxyType[ColourName, RGB] = MappingProxyType(
    {
        "white": (248, 249, 252),
        "black": (23, 28, 43),
        "grey": (163, 173, 191),
        "red": (239, 68, 68),
        "green": (47, 174, 91),
        "blue": (47, 123, 255),
        "yellow": (255, 201, 51),
        "orange": (255, 138, 31),
        "brown": (184, 121, 63),
        "purple": (130, 87, 230),
    }
)

_WALLS = ((130, 87, 230), (109, 124, 255), (56, 163, 255), (18, 165, 148))
_MOONLIT = ((148, 158, 210), (138, 148, 202))

_LOOKS: MappingProxyType[Theme, ThemeColours] = MappingProxyType(
    {
        "playground": ThemeColours(((253, 246, 230), (245, 236, 216)), (79, 107, 237), _WALLS),
        "city": ThemeColours(
            ((236, 239, 244), (226, 230, 238)),
            (71, 85, 105),
            ((100, 116, 139), (37, 99, 235), (15, 118, 110), (180, 83, 9)),
        ),
        "space": ThemeColours(_MOONLIT, (180, 140, 255), _WALLS),
        "warehouse": ThemeColours(
            ((238, 235, 228), (229, 225, 216)),
            (240, 162, 2),
            ((232, 135, 30), (201, 152, 47), (95, 113, 135), (160, 100, 60)),
        ),
        "garden": ThemeColours(
            ((240, 247, 227), (228, 239, 211)),
            (169, 113, 58),
            ((176, 121, 62), (107, 179, 74), (143, 98, 52), (47, 143, 131)),
        ),
        "night": ThemeColours(_MOONLIT, (124, 140, 255), _WALLS),
        "maze": ThemeColours(((250, 246, 255), (240, 234, 251)), (124, 92, 224), _WALLS),
    }
)
