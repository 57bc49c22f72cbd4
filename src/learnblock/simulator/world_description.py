"""What a world file may say, and the worlds that come with LearnBlock.

Every key's description and bounds stand here and nowhere else: the messages about a wrong file
and the tables of docs/simulator.md are made from them. Places are mm, x east and y north of the
middle of the floor; headings are degrees clockwise, 0 looks east.
"""

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

from msgspec import Meta, Struct

from learnblock import description_file
from learnblock.description_file import Finding, KeyPath, unknown
from learnblock.errors import WorldError
from learnblock.simulator.colours import Colour
from learnblock.simulator.geometry import Point, Polyline, Pose, arc

SHIPPED_WORLDS = Path(__file__).parent / "worlds"
CLOSING_GAP = 5.0
"""mm between the end and the start of a closed line that is taken for a rounding error."""
MAXIMUM_PICTURE_BYTES = 10_000_000
MAXIMUM_PICTURE_SIDE = 4096
"""Pixels."""

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

_X = Meta(description="place to the east, mm")
_Y = Meta(description="place to the north, mm")
_HEADING = Meta(description="degrees clockwise; 0 looks east")


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
    """One part of a line's path: straight on, or a curve."""

    forward: Annotated[float, Meta(ge=1, le=10000, description="straight on, mm")] | None = None
    turn: (
        Annotated[
            float, Meta(ge=-360, le=360, description="a curve by so many degrees, right positive")
        ]
        | None
    ) = None
    radius: Annotated[float, Meta(ge=10, le=5000, description="of the curve, mm")] | None = None

    def __post_init__(self) -> None:
        if (self.forward is None) == (self.turn is None or self.radius is None):
            raise ValueError("expected either { forward = 300 } or { turn = 90, radius = 300 }")


