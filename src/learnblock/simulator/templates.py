"""Worlds made from a template, a size and a seed: the same three always make the same world."""

import hashlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import Literal, TypeVar

from learnblock.simulator.colours import ColourName
from learnblock.simulator.geometry import Point, forward
from learnblock.simulator.goal_description import Follow, Goals, Reach
from learnblock.simulator.world_description import (
    Box,
    Cylinder,
    Floor,
    Line,
    Part,
    Prop,
    PropKind,
    Start,
    Wall,
    WorldFile,
)

Template = Literal["field", "track", "maze"]
SMALLEST, LARGEST = 3, 8
"""The sizes: cells on a side of a field or a maze; a track grows alike."""
LARGEST_SEED = 999_999

FIELD_CELL = 500
"""The side in mm of the part of a field that can have one thing."""
FIELD_SHARE = 0.6
"""How many parts of a field have a thing, on average."""
JITTER = 60
"""How far in mm a thing on a field is from the middle of its part."""
MAZE_CELL = 400
"""The distance in mm between the walls of a maze."""
TRACK_CELL = 520
"""Twice the distance in mm between the lanes of a track."""
TRACK_SHARE = 0.7
"""How much of its floor a track goes around."""
TRACK_MARGIN = 250
"""The distance in mm from a track to the edge of the floor."""

T = TypeVar("T")
Cell = tuple[int, int]
"""A column and a row; rows grow to the north."""
Edge = frozenset[Cell]
"""Two neighbours."""


def make_world(template: Template, size: int, seed: int) -> WorldFile:
    """Make a world.

    Args:
        template: a field with things to drive around, a closed line, or a maze.
        size: from `SMALLEST` to `LARGEST`.
        seed: from 0 to `LARGEST_SEED`; each makes another world.
    """
    return _MAKERS[template](size, _Chance(f"{template}\0{size}\0{seed}"))


class _Chance:
    """Random numbers that are the same on every computer.

    No library's generator is used, because their streams differ between versions.

    Args:
        seed: what the numbers depend on.
    """

    def __init__(self, seed: str) -> None:
        self._seed = seed
        self._drawn = 0

    def share(self) -> float:
        """A number from 0 up to 1."""
        key = f"{self._seed}\0{self._drawn}"
        self._drawn += 1
        bits = hashlib.blake2b(key.encode(), digest_size=8).digest()
        return (int.from_bytes(bits, "big") >> 11) / 2**53

    def within(self, bound: int) -> int:
        """A whole number from -bound to bound."""
        return int(self.share() * (2 * bound + 1)) - bound

    def choice(self, options: Sequence[T]) -> T:
        """One of some options."""
        return options[int(self.share() * len(options))]


def _field(size: int, chance: _Chance) -> WorldFile:
    """Things to drive around, on the way from one corner to the other."""
    half = size * FIELD_CELL / 2
    first, last = (0, 0), (size - 1, size - 1)
    box: list[Box] = []
    cylinder: list[Cylinder] = []
    prop: list[Prop] = []
    for cell in _cells(size, size):
        if cell in (first, last) or chance.share() >= FIELD_SHARE:
            continue
        x, y = (at + chance.within(JITTER) for at in _middle(cell, FIELD_CELL, half, half))
        match chance.choice(("box", "cylinder", "prop", "prop")):
            case "box":
                box.append(_some_box(x, y, chance))
            case "cylinder":
                radius = 40 + chance.within(15)
                cylinder.append(Cylinder(x=x, y=y, radius=radius, colour=chance.choice(_COLOURS)))
            case _:
                kind, scale = chance.choice(_OBSTACLES)
                prop.append(Prop(kind=kind, x=x, y=y, scale=scale, solid=True))
    start, finish = (_middle(cell, FIELD_CELL, half, half) for cell in (first, last))
    return WorldFile(
        theme="garden",
        floor=Floor(size=(2 * half, 2 * half)),
        box=tuple(box),
        cylinder=tuple(cylinder),
        prop=tuple(prop),
        start=(Start(x=start[0], y=start[1], heading=-45),),
        goal=_finish(finish),
    )


_COLOURS: tuple[ColourName, ...] = ("red", "green", "blue", "yellow", "orange", "purple")
#: Props to drive around, none more than 160 mm wide at this scale.
_OBSTACLES: tuple[tuple[PropKind, float], ...] = (
    ("tree", 1.0),
    ("barrel", 1.0),
    ("cone", 1.0),
    ("crate", 0.7),
    ("house", 0.5),
)


_BESIDE_TRACKS: tuple[PropKind, ...] = ("tree", "house", "flowers")


def _some_box(x: float, y: float, chance: _Chance) -> Box:
    length, width = 90 + chance.within(20), 90 + chance.within(20)
    heading, colour = chance.within(6) * 15, chance.choice(_COLOURS)
    return Box(x=x, y=y, heading=heading, length=length, width=width, colour=colour)


