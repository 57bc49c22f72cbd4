"""The content of a world's file.

The messages about an invalid file and the tables of docs/simulator.md are made from descriptions
and bounds of the keys. Places are mm, x east and y north of the
middle of the floor; headings are degrees clockwise, 0 is east.
"""

from collections.abc import Iterable
from functools import lru_cache
from typing import TYPE_CHECKING, Annotated, Literal

from msgspec import Meta, Struct

from learnblock.simulator.colours import Colour
from learnblock.simulator.description_types import (
    HEADING,
    XY,
    Difficulty,
    Emotion,
    Group,
    Heading,
    Mass,
    Name,
    ObjectHeight,
    Place,
    Side,
    TagNumber,
    Text,
    X,
    Y,
)
from learnblock.simulator.game.description import (
    Collectable,
    Door,
    GameRules,
    Mover,
    RaceGate,
    Switch,
    Team,
    Zone,
)
from learnblock.simulator.geometry import Point, Pose, arc
from learnblock.simulator.goal_description import Goals

if TYPE_CHECKING:
    from learnblock.simulator.polyline import Polyline

#: What is around the floor when the page draws the world; robots and their cameras don't notice.
Theme = Literal["playground", "city", "space", "warehouse", "garden", "night", "maze"]

PropKind = Literal[
    "ball",
    "barrel",
    "block",
    "cone",
    "crate",
    "flowers",
    "house",
    "lamp",
    "pile",
    "planet",
    "post",
    "rocket",
    "tree",
]


