import math

import numpy as np
import pytest

from learnblock.simulator import CameraModel, CameraPose, Surface, World, load_world, render
from learnblock.simulator.floor import Floor
from learnblock.simulator.geometry import Pose
from learnblock.simulator.scenery import Solid, scenery, solid
from learnblock.simulator.world_description import (
    Box,
    Cylinder,
    Face,
    Tag,
    Wall,
    WorldDescription,
)
from learnblock.simulator.world_description import Floor as FloorDescription


def surfaces(**things: object) -> list[Surface]:
    """Return the objects on a floor without a border."""
    world = WorldDescription(floor=FloorDescription(border=0.0), **things)  # type: ignore[arg-type]
    return scenery(world, Floor(world))[1:]


def normal(surface: Surface) -> np.ndarray:
    """Return the normal of a surface, on the side of its front."""
    top_left, top_right, _, bottom_left = surface.corners
    return np.cross(bottom_left - top_left, top_right - top_left)


@pytest.mark.parametrize(
    "thing", [Box(x=0.0, y=0.0, heading=30.0), Cylinder(x=0.0, y=0.0)], ids=["box", "cylinder"]
)
def test_the_fronts_of_a_solid_face_outwards(thing: Box | Cylinder) -> None:
    middle = np.array([300, -200, 50])

    for surface in solid(thing).at(Pose(300, -200, 77)):
        assert normal(surface) @ (surface.corners.mean(axis=0) - middle) > 0


def test_the_surfaces_of_a_box_cover_its_sides_and_its_top() -> None:
    areas = [
        np.linalg.norm(normal(surface))
        for surface in surfaces(box=(Box(x=0.0, y=0.0, length=30.0, width=20.0, height=10.0),))
    ]

    assert sorted(round(area) for area in areas) == [200, 200, 300, 300, 600]


def test_the_top_of_a_cylinder_is_covered() -> None:
    tops = [
        surface
        for surface in solid(Cylinder(x=0.0, y=0.0, radius=100.0)).at(Pose(0, 0, 0))
        if np.ptp(surface.corners[:, 2]) == 0
    ]
    picture = render(tops, CameraModel(101, 101, 100), CameraPose(0, 0, 300, 0, -90), (0, 0, 0))

    # The twelve-sided top has a radius of 100 mm at 200 mm from the lens, 50 pixels.
    seen = (picture.max(axis=2) > 0).sum()
    assert seen == pytest.approx(12 / 2 * math.sin(math.radians(30)) * 50**2, rel=0.02)


def test_a_box_is_turned_by_its_heading() -> None:
    (box,) = (Box(x=0.0, y=0.0, heading=90.0, length=200.0, width=40.0),)
    corners = np.concatenate([surface.corners for surface in surfaces(box=(box,))])

    assert np.ptp(corners, axis=0) == pytest.approx((40, 200, 100))


def test_a_wall_follows_its_points_with_closed_corners() -> None:
    wall = Wall(points=((0.0, 0.0), (300.0, 0.0), (300.0, 300.0)), thickness=20.0)
    corners = np.concatenate([surface.corners for surface in surfaces(wall=(wall,))])

    assert corners.min(axis=0) == pytest.approx((-10, -10, 0))
    assert corners.max(axis=0) == pytest.approx((310, 310, 100))


@pytest.mark.parametrize("heading", [0, 90, 180, -120])
def test_a_poster_can_be_read_from_its_front_and_is_plain_behind(heading: float) -> None:
    board = Tag(id=1, x=0.0, y=0.0, heading=heading, z=100.0, size=200.0)
    x, y = math.cos(math.radians(heading)) * 400, -math.sin(math.radians(heading)) * 400
    model = CameraModel(100, 100, 150)
    front = render(surfaces(tag=(board,)), model, CameraPose(x, y, 100, heading + 180))
    behind = render(surfaces(tag=(board,)), model, CameraPose(-x, -y, 100, heading))

    assert front[30:70, 30:70].min() < 20
    assert behind[30:70, 30:70].std(axis=(0, 1)).max() < 1


def test_a_poster_hangs_upright_and_unmirrored() -> None:
    from learnblock.simulator import textures

    face = Face(emotion="joy", x=500.0, y=0.0, heading=180.0, z=100.0, size=200.0)
    seen = render(surfaces(face=(face,)), CameraModel(100, 100, 250), CameraPose(0, 0, 100))
    expected = textures.face("joy", 100)

    assert np.abs(seen.astype(int) * 1.0 - expected).mean() < 40
    assert (
        np.abs(seen.astype(int) - expected).mean()
        < np.abs(seen[:, ::-1].astype(int) - expected).mean()
    )


def test_a_moved_solid_keeps_its_picture() -> None:
    box = Solid([(10, -10), (10, 10), (-10, 10), (-10, -10)], 20, (9, 8, 7))
    first, second = (list(box.at(Pose(x, 0, 0))) for x in (0, 100))

    assert first[0].texture is second[0].texture
    assert (second[0].corners - first[0].corners)[:, 0] == pytest.approx(100)


def test_the_floor_has_north_up() -> None:
    world = World(load_world("line"))
    (floor,) = [surface for surface in world.surfaces() if surface.name == "floor"]

    assert floor.corners[0] == pytest.approx((-1000, 1000, 0))
    assert normal(floor)[2] > 0
