import math
from itertools import combinations, pairwise
from pathlib import Path

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gate import examples
from learnblock.simulator import make_world, read_world, unreachable_goals, write_world
from learnblock.simulator.geometry import Point
from learnblock.simulator.props import body_of
from learnblock.simulator.templates import LARGEST, LARGEST_SEED, MAZE_CELL, SMALLEST, Template
from learnblock.simulator.world_description import Box, Cylinder, WorldFile

TEMPLATES: tuple[Template, ...] = ("field", "track", "maze")
SIZES = st.integers(SMALLEST, LARGEST)
SEEDS = st.integers(0, LARGEST_SEED)
#: The reach of the largest robot is 127 mm; all others are narrower than this.
WIDE = 95.0
few = settings(max_examples=examples(40, gate=12), deadline=None)


@few
@given(st.sampled_from(TEMPLATES), SIZES, SEEDS)
def test_every_world_is_valid_and_comes_back_from_its_file(
    template: Template, size: int, seed: int
) -> None:
    world = make_world(template, size, seed)

    assert read_world(msgspec.to_builtins(world), Path()) == world
    assert write_world(world, "made")


@few
@given(st.sampled_from(TEMPLATES), SIZES, SEEDS)
def test_the_same_values_make_the_same_world(template: Template, size: int, seed: int) -> None:
    assert make_world(template, size, seed) == make_world(template, size, seed)


@few
@given(st.sampled_from(TEMPLATES), SIZES, SEEDS)
def test_every_goal_can_be_reached_by_a_wide_robot(
    template: Template, size: int, seed: int
) -> None:
    world = make_world(template, size, seed)

    assert list(world.goal.all())
    assert unreachable_goals(world, WIDE) == ()


@pytest.mark.parametrize("template", TEMPLATES)
def test_seeds_make_different_worlds(template: Template) -> None:
    worlds = {msgspec.json.encode(make_world(template, 5, seed)) for seed in range(20)}

    assert len(worlds) > 10


@few
@given(SIZES, SEEDS)
def test_a_maze_has_exactly_one_way_between_any_two_places(size: int, seed: int) -> None:
    ways = ways_of_maze(make_world("maze", size, seed), size)
    reached, waiting = {(0, 0)}, [(0, 0)]
    while waiting:
        here = waiting.pop()
        for way in ways:
            if here in way:
                (other,) = way - {here}
                if other not in reached:
                    reached.add(other)
                    waiting.append(other)

    # A connected graph whose edges are one fewer than its nodes has no circle.
    assert len(reached) == size * size
    assert len(ways) == size * size - 1


def ways_of_maze(world: WorldFile, size: int) -> set[frozenset[tuple[int, int]]]:
    """The neighbours without a wall between their middles."""
    half = size * MAZE_CELL / 2
    sides = [ends for wall in world.wall for ends in pairwise(wall.points)]
    cells = [(x, y) for x in range(size) for y in range(size)]
    ways = set()
    for x, y in cells:
        for other in ((x + 1, y), (x, y + 1)):
            if other not in cells:
                continue
            middles = [
                ((a + 0.5) * MAZE_CELL - half, (b + 0.5) * MAZE_CELL - half)
                for a, b in ((x, y), other)
            ]
            if not any(crosses((middles[0], middles[1]), side) for side in sides):
                ways.add(frozenset(((x, y), other)))
    return ways


@few
@given(SIZES, SEEDS)
def test_a_track_is_closed_and_never_crosses_itself(size: int, seed: int) -> None:
    (line,) = make_world("track", size, seed).line
    points = line.polyline().points
    corners = [(float(x), float(y)) for x, y in points]
    sides = [*pairwise(corners)]

    assert line.closed
    assert math.dist(corners[0], corners[-1]) < 1
    assert sum(part.turn or 0 for part in line.path) in (360, -360)
    for (i, one), (k, other) in combinations(enumerate(sides), 2):
        if k - i > 1 and (i, k) != (0, len(sides) - 1):
            assert not crosses(one, other)


@few
@given(SIZES, SEEDS)
def test_a_track_starts_on_its_line_and_stays_on_the_floor(size: int, seed: int) -> None:
    world = make_world("track", size, seed)
    (line,), (start,) = world.line, world.start
    east, north = world.floor.size[0] / 2 - 200, world.floor.size[1] / 2 - 200

    assert (start.x, start.y, start.heading) == line.start
    for x, y in line.polyline().points:
        assert abs(x) < east
        assert abs(y) < north


@few
@given(SIZES, SEEDS)
def test_things_on_a_field_are_apart_and_away_from_start_and_goal(size: int, seed: int) -> None:
    world = make_world("field", size, seed)
    bodies = [*world.box, *world.cylinder, *map(body_of, world.prop)]
    (start,), (goal,) = world.start, world.goal.reach

    for one, other in combinations(bodies, 2):
        assert math.dist((one.x, one.y), (other.x, other.y)) - half(one) - half(other) > 200
    for body in bodies:
        for place in ((start.x, start.y), (goal.x, goal.y)):
            assert math.dist((body.x, body.y), place) - half(body) > 200


def half(thing: Box | Cylinder) -> float:
    """Half of the largest width of a thing."""
    if isinstance(thing, Box):
        return math.hypot(thing.length, thing.width) / 2
    return thing.radius


def crosses(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    """Whether two sides cross, more than two in one line do by rounding."""
    return side(*one, other[0]) * side(*one, other[1]) < -1 and (
        side(*other, one[0]) * side(*other, one[1]) < -1
    )


def side(start: Point, end: Point, place: Point) -> float:
    return (end[0] - start[0]) * (place[1] - start[1]) - (end[1] - start[1]) * (place[0] - start[0])
