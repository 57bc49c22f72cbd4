from pathlib import Path
from typing import get_args

import pytest

from learnblock.errors import WorldError
from learnblock.simulator import World, load_robot, load_world
from learnblock.simulator.physics import things
from learnblock.simulator.props import body_of
from learnblock.simulator.world_description import Box, Cylinder, Prop, PropKind, WorldDescription


def world_with(tmp_path: Path, text: str) -> WorldDescription:
    (tmp_path / "w.toml").write_text(text)
    return load_world(tmp_path / "w.toml")


@pytest.mark.parametrize("kind", get_args(PropKind))
def test_every_prop_has_a_body_that_grows_with_it(kind: PropKind) -> None:
    usual, large = (body_of(Prop(kind=kind, x=10, y=20, scale=scale)) for scale in (1.0, 2.0))

    assert (usual.x, usual.y, usual.mass, usual.name) == (10, 20, None, kind)
    assert large.height == 2 * usual.height
    if isinstance(usual, Box):
        assert isinstance(large, Box)
        assert (large.length, large.width) == (2 * usual.length, 2 * usual.width)
    else:
        assert isinstance(large, Cylinder)
        assert large.radius == 2 * usual.radius


def test_decoration_is_no_obstacle_and_no_surface(tmp_path: Path) -> None:
    plain = World(world_with(tmp_path, ""))
    decorated = World(world_with(tmp_path, '[[prop]]\nkind = "tree"\nx = 300\ny = 0'))

    assert len(decorated.physics.space.shapes) == len(plain.physics.space.shapes)
    assert len(decorated.surfaces()) == len(plain.surfaces())


def test_a_robot_bumps_into_a_solid_prop_and_is_told_its_kind(tmp_path: Path) -> None:
    text = '[[prop]]\nkind = "crate"\nx = 400\ny = 0\nsolid = true'
    world = World(world_with(tmp_path, text))
    robot = world.add_robot(load_robot("ebo"))
    robot.drive(200, 0)
    for _ in range(300):
        world.step()

    assert robot.chassis.pose.x < 400 - 79 - 60
    assert ("robot", "crate") in {(event.subject, event.other) for event in world.take_events()}


def test_a_solid_prop_is_seen_by_cameras(tmp_path: Path) -> None:
    world = World(world_with(tmp_path, '[[prop]]\nkind = "barrel"\nx = 1\ny = 1\nsolid = true'))

    assert "barrel" in {surface.name for surface in world.surfaces()}


def test_bodies_come_after_all_other_things(tmp_path: Path) -> None:
    text = '[[prop]]\nkind = "ball"\nx = 0\ny = 0\nsolid = true\n[[box]]\nx = 300\ny = 0'

    assert [thing.name for thing in things(world_with(tmp_path, text))] == ["box", "ball"]


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('kind = "dragon"', "dragon"),
        ('kind = "tree"\nscale = 9', "scale"),
        ('kind = "tree"\nx = 9000', "x"),
    ],
)
def test_a_wrong_prop_is_refused_with_its_place(tmp_path: Path, line: str, told: str) -> None:
    text = line if "x =" in line else f"{line}\nx = 0"
    with pytest.raises(WorldError) as caught:
        world_with(tmp_path, f"[[prop]]\n{text}\ny = 0")

    assert "prop[1]" in str(caught.value)
    assert told in str(caught.value)


def test_props_may_stand_around_the_floor(tmp_path: Path) -> None:
    world = world_with(tmp_path, '[[prop]]\nkind = "house"\nx = 2000\ny = 0')

    assert world.prop[0].x == 2000
