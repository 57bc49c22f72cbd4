"""Write one of our worlds as a scene for Aseba's playground.

The scene uses cm from the south-western corner and radians counterclockwise, and always has a wall
around its floor. Tags, faces and lamps are left out, because a Thymio cannot see them.
"""

import math
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree as Xml

from learnblock.simulator import WorldDescription
from learnblock.simulator.colours import RGB, rgb
from learnblock.simulator.floor import Floor
from learnblock.simulator.geometry import Pose
from learnblock.simulator.world_description import Box, Cylinder, Wall

SCENE, GROUND = "scene.playground", "ground.png"
MM_PER_CM = 10
GRAMS_PER_KG = 1000
_BORDER: RGB = (215, 212, 200)


def write_scene(world: WorldDescription, folder: Path, port: int, start: Pose) -> Path:
    """Write a world with one Thymio in it.

    Args:
        world: the world.
        folder: the folder for its files.
        port: the robot's port.
        start: the robot's start.

    Returns:
        The file of the scene.
    """
    (folder / GROUND).write_bytes(_ground(world))
    scene = Xml.Element("aseba-playground")
    scene.extend(_elements(world, port, start))
    file = folder / SCENE
    file.write_bytes(b"<!DOCTYPE aseba-playground>\n" + Xml.tostring(scene))
    return file


def place(world: WorldDescription, pose: Pose) -> tuple[float, float, float]:
    """Convert a LearnBlock pose to the playground's x and y in cm and its angle in radians."""
    width, depth = world.floor.size
    x, y = (pose.x + width / 2) / MM_PER_CM, (pose.y + depth / 2) / MM_PER_CM
    return x, y, -math.radians(pose.heading)


def pose(world: WorldDescription, x: float, y: float, angle: float) -> Pose:
    """Convert the playground's x and y in cm and angle in radians to a LearnBlock pose."""
    width, depth = world.floor.size
    east, north = x * MM_PER_CM - width / 2, y * MM_PER_CM - depth / 2
    return Pose(east, north, -math.degrees(angle))


def _ground(world: WorldDescription) -> bytes:
    import cv2  # noqa: PLC0415 - not needed to list the emulators

    _, data = cv2.imencode(".png", cv2.cvtColor(Floor(world).image, cv2.COLOR_RGB2BGR))
    return data.tobytes()


def _elements(world: WorldDescription, port: int, start: Pose) -> Iterator[Xml.Element]:
    boxes = [*_walls(world), *world.box]
    things: list[Box | Cylinder] = [*boxes, *world.cylinder]
    colours = {_colour(thing): rgb(thing.colour) for thing in things}
    for name, parts in {"border": _BORDER, **colours}.items():
        red, green, blue = (part / 255 for part in parts)
        yield _element("color", name=name, r=red, g=green, b=blue)
    yield _world(world)
    for box in boxes:
        yield _box(world, box)
    for cylinder in world.cylinder:
        yield _cylinder(world, cylinder)
    x, y, angle = place(world, start)
    yield _element("robot", type="thymio2", name="Thymio", port=port, x=x, y=y, angle=angle)


def _world(world: WorldDescription) -> Xml.Element:
    width, depth = (side / MM_PER_CM for side in world.floor.size)
    return _element("world", w=width, h=depth, color="border", groundTexture=GROUND)


def _walls(world: WorldDescription) -> Iterator[Box]:
    """Each straight piece of a wall as a box; the boxes overlap at corners, as in our world."""
    for wall in world.wall:
        for begin, end in pairwise(wall.points):
            yield _piece(wall, begin, end)


def _piece(wall: Wall, begin: tuple[float, float], end: tuple[float, float]) -> Box:
    (x, y), (end_x, end_y) = begin, end
    return Box(
        x=(x + end_x) / 2,
        y=(y + end_y) / 2,
        heading=-math.degrees(math.atan2(end_y - y, end_x - x)),
        length=math.hypot(end_x - x, end_y - y) + wall.thickness,
        width=wall.thickness,
        height=wall.height,
        colour=wall.colour,
    )


def _box(world: WorldDescription, box: Box) -> Xml.Element:
    x, y, angle = place(world, Pose(box.x, box.y, box.heading))
    length, width = box.length / MM_PER_CM, box.width / MM_PER_CM
    return _element("wall", x=x, y=y, angle=angle, l1=length, l2=width, **_upright(box))


def _cylinder(world: WorldDescription, cylinder: Cylinder) -> Xml.Element:
    x, y, _ = place(world, Pose(cylinder.x, cylinder.y, 0.0))
    return _element("cylinder", x=x, y=y, r=cylinder.radius / MM_PER_CM, **_upright(cylinder))


def _upright(thing: Box | Cylinder) -> dict[str, float | str]:
    """The height, the colour, and the mass in g, which is -1 for a fixed object."""
    mass = -1 if thing.mass is None else thing.mass * GRAMS_PER_KG
    return {"h": thing.height / MM_PER_CM, "color": _colour(thing), "mass": mass}


def _colour(thing: Box | Cylinder) -> str:
    return "-".join(map(str, rgb(thing.colour)))


def _element(kind: str, **attributes: float | str) -> Xml.Element:
    return Xml.Element(kind, {name: str(value) for name, value in attributes.items()})
