"""The bodies of props: what robots bump into and see where a prop is solid.

The page has their sizes from here: the plan draws them, and a prop in space is as wide.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from types import MappingProxyType

from learnblock.simulator.colours import Colour
from learnblock.simulator.world_description import Box, Cylinder, Prop, PropKind


@dataclass(frozen=True, slots=True)
class _Shape:
    """The measures of a prop of usual size, in mm.

    Args:
        size: length and width of a box, or the radius of a cylinder.
        height: the height.
        colour: of most of it.
    """

    size: tuple[float, float] | float
    height: float
    colour: Colour


_SHAPES: MappingProxyType[PropKind, _Shape] = MappingProxyType(
    {
        "ball": _Shape(70, 140, (240, 82, 156)),
        "barrel": _Shape(65, 160, (47, 123, 255)),
        "block": _Shape((130, 130), 130, (130, 87, 230)),
        "cone": _Shape((96, 96), 132, "orange"),
        "crate": _Shape((158, 158), 150, (217, 165, 102)),
        "flowers": _Shape(80, 110, "green"),
        "house": _Shape((216, 216), 220, (229, 143, 101)),
        "lamp": _Shape(30, 386, "grey"),
        "pile": _Shape((290, 140), 262, "red"),
        "planet": _Shape(110, 370, (255, 159, 90)),
        "post": _Shape((84, 84), 247, (239, 234, 255)),
        "rocket": _Shape(87, 357, "white"),
        "tree": _Shape(60, 290, "green"),
    }
)


#: Length and width, or the radius, of a prop of usual size, in mm.
SIZES: MappingProxyType[PropKind, tuple[float, float] | float] = MappingProxyType(
    {kind: shape.size for kind, shape in _SHAPES.items()}
)


def solid_props(props: Iterable[Prop]) -> Iterator[Box | Cylinder]:
    """The bodies of the solid ones, in order."""
    return (body_of(prop) for prop in props if prop.solid)


def body_of(prop: Prop) -> Box | Cylinder:
    """The fixed box or cylinder that a prop would be if it were solid."""
    shape, scale = _SHAPES[prop.kind], prop.scale
    height = shape.height * scale
    if isinstance(shape.size, tuple):
        length, width = shape.size
        return Box(
            x=prop.x,
            y=prop.y,
            heading=prop.heading,
            length=length * scale,
            width=width * scale,
            height=height,
            colour=shape.colour,
            name=prop.kind,
        )
    return Cylinder(
        x=prop.x,
        y=prop.y,
        radius=shape.size * scale,
        height=height,
        colour=shape.colour,
        name=prop.kind,
    )