def _track(size: int, chance: _Chance) -> WorldFile:
    """A closed line around a tree of cells, which never crosses itself."""
    columns, rows = size // 2 + 1, (size + 1) // 2
    tree = _tree(columns, rows, chance, TRACK_SHARE)
    lane = TRACK_CELL / 2
    corners = _corners(_around(tree))
    path = tuple(_path(corners, lane))
    used = {cell for edge in tree for cell in edge}
    left, right = min(x for x, _ in used), max(x for x, _ in used)
    low, high = min(y for _, y in used), max(y for _, y in used)
    east, north = (left + right + 1) * lane, (low + high + 1) * lane
    (x, y), heading = _halfway(corners, lane)
    start = (x - east, y - north, heading)
    floor = (
        (right - left + 1) * TRACK_CELL + 2 * TRACK_MARGIN,
        (high - low + 1) * TRACK_CELL + 2 * TRACK_MARGIN,
    )
    gaps = [(i, j) for i in range(left, right + 1) for j in range(low, high + 1)]
    prop = [
        Prop(
            kind=chance.choice(_BESIDE_TRACKS),
            x=(i + 0.5) * TRACK_CELL - east,
            y=(j + 0.5) * TRACK_CELL - north,
            solid=True,
        )
        for i, j in gaps
        if (i, j) not in used
    ]
    return WorldFile(
        floor=Floor(size=floor),
        line=(Line(name="track", start=start, path=path, closed=True),),
        prop=tuple(prop),
        start=(Start(x=start[0], y=start[1], heading=heading),),
        goal=Goals(follow=(Follow(name="one lap", line="track", fraction=0.95),)),
    )


def _maze(size: int, chance: _Chance) -> WorldFile:
    """A maze with one way between any two places."""
    half = size * MAZE_CELL / 2
    ways = _tree(size, size, chance, 1.0)
    first, last = (0, size - 1), (size - 1, 0)
    start, finish = (_middle(cell, MAZE_CELL, half, half) for cell in (first, last))
    is_open_east = frozenset((first, (1, size - 1))) in ways
    chains = _chains(_walls(size, ways))
    return WorldFile(
        theme="maze",
        floor=Floor(size=(2 * half, 2 * half)),
        wall=tuple(
            Wall(points=tuple((x * MAZE_CELL - half, y * MAZE_CELL - half) for x, y in chain))
            for chain in chains
        ),
        start=(Start(x=start[0], y=start[1], heading=0 if is_open_east else 90),),
        goal=_finish(finish),
    )


def _finish(place: Point) -> Goals:
    return Goals(reach=(Reach(name="finish", x=place[0], y=place[1], radius=130),))


def _cells(columns: int, rows: int) -> Iterator[Cell]:
    return ((x, y) for y in range(rows) for x in range(columns))


def _middle(cell: Cell, side: float, east: float, north: float) -> Point:
    return (cell[0] + 0.5) * side - east, (cell[1] + 0.5) * side - north


def _neighbours(cell: Cell) -> tuple[Cell, ...]:
    x, y = cell
    return (x + 1, y), (x, y + 1), (x - 1, y), (x, y - 1)


def _tree(columns: int, rows: int, chance: _Chance, share: float) -> set[Edge]:
    """Connect cells without a circle, by going on at random and back where there is no way on.

    Args:
        columns: of the grid.
        rows: of the grid.
        chance: the random numbers.
        share: how many of the cells to connect.
    """
    left = set(_cells(columns, rows))
    wanted = max(2, round(share * len(left)))
    way = [(0, rows - 1)]
    left.discard(way[0])
    edges: set[Edge] = set()
    while way and len(edges) < wanted - 1:
        options = [cell for cell in _neighbours(way[-1]) if cell in left]
        if not options:
            way.pop()
            continue
        chosen = chance.choice(options)
        edges.add(frozenset((way[-1], chosen)))
        left.discard(chosen)
        way.append(chosen)
    return edges


def _walls(size: int, ways: set[Edge]) -> set[Edge]:
    """The pieces of wall between neighbours that are not connected, as pairs of corners."""
    walls: set[Edge] = set()
    for x, y in _cells(size, size):
        if x + 1 < size and frozenset(((x, y), (x + 1, y))) not in ways:
            walls.add(frozenset(((x + 1, y), (x + 1, y + 1))))
        if y + 1 < size and frozenset(((x, y), (x, y + 1))) not in ways:
            walls.add(frozenset(((x, y + 1), (x + 1, y + 1))))
    return walls


def _chains(edges: Iterable[Edge]) -> list[list[Cell]]:
    """Join edges to chains of corners, as far as they continue."""
    links: dict[Cell, set[Cell]] = {}
    for edge in edges:
        start, end = edge
        links.setdefault(start, set()).add(end)
        links.setdefault(end, set()).add(start)
    chains = []
    while any(links.values()):
        # From the ends of the walls inwards, so that few chains remain.
        at = min((cell for cell in links if links[cell]), key=lambda cell: (len(links[cell]), cell))
        chain = [at]
        while links[chain[-1]]:
            following = _onwards(chain, links[chain[-1]])
            links[chain[-1]].discard(following)
            links[following].discard(chain[-1])
            chain.append(following)
        chains.append(_corners_only(chain))
    return chains


