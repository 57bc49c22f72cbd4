import math
from itertools import pairwise

import pytest

from learnblock.simulator import World, load_robot
from learnblock.simulator.drawing import (
    MOST_POINTS,
    PEN_COLOUR,
    SPACING,
    Drawing,
    DrawingPen,
    PenStroke,
)
from learnblock.simulator.geometry import Pose
from learnblock.simulator.world_description import WorldDescription


@pytest.fixture
def world() -> World:
    return World(WorldDescription())


def robot_in(world: World, name: str = "robot", start: tuple[float, float, float] = (0, 0, 0)):
    return world.add_robot(load_robot("ebo"), name, start)


def run(world: World, seconds: float) -> None:
    for _ in range(round(seconds / world.dt)):
        world.step()


class Hand:
    """A pen that is moved by hand."""

    def __init__(self) -> None:
        self.drawing = Drawing()
        self.pose = Pose(0, 0, 0)
        self.pen = DrawingPen(self.drawing, "robot", lambda: self.pose)

    def move(self, x: float, y: float) -> None:
        self.pose = Pose(x, y, 0)
        self.drawing.extend()

    @property
    def lines(self) -> list[list[tuple[float, float]]]:
        return [stroke.points for stroke in self.drawing.strokes]


@pytest.fixture
def hand() -> Hand:
    return Hand()


def test_a_pen_that_is_up_draws_nothing(hand: Hand) -> None:
    hand.move(100, 0)
    assert hand.lines == []


def test_a_pen_draws_from_where_it_is_put_down_to_where_it_is_lifted(hand: Hand) -> None:
    hand.move(10, 0)
    hand.pen.set(True)
    hand.move(20, 0)
    hand.move(21, 0)
    hand.pen.set(False)
    hand.move(90, 90)
    assert hand.lines == [[(10, 0), (20, 0), (21, 0)]]


def test_points_are_no_nearer_to_each_other_than_the_spacing(hand: Hand) -> None:
    hand.pen.set(True)
    for step in range(1000):
        hand.move(step * 0.1, 0)
    (line,) = hand.lines
    ways = [math.dist(a, b) for a, b in pairwise(line)]
    assert min(ways) >= SPACING - 0.1
    assert max(ways) <= SPACING + 0.1


def test_another_colour_or_width_begins_another_stroke_where_the_pen_is(hand: Hand) -> None:
    hand.pen.set(True)
    hand.move(10, 0)
    hand.pen.set_color(200, 0, 0)
    hand.move(20, 0)
    hand.pen.set_width(9)
    hand.move(30, 0)
    assert hand.lines == [[(0, 0), (10, 0)], [(10, 0), (20, 0)], [(20, 0), (30, 0)]]
    looks = [(stroke.colour, stroke.width) for stroke in hand.drawing.strokes]
    assert looks == [(PEN_COLOUR, 6), ((200, 0, 0), 6), ((200, 0, 0), 9)]


def test_the_same_colour_again_goes_on_with_the_stroke(hand: Hand) -> None:
    hand.pen.set(True)
    hand.pen.set_color(*PEN_COLOUR)
    hand.pen.set(True)
    assert len(hand.lines) == 1


@pytest.mark.parametrize(("width", "drawn"), [(0, 1), (-5, 1), (7.5, 7.5), (1e9, 50)])
def test_the_width_of_a_pen_is_limited(hand: Hand, width: float, drawn: float) -> None:
    hand.pen.set_width(width)
    hand.pen.set(True)
    assert hand.drawing.strokes[0].width == drawn


def test_erasing_removes_the_strokes_of_one_robot_and_its_pen_goes_on(hand: Hand) -> None:
    other = PenStroke("other", PEN_COLOUR, 6)
    hand.drawing.add(other, 5, 5)
    hand.pen.set(True)
    hand.move(10, 0)
    hand.pen.clear()
    hand.move(20, 0)
    assert hand.lines == [[(5, 5)], [(10, 0), (20, 0)]]


def test_a_drawing_is_limited_and_reports_it_once(hand: Hand) -> None:
    hand.pen.set(True)
    for step in range(MOST_POINTS + 10):
        hand.move(step * 4, 0)
    assert len(hand.lines[0]) == MOST_POINTS
    assert hand.drawing.unable == ["robot"]


def test_a_full_drawing_takes_no_new_stroke_until_it_is_erased(hand: Hand) -> None:
    hand.pen.set(True)
    for step in range(MOST_POINTS + 10):
        hand.move(step * 4, 0)
    hand.pen.set(False)
    hand.pen.set(True)
    assert len(hand.lines) == 1
    hand.pen.clear()
    assert [len(line) for line in hand.lines] == [1]


def test_a_robot_draws_at_the_middle_between_its_wheels(world: World) -> None:
    robot = robot_in(world)
    robot.pen.set(True)
    robot.drive(100, 0)
    run(world, 2)
    robot.pen.set(False)
    (stroke,) = world.drawing.strokes
    assert stroke.points[0] == (0, 0)
    assert stroke.points[-1] == pytest.approx(robot.pose[:2], abs=0.1)


def test_a_robot_that_is_set_down_elsewhere_draws_no_line_there(world: World) -> None:
    robot = robot_in(world)
    robot.pen.set(True)
    robot.place(300, 0, 0)
    run(world, 0.1)
    assert [stroke.points for stroke in world.drawing.strokes] == [[(0, 0)], [(300, 0)]]


def test_the_stroke_of_a_robot_ends_with_its_program(world: World) -> None:
    robot = robot_in(world)
    robot.pen.set(True)
    robot.drive(100, 0)
    run(world, 1)
    world.finish("robot")
    assert world.drawing.ended == world.drawing.strokes
    assert world.drawing.pens == {}


def test_several_robots_draw_on_one_floor(world: World) -> None:
    for name, start in (("a", (0, 0, 0)), ("b", (0, 400, 0))):
        robot = robot_in(world, name, start)
        robot.pen.set(True)
        robot.drive(100, 0)
    run(world, 1)
    assert [stroke.robot for stroke in world.drawing.strokes] == ["a", "b"]


def test_sensors_do_not_see_a_drawing() -> None:
    readings = []
    for draws in (False, True):
        world = World(WorldDescription())
        robot = world.add_robot(load_robot("thymio"), start=(0, 0, 0))
        robot.pen.set_color(0, 0, 0)
        robot.pen.set_width(50)
        robot.pen.set(draws)
        robot.drive(100, 0)
        run(world, 2)
        readings.append((robot.ground(), robot.pose, world.floor_at(100, 0)))
    assert readings[0] == readings[1]
