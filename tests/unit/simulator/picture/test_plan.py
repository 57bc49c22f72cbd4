import math

import cv2
import numpy as np
import pytest

from learnblock.simulator.goal_description import Goals, Reach, Show, Stop, Tour
from learnblock.simulator.picture import plan
from learnblock.simulator.picture.svg import Circle, Polygon, Polyline, SvgImage, SvgText
from learnblock.simulator.picture.view import fitted
from learnblock.simulator.world_description import (
    Box,
    Cylinder,
    Face,
    Floor,
    Lamp,
    Tag,
    Wall,
    WorldDescription,
)

NOWHERE = np.empty((0, 2))
VIEW = fitted((2000, 2000), NOWHERE, bar=True)


def shapes(**parts):
    return list(plan.drawn(WorldDescription(**parts), VIEW))


def test_a_tag_is_shown_with_its_picture_and_its_number():
    drawn = shapes(tag=[Tag(id=7, x=0, y=0, heading=0)])
    assert 1 == len([shape for shape in drawn if isinstance(shape, SvgImage)])
    assert ["tag 7"] == [shape.text for shape in drawn if isinstance(shape, SvgText)]


@pytest.mark.parametrize("heading", range(-180, 180, 30))
def test_a_boards_picture_is_behind_the_board(heading):
    face = Face(emotion="joy", x=100, y=50, heading=heading)
    (x, y), side = plan.board_picture(face, VIEW)
    board_x, board_y = VIEW.at(100, 50)
    ahead = (math.cos(math.radians(heading)), math.sin(math.radians(heading)))
    for corner_x in (x - side / 2, x + side / 2):
        for corner_y in (y - side / 2, y + side / 2):
            assert (corner_x - board_x) * ahead[0] + (corner_y - board_y) * ahead[1] < 0


def test_a_box_is_drawn_turned_and_at_its_scale():
    box = Box(x=100, y=200, heading=90, length=200, width=50, colour="blue")
    corners = np.array(plan.outline(box, VIEW))
    assert [50 * VIEW.scale, 200 * VIEW.scale] == pytest.approx(np.ptp(corners, axis=0).tolist())
    assert VIEW.at(100, 200) == pytest.approx(corners.mean(axis=0))


def test_an_object_that_can_be_pushed_has_a_dashed_edge():
    fixed, light = Cylinder(x=0, y=0), Cylinder(x=0, y=0, mass=0.1)
    assert () == shapes(cylinder=[fixed])[-1].paint.dash
    assert shapes(cylinder=[light])[-1].paint.dash


def test_a_wall_is_as_thick_as_described():
    drawn = shapes(wall=[Wall(points=[(0, 0), (500, 0)], thickness=60, colour="red")])
    wall = drawn[-1]
    assert isinstance(wall, Polyline)
    assert 60 * VIEW.scale == pytest.approx(wall.width)
    assert "square" == wall.cap


def test_a_region_to_reach_is_outlined():
    drawn = shapes(goal=Goals(reach=[Reach(x=100, y=100, radius=120)]))
    rings = [shape for shape in drawn if isinstance(shape, Circle) and shape.paint.dash]
    assert [120 * VIEW.scale] == pytest.approx([ring.radius for ring in rings])


def test_every_round_region_of_a_goal_is_outlined_at_its_place():
    regions = Goals(
        stop=[Stop(x=100, y=0, radius=50)],
        show=[Show(emotion="joy", x=300, y=0, radius=80), Show(emotion="fear", name="anywhere")],
        tour=[Tour(points=[(0, 0), (0, 500)], radius=60)],
    )
    rings = [one for one in shapes(goal=regions) if isinstance(one, Circle) and one.paint.dash]
    radii = [round(ring.radius / VIEW.scale) for ring in rings]
    assert [50, 80, 60, 60] == radii
    assert VIEW.at(0, 500) == pytest.approx(rings[-1].center)


def test_a_lamp_shines_where_it_hangs():
    drawn = shapes(light=[Lamp(x=300, y=-200)])
    assert VIEW.at(300, -200) == pytest.approx(drawn[-1].center)


def test_a_floors_picture_is_shown_no_larger_than_needed(tmp_path):
    cv2.imwrite(str(tmp_path / "floor.png"), np.full((40, 60, 3), 128, np.uint8))
    floor = Floor(size=(3000, 2000), picture="floor.png")
    world = WorldDescription(floor=floor, folder=str(tmp_path))
    view = fitted(floor.size, NOWHERE, bar=True)
    [image] = [shape for shape in plan.drawn(world, view) if isinstance(shape, SvgImage)]
    assert image.size == pytest.approx((3000 * view.scale, 2000 * view.scale))
    assert image.pixels.shape[1] <= 2 * image.size[0] + 1


def test_a_floor_without_a_border_has_an_open_edge():
    def grounds(border: float) -> int:
        drawn = shapes(floor=Floor(border=border))
        return len([shape for shape in drawn if isinstance(shape, Polygon)])

    assert grounds(border=0) < grounds(border=100)


@pytest.mark.parametrize("size", [(2000, 2000), (1250, 830)])
def test_half_of_a_floor_are_squares_of_another_colour(size):
    world = WorldDescription(floor=Floor(size=size))
    view = fitted(size, NOWHERE, bar=True)
    rows = [one for one in plan.drawn(world, view) if isinstance(one, Polyline) and one.dash]
    squares = sum(row.width * sum(row.dash[::2]) for row in rows)

    assert squares == pytest.approx(size[0] * size[1] * view.scale**2 / 2, rel=0.01)
    assert [sum(row.dash) for row in rows] == pytest.approx([size[0] * view.scale] * len(rows))