class Line(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A line painted on the floor; later lines are painted over earlier ones."""

    name: Annotated[Name, Meta(description="by which a goal speaks of it")] = "line"
    colour: Annotated[Colour, Meta(description="black, red, blue or any other")] = "black"
    width: Annotated[float, Meta(ge=2, le=500, description="mm")] = 40.0
    points: Annotated[
        tuple[XY, ...],
        Meta(max_length=500, description="corners of a straight-edged line, instead of path, mm"),
    ] = ()
    start: Annotated[
        tuple[Place, Place, Heading],
        Meta(description="where its path begins: x, y and heading"),
    ] = (0.0, 0.0, 0.0)
    path: Annotated[
        tuple[Part, ...], Meta(max_length=200, description="straight parts and curves, in order")
    ] = ()
    closed: Annotated[bool, Meta(description="whether it ends where it begins")] = False

    def __post_init__(self) -> None:
        if bool(self.path) == (len(self.points) >= 2):
            raise ValueError("a line needs either `points` (two or more) or `start` and `path`")
        line = self.polyline()
        if len(line.points) < 2:
            raise ValueError("a line needs a length; this one ends where it begins")
        if self.path and self.closed and not _is_closed(line):
            (x, y), (start_x, start_y) = line.points[-1], line.points[0]
            raise ValueError(
                f"a closed line's path must end where it begins, ({start_x:g}, {start_y:g}); "
                f"this one ends at ({x:.0f}, {y:.0f})"
            )

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
    mass: Annotated[Mass, Meta(description="kg; without it the box stands fast")] | None = None
    colour: Annotated[Colour, Meta(description="of its sides")] = "brown"
    name: Annotated[Name, Meta(description="for messages and events")] = "box"


class Cylinder(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A standing cylinder; one with a mass can be pushed."""

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    radius: Annotated[float, Meta(ge=5, le=1000, description="mm")] = 50.0
    height: Annotated[ObjectHeight, Meta(description="mm")] = 100.0
    mass: Annotated[Mass, Meta(description="kg; without it the cylinder stands fast")] | None = None
    colour: Annotated[Colour, Meta(description="of its side")] = "green"
    name: Annotated[Name, Meta(description="for messages and events")] = "cylinder"


class Tag(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """An AprilTag of family 36h11 on a square board; robots bump into the board and see it."""

    id: Annotated[TagNumber, Meta(description="the tag's number")]
    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    heading: Annotated[Heading, Meta(description="where its front looks, degrees clockwise")]
    z: Annotated[float, Meta(ge=0, le=2000, description="height of its middle, mm")] = 80.0
    size: Annotated[
        float, Meta(ge=20, le=2000, description="side with its white margin, mm; 8/10 are black")
    ] = 120.0


class Face(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A drawn face that shows an emotion, on a square board."""

    emotion: Annotated[Emotion, Meta(description="what it shows")]
    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    heading: Annotated[Heading, Meta(description="where its front looks, degrees clockwise")]
    z: Annotated[float, Meta(ge=0, le=2000, description="height of its middle, mm")] = 110.0
    size: Annotated[float, Meta(ge=20, le=2000, description="side, mm")] = 200.0


class Lamp(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A lamp over the floor, for light sensors: its light falls off with the distance squared."""

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    z: Annotated[float, Meta(ge=50, le=5000, description="height, mm")] = 500.0
    brightness: Annotated[
        float, Meta(ge=0, le=1023, description="what it adds right beneath it, of 1023")
    ] = 600.0


class Start(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Where a robot starts; the first robot takes the first one, the second robot the second."""

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    heading: Annotated[Heading, _HEADING] = 0.0
    name: Annotated[Name, Meta(description="by which a robot may ask for it")] = "start"


class Reach(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Bring a robot's middle into a round region."""

    x: Annotated[Place, _X]
    y: Annotated[Place, _Y]
    radius: Annotated[float, Meta(ge=10, le=5000, description="of the region, mm")] = 150.0
    name: Annotated[Name, Meta(description="what the page shows")] = "reach"
    robot: Annotated[Name, Meta(description="the one meant; without it any robot")] | None = None
    time_limit: Annotated[Seconds, Meta(description="s; later it has failed")] | None = None


class Follow(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Drive along a line."""

    line: Annotated[Name, Meta(description="the line's name")] = "line"
    fraction: Annotated[
        float, Meta(ge=0.01, le=1, description="how much of the line; 1 is all of it, one lap")
    ] = 1.0
    distance: Annotated[
        float, Meta(ge=5, le=1000, description="how far off a robot's middle may be, mm")
    ] = 100.0
    name: Annotated[Name, Meta(description="what the page shows")] = "follow"
    robot: Annotated[Name, Meta(description="the one meant; without it any robot")] | None = None
    time_limit: Annotated[Seconds, Meta(description="s; later it has failed")] | None = None


class Visit(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Come close to the front of a tag and face it."""

    id: Annotated[TagNumber, Meta(description="the tag's number")]
    distance: Annotated[
        float, Meta(ge=10, le=5000, description="from the robot's middle to the tag at most, mm")
    ] = 350.0
    angle: Annotated[
        float, Meta(ge=1, le=180, description="off the robot's heading at most, degrees")
    ] = 25.0
    name: Annotated[Name, Meta(description="what the page shows")] = "visit"
    robot: Annotated[Name, Meta(description="the one meant; without it any robot")] | None = None
    time_limit: Annotated[Seconds, Meta(description="s; later it has failed")] | None = None


class Goals(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """What robots are to achieve; looked at every 50 ms."""

    reach: Annotated[tuple[Reach, ...], Meta(max_length=50)] = ()
    follow: Annotated[tuple[Follow, ...], Meta(max_length=50)] = ()
    visit: Annotated[tuple[Visit, ...], Meta(max_length=50)] = ()


class WorldFile(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Everything a world's file may hold."""

    title: Annotated[Text, Meta(description="what the page shows")] = ""
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
    goal: Annotated[Goals, Meta(description="what robots are to achieve")] = Goals()


class WorldDescription(WorldFile, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A world's file together with where it comes from.

    Args:
        name: the file's name without its ending.
        folder: where the floor's picture lies.
    """

    name: str = "world"
    folder: str = ""


def load_world(name_or_path: str | Path, folders: Sequence[Path] = ()) -> WorldDescription:
    """The description of a world.

    Args:
        name_or_path: the name of a world of `folders` or of ours, or a path that ends in .toml.
        folders: looked into before ours, in this order.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: the file is wrong.
    """
    file = description_file.locate("world", name_or_path, [*folders, SHIPPED_WORLDS])
    world = description_file.read(file, WorldFile, WorldError, lambda w: _check(w, file.parent))
    values = {field: getattr(world, field) for field in WorldFile.__struct_fields__}
    return WorldDescription(name=file.stem, folder=str(file.parent), **values)


def read_world(values: Mapping[str, Any], folder: Path) -> WorldFile:
    """A world of values such as an editor makes, whose floor's picture lies in `folder`.

    Raises:
        WorldError: they are wrong.
    """
    return description_file.convert(
        values, WorldFile, WorldError, lambda world: _check(world, folder), name="world.toml"
    )


def write_world(world: WorldFile, name: str) -> str:
    """The text of a world's file.

    Raises:
        WorldError: it would be larger than `load_world` accepts.
    """
    return description_file.write(world, f"{name}.toml", WorldError)


def world_names(folders: Sequence[Path] = ()) -> tuple[str, ...]:
    """The worlds of `folders` and ours, in alphabetical order."""
    return tuple(description_file.names([*folders, SHIPPED_WORLDS]))


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


def _is_closed(line: Polyline) -> bool:
    (start_x, start_y), (end_x, end_y) = line.points[0], line.points[-1]
    return math.hypot(end_x - start_x, end_y - start_y) <= CLOSING_GAP


def _check(world: WorldFile, folder: Path) -> Iterator[Finding]:
    yield from _check_places(world)
    yield from _check_names(world)
    yield from _check_goals(world)
    if world.floor.picture is not None:
        yield from _check_picture(folder, world.floor.picture)


def _check_places(world: WorldFile) -> Iterator[Finding]:
    """What stands outside the floor was meant to stand somewhere else."""
    east, north = world.floor.size[0] / 2, world.floor.size[1] / 2
    for key in ("box", "cylinder", "tag", "face", "light", "start"):
        for index, thing in enumerate(getattr(world, key)):
            if abs(thing.x) > east or abs(thing.y) > north:
                message = (
                    f"`{key}[{index + 1}]` stands at ({thing.x:g}, {thing.y:g}), off the floor; "
                    f"x runs from {-east:g} to {east:g} and y from {-north:g} to {north:g}"
                )
                yield Finding((key, index), "off-the-floor", message)


def _check_names(world: WorldFile) -> Iterator[Finding]:
    """Lines, starts and goals are spoken of by name, so no two may share one."""
    groups: tuple[list[KeyPath], ...] = (
        [("line", i) for i in range(len(world.line))],
        [("start", i) for i in range(len(world.start))],
        [("goal", kind, i) for kind, i, _ in _goals(world)],
    )
    names = (
        [line.name for line in world.line],
        [start.name for start in world.start],
        [goal.name for _, _, goal in _goals(world)],
    )
    for paths, given in zip(groups, names, strict=True):
        seen: Counter[str] = Counter()
        for path, name in zip(paths, given, strict=True):
            seen[name] += 1
            if seen[name] == 2:
                message = f"two have the name `{name}`; give each its own `name`"
                yield Finding((*path, "name"), "name-taken", f"of `{path[0]}`, {message}")


def _goals(world: WorldFile) -> list[tuple[str, int, Reach | Follow | Visit]]:
    kinds = ("reach", "follow", "visit")
    return [(kind, i, goal) for kind in kinds for i, goal in enumerate(getattr(world.goal, kind))]


def _check_goals(world: WorldFile) -> Iterator[Finding]:
    lines = [line.name for line in world.line]
    for index, follow in enumerate(world.goal.follow):
        if follow.line not in lines:
            message = unknown(f"there is no line `{follow.line}`", follow.line, lines)
            yield Finding(("goal", "follow", index, "line"), "unknown-line", message)
    tags = [tag.id for tag in world.tag]
    for index, visit in enumerate(world.goal.visit):
        if visit.id not in tags:
            message = unknown(f"there is no tag {visit.id}", "", map(str, tags))
            yield Finding(("goal", "visit", index, "id"), "unknown-tag", message)


def _check_picture(folder: Path, picture: str) -> Iterator[Finding]:
    problem = _picture_problem(folder, picture)
    if problem:
        message = f'`floor.picture` is "{picture}": {problem}'
        yield Finding(("floor", "picture"), "wrong-picture", message)


def _picture_problem(folder: Path, picture: str) -> str:
    # The name of no file holds a NUL, and even to ask about such a file is an error.
    file = (folder / picture.partition("\0")[0]).resolve()
    if "\0" in picture or not file.is_relative_to(folder.resolve()):
        return "a picture must lie in the folder of the world's file"
    if not file.is_file():
        return "there is no such file in the folder of the world's file"
    if file.stat().st_size > MAXIMUM_PICTURE_BYTES:
        return f"the file is larger than {MAXIMUM_PICTURE_BYTES:,} bytes"
    width, height = _png_size(file)
    if min(width, height) == 0:
        return "the file is no PNG picture; save it as PNG"
    if max(width, height) > MAXIMUM_PICTURE_SIDE:
        return f"it has {width} by {height} pixels; at most {MAXIMUM_PICTURE_SIDE} a side are drawn"
    return ""


def _png_size(file: Path) -> tuple[int, int]:
    """Width and height by the header (PNG specification, 11.2.2), (0, 0) if it is no PNG.

    The header is read by hand so that a picture is never unpacked before its size is known.
    """
    with file.open("rb") as stream:
        header = stream.read(24)
    if len(header) < 24 or header[:8] != b"\x89PNG\r\n\x1a\n" or header[12:16] != b"IHDR":
        return 0, 0
    return int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")
