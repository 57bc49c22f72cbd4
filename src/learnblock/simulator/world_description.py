"""The content of a world's file.

The messages about an invalid file and the tables of docs/simulator.md are made from descriptions
and bounds of the keys. Places are mm, x east and y north of the
middle of the floor; headings are degrees clockwise, 0 is east.
"""

from collections.abc import Iterable
from typing import Annotated, Literal, get_args

from msgspec import Meta, Struct

from learnblock.simulator.colours import Colour
from learnblock.simulator.geometry import Point, Polyline, Pose, arc

Place = Annotated[float, Meta(ge=-5000, le=5000)]
XY = tuple[Place, Place]
Heading = Annotated[float, Meta(ge=-360, le=360)]
Side = Annotated[float, Meta(ge=5, le=2000)]
ObjectHeight = Annotated[float, Meta(ge=1, le=1000)]
Mass = Annotated[float, Meta(ge=0.01, le=50)]
Text = Annotated[str, Meta(max_length=200)]
Name = Annotated[str, Meta(min_length=1, max_length=40)]
Seconds = Annotated[float, Meta(ge=0.1, le=3600)]
TagNumber = Annotated[int, Meta(ge=0, le=586)]
Emotion = Literal["fear", "surprise", "anger", "sadness", "disgust", "joy", "neutral"]
EMOTIONS: tuple[str, ...] = get_args(Emotion)

_X = Meta(description="position to the east, mm")
_Y = Meta(description="position to the north, mm")
_HEADING = Meta(description="degrees clockwise; 0 is east")


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

    def polyline(self) -> Polyline:
        """Its middle."""
        if self.points:
            return Polyline.through([*self.points, *self.points[: 1 if self.closed else 0]])
        return Polyline.through(_walk(Pose(*self.start), self.path))


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

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    heading: Annotated[Heading, _HEADING] = 0.0
    length: Annotated[Side, Meta(description="along its heading, mm")] = 100.0
    width: Annotated[Side, Meta(description="across its heading, mm")] = 100.0
    height: Annotated[ObjectHeight, Meta(description="mm")] = 100.0
    mass: Annotated[Mass, Meta(description="kg; without it the box is fixed")] | None = None
    colour: Annotated[Colour, Meta(description="of its sides")] = "brown"
    name: Annotated[Name, Meta(description="for messages and events")] = "box"


class Cylinder(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A standing cylinder; one with a mass can be pushed."""

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    radius: Annotated[float, Meta(ge=5, le=1000, description="mm")] = 50.0
    height: Annotated[ObjectHeight, Meta(description="mm")] = 100.0
    mass: Annotated[Mass, Meta(description="kg; without it the cylinder is fixed")] | None = None
    colour: Annotated[Colour, Meta(description="of its side")] = "green"
    name: Annotated[Name, Meta(description="for messages and events")] = "cylinder"


class Tag(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """An AprilTag of family 36h11 on a square board; robots bump into the board and see it."""

    id: Annotated[TagNumber, Meta(description="the tag's number")]
    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
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
    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    heading: Annotated[
        Heading, Meta(description="direction of its front, degrees clockwise; 0 is east")
    ]
    z: Annotated[float, Meta(ge=0, le=2000, description="height of its middle, mm")] = 110.0
    size: Annotated[float, Meta(ge=20, le=2000, description="side, mm")] = 200.0


class Lamp(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A lamp over the floor, for light sensors: its light falls off with the distance squared."""

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    z: Annotated[float, Meta(ge=50, le=5000, description="height, mm")] = 500.0
    brightness: Annotated[
        float, Meta(ge=0, le=1023, description="light added directly below it, of 1023")
    ] = 600.0


class Start(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A start pose; the first robot takes the first one, the second robot the second."""

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    heading: Annotated[Heading, _HEADING] = 0.0
    name: Annotated[Name, Meta(description="by which a robot can select it")] = "start"


class Reach(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Bring a robot's middle into a round region."""

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    radius: Annotated[float, Meta(ge=10, le=5000, description="of the region, mm")] = 150.0
    name: Annotated[Name, Meta(description="shown on the page")] = "reach"
    robot: (
        Annotated[Name, Meta(description="the name of the robot; without it any robot")] | None
    ) = None
    time_limit: (
        Annotated[Seconds, Meta(description="seconds; after that the goal has failed")] | None
    ) = None


class Follow(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Drive along a line."""

    line: Annotated[Name, Meta(description="the line's name")] = "line"
    fraction: Annotated[
        float, Meta(ge=0.01, le=1, description="how much of the line; 1 is all of it, one lap")
    ] = 1.0
    distance: Annotated[
        float,
        Meta(ge=5, le=1000, description="largest distance of a robot's middle from the line, mm"),
    ] = 100.0
    name: Annotated[Name, Meta(description="shown on the page")] = "follow"
    robot: (
        Annotated[Name, Meta(description="the name of the robot; without it any robot")] | None
    ) = None
    time_limit: (
        Annotated[Seconds, Meta(description="seconds; after that the goal has failed")] | None
    ) = None


class Visit(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Come close to the front of a tag and face it."""

    id: Annotated[TagNumber, Meta(description="the tag's number")]
    distance: Annotated[
        float,
        Meta(ge=10, le=5000, description="largest distance from the robot's middle to the tag, mm"),
    ] = 350.0
    angle: Annotated[
        float, Meta(ge=1, le=180, description="largest angle off the robot's heading, degrees")
    ] = 25.0
    name: Annotated[Name, Meta(description="shown on the page")] = "visit"
    robot: (
        Annotated[Name, Meta(description="the name of the robot; without it any robot")] | None
    ) = None
    time_limit: (
        Annotated[Seconds, Meta(description="seconds; after that the goal has failed")] | None
    ) = None


class Goals(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The goals of robots; checked every 50 ms."""

    reach: Annotated[tuple[Reach, ...], Meta(max_length=50)] = ()
    follow: Annotated[tuple[Follow, ...], Meta(max_length=50)] = ()
    visit: Annotated[tuple[Visit, ...], Meta(max_length=50)] = ()


class WorldFile(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The content of a world's file."""

    title: Annotated[Text, Meta(description="shown on the page")] = ""
    ambient_light: Annotated[
        float, Meta(ge=0, le=1023, description="the light everywhere, of 1023")
    ] = 400.0
    floor: Annotated[Floor, Meta(description="the ground")] = Floor()
    line: Annotated[tuple[Line, ...], Meta(max_length=50)] = ()
    wall: Annotated[tuple[Wall, ...], Meta(max_length=50)] = ()
    box: Annotated[tuple[Box, ...], Meta(max_length=100)] = ()
    cylinder: Annotated[tuple[Cylinder, ...], Meta(max_length=100)] = ()
    tag: Annotated[tuple[Tag, ...], Meta(max_length=50)] = ()
    face: Annotated[tuple[Face, ...], Meta(max_length=50)] = ()
    light: Annotated[tuple[Lamp, ...], Meta(max_length=50)] = ()
    start: Annotated[tuple[Start, ...], Meta(max_length=100)] = ()
    goal: Annotated[Goals, Meta(description="the goals of robots")] = Goals()


class WorldDescription(WorldFile, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A world's file together with its name and folder.

    Args:
        name: the file's name without its suffix.
        folder: the folder of the floor's picture.
    """

    name: str = "world"
    folder: str = ""


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
