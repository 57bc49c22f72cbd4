import contextlib
import math
from pathlib import Path

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import WorldError
from learnblock.simulator import World, load_robot, load_world, make_variant, world_names
from learnblock.simulator.world_check import check_world
from learnblock.simulator.world_description import (
    Box,
    Cylinder,
    Face,
    Moved,
    Start,
    Tag,
    Vary,
    Wall,
    WorldDescription,
    WorldFile,
    thing_name,
)

ROUNDING = 0.05
numbers = st.integers(1, 10_000)
places = st.floats(-800, 800).map(lambda place: round(place, 1))
boxes = st.builds(Box, x=places, y=places, heading=st.floats(-360, 360), name=st.just("crate"))
cylinders = st.builds(Cylinder, x=places, y=places, name=st.just("post"))
tags = st.builds(Tag, id=st.integers(0, 3), x=places, y=places, heading=st.floats(-360, 360))
faces = st.builds(Face, emotion=st.just("joy"), x=places, y=places, heading=st.floats(-360, 360))
starts = st.builds(Start, x=places, y=places, heading=st.floats(-360, 360))
bounds = st.builds(
    Vary,
    start=st.floats(0, 200),
    heading=st.floats(0, 180),
    light=st.floats(0, 1023),
    noise=st.floats(0, 10),
    slip=st.floats(0, 0.3),
    thing=st.just(()) | st.tuples(st.builds(Moved, name=st.just("crate"), distance=st.just(90.0))),
)
worlds = st.builds(
    WorldDescription,
    box=st.tuples(boxes, boxes),
    cylinder=st.tuples(cylinders),
    tag=st.tuples(tags),
    face=st.tuples(faces),
    start=st.tuples(starts),
    vary=bounds,
)


def movable(world: WorldDescription) -> list[Box | Cylinder | Tag | Face | Start]:
    return [*world.box, *world.cylinder, *world.tag, *world.face, *world.start]


def file_of(world: WorldDescription) -> WorldFile:
    values = {name: getattr(world, name) for name in WorldFile.__struct_fields__}
    return msgspec.convert(msgspec.to_builtins(values), WorldFile)


def assert_within_bounds(world: WorldDescription, varied: WorldDescription) -> None:
    vary = world.vary
    assert vary is not None
    distances = {moved.name: moved.distance for moved in vary.thing}
    for before, after in zip(movable(world), movable(varied), strict=True):
        is_start = isinstance(before, Start)
        bound = vary.start if is_start else distances.get(thing_name(before), 0.0)
        assert abs(after.x - before.x) <= bound + ROUNDING
        assert abs(after.y - before.y) <= bound + ROUNDING
        if is_start:
            turned = (after.heading - before.heading + 180) % 360 - 180
            assert abs(turned) <= vary.heading + 2 * ROUNDING
    assert abs(varied.floor.slip - world.floor.slip) <= vary.slip + 0.0001
    assert abs(varied.ambient_light - world.ambient_light) <= vary.light + ROUNDING
    assert abs(varied.sensor_noise - world.sensor_noise) <= vary.noise + ROUNDING


@given(worlds, numbers)
def test_every_variant_is_a_valid_world_within_its_bounds(
    world: WorldDescription, number: int
) -> None:
    with contextlib.suppress(WorldError):
        varied = make_variant(world, number)
        assert_within_bounds(world, varied)
        assert list(check_world(file_of(varied), Path())) == []


@given(st.sampled_from([name for name in world_names() if load_world(name).vary]), numbers)
def test_every_variant_of_a_shipped_world_is_within_its_bounds(name: str, number: int) -> None:
    world = load_world(name)
    varied = make_variant(world, number)
    assert_within_bounds(world, varied)
    assert list(check_world(file_of(varied), Path(world.folder))) == []
    assert varied == make_variant(load_world(name), number)


def test_variant_zero_is_the_world_as_it_is_drawn() -> None:
    world = load_world("arena")
    assert make_variant(world, 0) is world


def test_variants_differ() -> None:
    starts = {make_variant(load_world("arena"), number).start for number in range(1, 21)}
    assert len(starts) == 20


def test_a_variant_is_the_same_on_every_computer() -> None:
    varied = make_variant(load_world("arena"), 1)
    assert varied.start[0] == Start(x=99.4, y=99.8, heading=-35.1)


def test_what_does_not_move_stays_where_it_is_drawn() -> None:
    still = Box(x=0.05, y=0.0, name="still")
    moved = Cylinder(x=300.0, y=300.0, name="moved")
    vary = Vary(thing=(Moved(name="moved", distance=100.0),))
    varied = make_variant(WorldDescription(box=(still,), cylinder=(moved,), vary=vary), 1)
    assert varied.box == (still,)
    assert varied.cylinder != (moved,)


@given(numbers)
def test_moved_objects_overlap_neither_each_other_nor_the_start(number: int) -> None:
    posts = tuple(Cylinder(x=x, y=0.0, name=f"post {x:.0f}") for x in (-300.0, -150.0, 300.0))
    vary = Vary(start=60.0, thing=tuple(Moved(name=post.name, distance=140.0) for post in posts))
    world = WorldDescription(cylinder=posts, start=(Start(x=60.0, y=0.0),), vary=vary)
    varied = make_variant(world, number)
    [start] = varied.start
    centres = [(post.x, post.y) for post in varied.cylinder]
    for index, post in enumerate(centres):
        assert math.dist(post, (start.x, start.y)) >= 50 + 140 - ROUNDING
        assert all(math.dist(post, other) >= 100 - ROUNDING for other in centres[:index])


def test_objects_that_overlap_as_drawn_may_overlap_in_a_variant() -> None:
    corner = (Wall(points=((0.0, 0.0), (500.0, 0.0))),)
    box = Box(x=0.0, y=0.0, name="crate")
    vary = Vary(thing=(Moved(name="crate", distance=10.0),))
    assert make_variant(WorldDescription(wall=corner, box=(box,), vary=vary), 1).variant == 1


def test_without_room_the_error_names_world_variant_and_object() -> None:
    walls = tuple(Wall(points=((-200.0, y), (200.0, y)), thickness=2.0) for y in (-52.0, 52.0))
    ends = tuple(Wall(points=((x, -60.0), (x, 60.0)), thickness=2.0) for x in (-52.0, 52.0))
    vary = Vary(thing=(Moved(name="crate", distance=2000.0),))
    floor = {"floor": {"size": (200, 200)}}
    world = msgspec.convert(floor, WorldDescription)
    world = msgspec.structs.replace(
        world, wall=(*walls, *ends), box=(Box(x=0.0, y=0.0, name="crate"),), vary=vary
    )
    with pytest.raises(WorldError, match="Variant 1 of the world 'world' has no room for 'crate'"):
        make_variant(world, 1)


def test_a_world_without_bounds_has_no_variants() -> None:
    with pytest.raises(WorldError, match="has no variants"):
        make_variant(WorldDescription(), 1)


def test_noise_is_a_factor_of_what_sensors_read() -> None:
    readings = []
    for factor in (0.0, 1.0, 2.0):
        world = World(WorldDescription(sensor_noise=factor))
        readings.append(world.add_robot(load_robot("ebo")).distances()["front"][0])
    exact, usual, double = readings
    assert usual != exact
    assert double - exact == pytest.approx(2 * (usual - exact), abs=0.2)


def test_only_one_robot_of_ours_is_larger_than_what_is_kept_free_around_a_start() -> None:
    from learnblock.simulator import robot_names
    from learnblock.simulator.vary import ROOM

    assert [name for name in robot_names() if load_robot(name).body.reach >= ROOM] == ["create3"]