def _onwards(chain: Sequence[Cell], options: Iterable[Cell]) -> Cell:
    """The next corner: straight ahead if possible."""
    if len(chain) > 1:
        (x, y), (last_x, last_y) = chain[-1], chain[-2]
        ahead = (2 * x - last_x, 2 * y - last_y)
        if ahead in options:
            return ahead
    return min(options)


def _corners_only(chain: Sequence[Cell]) -> list[Cell]:
    """A chain without the places where it goes straight on."""
    bends = [
        here
        for before, here, after in zip(chain, chain[1:], chain[2:], strict=False)
        if (here[0] - before[0], here[1] - before[1]) != (after[0] - here[0], after[1] - here[1])
    ]
    return [chain[0], *bends, chain[-1]]


def _around(tree: set[Edge]) -> list[Cell]:
    """The way around a tree, on a grid twice as fine: once along both sides of each edge."""
    links: dict[Cell, set[Cell]] = {}

    def connect(cell: Cell, other: Cell) -> None:
        links.setdefault(cell, set()).add(other)
        links.setdefault(other, set()).add(cell)

    for x, y in {cell for edge in tree for cell in edge}:
        ring = [(2 * x, 2 * y), (2 * x + 1, 2 * y), (2 * x + 1, 2 * y + 1), (2 * x, 2 * y + 1)]
        for cell, other in pairwise([*ring, ring[0]]):
            if not _is_crossed(cell, other, tree):
                connect(cell, other)
    for edge in tree:
        (x, y), (end_x, _) = sorted(edge)
        for side in (0, 1):
            if end_x > x:
                connect((2 * x + 1, 2 * y + side), (2 * x + 2, 2 * y + side))
            else:
                connect((2 * x + side, 2 * y + 1), (2 * x + side, 2 * y + 2))
    return _loop(links)


def _is_crossed(cell: Cell, other: Cell, tree: set[Edge]) -> bool:
    """Whether the edge of a tree leaves a cell between two of its quarters."""
    x, y = cell[0] // 2, cell[1] // 2
    if cell[0] == other[0]:
        beside = (x + (1 if cell[0] % 2 else -1), y)
    else:
        beside = (x, y + (1 if cell[1] % 2 else -1))
    return frozenset(((x, y), beside)) in tree


def _loop(links: Mapping[Cell, set[Cell]]) -> list[Cell]:
    """The cells of a circle, in order."""
    first = min(links)
    loop = [first, min(links[first])]
    while True:
        before, here = loop[-2:]
        (following,) = links[here] - {before}
        if following == first:
            return loop
        loop.append(following)


def _corners(loop: Sequence[Cell]) -> list[Cell]:
    """The corners of a circle, the first at the end of its longest straight part."""
    circle = [loop[-1], *loop, loop[0]]
    corners = _corners_only(circle)[1:-1]
    lengths = [_length(corners[i - 1], corners[i]) for i in range(len(corners))]
    longest = lengths.index(max(lengths))
    return corners[longest:] + corners[:longest]


def _length(cell: Cell, other: Cell) -> int:
    return abs(cell[0] - other[0]) + abs(cell[1] - other[1])


def _halfway(corners: Sequence[Cell], lane: float) -> tuple[Point, float]:
    """The middle of the straight part before the first corner, and its heading."""
    (x, y), (end_x, end_y) = corners[-1], corners[0]
    return ((x + end_x + 1) / 2 * lane, (y + end_y + 1) / 2 * lane), _heading(
        corners[-1], corners[0]
    )


def _heading(cell: Cell, other: Cell) -> float:
    ahead = (other[0] > cell[0]) - (other[0] < cell[0]), (other[1] > cell[1]) - (other[1] < cell[1])
    return next(
        heading for heading in (0.0, 90.0, 180.0, -90.0) if _is_near(forward(heading), ahead)
    )


def _is_near(point: Point, other: Point) -> bool:
    return abs(point[0] - other[0]) + abs(point[1] - other[1]) < 0.5


def _path(corners: Sequence[Cell], lane: float) -> Iterator[Part]:
    """The straight parts and curves of a circle, from `_halfway` to there."""
    radius = lane / 2
    ways = [*pairwise([corners[-1], *corners])]
    half = _length(*ways[0]) * lane / 2 - radius
    yield from _straight(half)
    for (cell, other), (_, following) in pairwise([*ways, ways[0]]):
        turn = (_heading(other, following) - _heading(cell, other) + 180) % 360 - 180
        yield Part(turn=turn, radius=radius)
        is_last = (other, following) == ways[0]
        yield from _straight(half if is_last else _length(other, following) * lane - 2 * radius)


def _straight(length: float) -> Iterator[Part]:
    # Two curves may follow each other without a straight part.
    if length >= 1:
        yield Part(forward=length)


_MAKERS: MappingProxyType[Template, Callable[[int, _Chance], WorldFile]] = MappingProxyType(
    {"field": _field, "track": _track, "maze": _maze}
)