class Floor(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The ground, with (0, 0) in its middle."""

    size: Annotated[
        tuple[Annotated[float, Meta(ge=200, le=10000)], Annotated[float, Meta(ge=200, le=10000)]],
        Meta(description="from west to east and from south to north, mm"),
    ] = (2000.0, 2000.0)
    colour: Annotated[Colour, Meta(description="of the ground")] = "white"
    picture: (
        Annotated[
            str,
            Meta(
                min_length=1,
                max_length=200,
                description="PNG file stretched over the ground, in the world file's folder",
            ),
        ]
        | None
    ) = None
    border: Annotated[
        Annotated[float, Meta(ge=0, le=1000)],
        Meta(description="height of the wall around the floor, mm; 0 leaves an open edge"),
    ] = 100.0
    slip: Annotated[
        float, Meta(ge=0, le=0.3, description="part of their rotation that wheels lose, on average")
    ] = 0.005


class Part(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """One part of a line's path: straight ahead, or a curve."""

    forward: Annotated[float, Meta(ge=1, le=10000, description="straight ahead, mm")] | None = None
    turn: (
        Annotated[
            float, Meta(ge=-360, le=360, description="angle of a curve, degrees, right positive")
        ]
        | None
    ) = None
    radius: Annotated[float, Meta(ge=10, le=5000, description="of the curve, mm")] | None = None

    def __post_init__(self) -> None:
        if (self.forward is None) == (self.turn is None or self.radius is None):
            raise ValueError("world-path-part")


class Line(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A line painted on the floor; later lines are painted over earlier ones."""

    name: Annotated[Name, Meta(description="used by goals")] = "line"
    colour: Annotated[Colour, Meta(description="black, red, blue or any other")] = "black"
    width: Annotated[float, Meta(ge=2, le=500, description="mm")] = 40.0
    points: Annotated[
        tuple[XY, ...],
        Meta(max_length=500, description="corners of a straight-edged line, instead of path, mm"),
    ] = ()
    start: Annotated[
        tuple[Place, Place, Heading],
        Meta(description="start of its path: x, y and heading"),
    ] = (0.0, 0.0, 0.0)
    path: Annotated[
        tuple[Part, ...], Meta(max_length=200, description="straight parts and curves, in order")
    ] = ()
    closed: Annotated[bool, Meta(description="whether it is a closed loop")] = False

    def __post_init__(self) -> None:
        if bool(self.path) == (len(self.points) >= 2):
            raise ValueError("world-line-shape")
        if len(self.polyline().points) < 2:
            raise ValueError("world-line-empty")

    def polyline(self) -> "Polyline":
        """Its middle; the same object for lines that are alike, as it remembers what is near."""
        return _middle(self)


class Wall(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A wall along a chain of points."""

    points: Annotated[
        tuple[XY, ...], Meta(min_length=2, max_length=20, description="its corners, mm")
    ]
    height: Annotated[ObjectHeight, Meta(description="mm")] = 100.0
    thickness: Annotated[float, Meta(ge=2, le=500, description="mm")] = 20.0
    colour: Annotated[Colour, Meta(description="of its sides")] = (205, 200, 185)


class Box(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A box; one with a mass can be pushed."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    heading: Annotated[Heading, HEADING] = 0.0
    length: Annotated[Side, Meta(description="along its heading, mm")] = 100.0
    width: Annotated[Side, Meta(description="across its heading, mm")] = 100.0
    height: Annotated[ObjectHeight, Meta(description="mm")] = 100.0
    mass: Annotated[Mass, Meta(description="kg; without it the box is fixed")] | None = None
    colour: Annotated[Colour, Meta(description="of its sides")] = "brown"
    name: Annotated[Name, Meta(description="for messages and events")] = "box"


class Cylinder(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A standing cylinder; one with a mass can be pushed."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    radius: Annotated[float, Meta(ge=5, le=1000, description="mm")] = 50.0
    height: Annotated[ObjectHeight, Meta(description="mm")] = 100.0
    mass: Annotated[Mass, Meta(description="kg; without it the cylinder is fixed")] | None = None
    colour: Annotated[Colour, Meta(description="of its side")] = "green"
    name: Annotated[Name, Meta(description="for messages and events")] = "cylinder"


class Tag(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """An AprilTag of family 36h11 on a square board; robots bump into the board and see it."""

    id: Annotated[TagNumber, Meta(description="the tag's number")]
    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    heading: Annotated[
        Heading, Meta(description="direction of its front, degrees clockwise; 0 is east")
    ]
    z: Annotated[float, Meta(ge=0, le=2000, description="height of its middle, mm")] = 80.0
    size: Annotated[
        float, Meta(ge=20, le=2000, description="side with its white margin, mm; 8/10 are black")
    ] = 120.0


class Face(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A drawn face that shows an emotion, on a square board."""

    emotion: Annotated[Emotion, Meta(description="the emotion it shows")]
    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    heading: Annotated[
        Heading, Meta(description="direction of its front, degrees clockwise; 0 is east")
    ]
    z: Annotated[float, Meta(ge=0, le=2000, description="height of its middle, mm")] = 110.0
    size: Annotated[float, Meta(ge=20, le=2000, description="side, mm")] = 200.0


class Lamp(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A lamp over the floor, for light sensors: its light falls off with the distance squared."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    z: Annotated[float, Meta(ge=50, le=5000, description="height, mm")] = 500.0
    brightness: Annotated[
        float, Meta(ge=0, le=1023, description="light added directly below it, of 1023")
    ] = 600.0


class Prop(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Decoration, on the floor or around it; robots and their cameras notice only a solid one."""

    kind: Annotated[PropKind, Meta(description="what it is")]
    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    heading: Annotated[Heading, HEADING] = 0.0
    scale: Annotated[float, Meta(ge=0.2, le=4, description="a factor of its usual size")] = 1.0
    solid: Annotated[bool, Meta(description="whether robots bump into it and see it")] = False


class Start(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A start pose; the first robot takes the first one, the second robot the second."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    heading: Annotated[Heading, HEADING] = 0.0
    name: Annotated[Name, Meta(description="by which a robot can select it")] = "start"


class Moved(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Objects that are elsewhere in each variant of the world."""

    name: Annotated[Name, Meta(description='of boxes or cylinders, or as in "tag 3" or "face joy"')]
    distance: Annotated[float, Meta(ge=0, le=2000, description="largest change of x and y, mm")]


class Vary(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """How variants of the world differ from it: each value is a largest difference."""

    start: Annotated[float, Meta(ge=0, le=2000, description="of x and y of a start, mm")] = 0.0
    heading: Annotated[float, Meta(ge=0, le=180, description="of a start's heading, degrees")] = 0.0
    light: Annotated[float, Meta(ge=0, le=1023, description="of the ambient light, of 1023")] = 0.0
    noise: Annotated[float, Meta(ge=0, le=10, description="of the factor sensor_noise")] = 0.0
    slip: Annotated[float, Meta(ge=0, le=0.3, description="of the floor's slip")] = 0.0
    thing: Annotated[tuple[Moved, ...], Meta(max_length=100)] = ()


class WorldFile(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The content of a world's file."""

    title: Annotated[Text, Meta(description="shown on the page")] = ""
    theme: Annotated[Theme, Meta(description="what the page draws around the floor")] = "playground"
    group: (
        Annotated[
            Group,
            Meta(description="where the page's gallery shows it; without it, by what is in it"),
        ]
        | None
    ) = None
    difficulty: Annotated[Difficulty, Meta(description="shown in the gallery")] | None = None
    ambient_light: Annotated[
        float, Meta(ge=0, le=1023, description="the light everywhere, of 1023")
    ] = 400.0
    sensor_noise: Annotated[
        float, Meta(ge=0, le=10, description="a factor of the noise of all sensors")
    ] = 1.0
    floor: Annotated[Floor, Meta(description="the ground")] = Floor()
    line: Annotated[tuple[Line, ...], Meta(max_length=50)] = ()
    wall: Annotated[tuple[Wall, ...], Meta(max_length=50)] = ()
    box: Annotated[tuple[Box, ...], Meta(max_length=100)] = ()
    cylinder: Annotated[tuple[Cylinder, ...], Meta(max_length=100)] = ()
    tag: Annotated[tuple[Tag, ...], Meta(max_length=50)] = ()
    face: Annotated[tuple[Face, ...], Meta(max_length=50)] = ()
    light: Annotated[tuple[Lamp, ...], Meta(max_length=50)] = ()
    prop: Annotated[tuple[Prop, ...], Meta(max_length=100)] = ()
    start: Annotated[tuple[Start, ...], Meta(max_length=100)] = ()
    goal: Annotated[Goals, Meta(description="the goals of robots")] = Goals()
    game: Annotated[GameRules, Meta(description="what holds for the whole game")] | None = None
    team: Annotated[tuple[Team, ...], Meta(max_length=10)] = ()
    collectable: Annotated[tuple[Collectable, ...], Meta(max_length=100)] = ()
    zone: Annotated[tuple[Zone, ...], Meta(max_length=50)] = ()
    gate: Annotated[tuple[RaceGate, ...], Meta(max_length=50)] = ()
    mover: Annotated[tuple[Mover, ...], Meta(max_length=50)] = ()
    door: Annotated[tuple[Door, ...], Meta(max_length=50)] = ()
    switch: Annotated[tuple[Switch, ...], Meta(max_length=50)] = ()
    vary: Annotated[Vary, Meta(description="how variants of the world differ")] | None = None


class WorldDescription(WorldFile, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A world's file together with its name and folder.

    Args:
        name: the file's name without its suffix.
        folder: the folder of the floor's picture.
        variant: the number of the variant; 0 is the world as it is drawn.
    """

    name: str = "world"
    folder: str = ""
    variant: int = 0

    def line_named(self, name: str) -> Line | None:
        """The line with this name; None if there is none."""
        return next((line for line in self.line if line.name == name), None)


def thing_name(thing: Box | Cylinder | Tag | Face | Start) -> str:
    """The name of an object in messages and events."""
    if isinstance(thing, Tag):
        return f"tag {thing.id}"
    return f"face {thing.emotion}" if isinstance(thing, Face) else thing.name


# Why: docs/decisions.md, "Nothing is computed twice that cannot have changed"
@lru_cache(maxsize=64)
def _middle(line: Line) -> "Polyline":
    # Imported here because a world without a line does not need numpy, which is slow to load.
    from learnblock.simulator.polyline import Polyline  # noqa: PLC0415 - see above

    if line.points:
        return Polyline.through([*line.points, *line.points[: 1 if line.closed else 0]])
    return Polyline.through(_walk(Pose(*line.start), line.path))


def _walk(start: Pose, path: Iterable[Part]) -> list[Point]:
    points, pose = [(start.x, start.y)], start
    for part in path:
        if part.forward is not None:
            pose = pose.ahead(part.forward)
            points.append((pose.x, pose.y))
        elif part.turn and part.radius:
            points += arc(pose, part.turn, part.radius)
            pose = pose.along_arc(part.turn, part.radius)
    return points
