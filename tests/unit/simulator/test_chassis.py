import math

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.simulator import RobotBody, RobotDescription, World, load_robot, load_world
from learnblock.simulator.robot_description import Wheels
from learnblock.simulator.world_description import Box, WorldDescription


def exact(name: str = "thymio", acceleration: float = 50_000) -> RobotDescription:
    """A robot with equal wheels that accelerates instantly."""
    robot = load_robot(name)
    wheels: Wheels = msgspec.structs.replace(robot.wheels, error=0.0, acceleration=acceleration)
    return msgspec.structs.replace(robot, wheels=wheels)


def run(world: World, seconds: float) -> None:
    for _ in range(round(seconds / world.dt)):
        world.step()


def alone(
    description: RobotDescription, start: tuple[float, float, float] = (0, 0, 0)
) -> tuple[World, RobotBody]:
    world = World(floor_with(slip=0.0))
    return world, world.add_robot(description, start=start)


def floor_with(*, slip: float) -> WorldDescription:
    world = load_world("empty")
    return msgspec.structs.replace(world, floor=msgspec.structs.replace(world.floor, slip=slip))


def test_driving_forward_at_heading_0_goes_east() -> None:
    world, robot = alone(exact())
    robot.drive(100, 0)
    run(world, 3)

    assert robot.pose == pytest.approx((300, 0, 0), abs=2)
    assert robot.distance_driven == pytest.approx(300, abs=2)


def test_a_positive_rotation_turns_right() -> None:
    world, robot = alone(exact())
    robot.drive(0, 45)
    run(world, 2)

    assert robot.pose == pytest.approx((0, 0, 90), abs=1)


def test_a_driven_circle_has_the_radius_of_its_speeds() -> None:
    world, robot = alone(exact())
    robot.drive(100, 45)
    run(world, 4)

    # Radius 100 / radians(45) = 127 mm to the right; half a circle, so two radii to the south.
    assert robot.pose[0] == pytest.approx(0, abs=2)
    assert robot.pose[1] == pytest.approx(-2 * 100 / math.radians(45), abs=1)


def test_ten_circles_end_where_they_began() -> None:
    world, robot = alone(exact())
    robot.drive(50, 90)
    run(world, 40)

    assert robot.pose[:2] == pytest.approx((0, 0), abs=2)


@settings(max_examples=25)
@given(st.floats(-150, 150), st.floats(-90, 90))
def test_driving_back_undoes_driving(adv: float, rot: float) -> None:
    world, robot = alone(exact())
    robot.drive(adv, rot)
    run(world, 1)
    robot.drive(-adv, -rot)
    run(world, 1)
    robot.drive(0, 0)
    run(world, 0.1)

    assert robot.pose == pytest.approx((0, 0, 0), abs=3)


def test_no_wheel_exceeds_its_limit() -> None:
    world, robot = alone(exact())
    robot.drive(1000, 0)
    run(world, 2)

    assert robot.pose[0] == pytest.approx(2 * 167, abs=3)


def test_a_curve_that_is_too_fast_is_driven_slower_with_the_same_shape() -> None:
    world, robot = alone(exact())
    robot.drive(1000, 450)
    run(world, 1)
    distances = [math.hypot(robot.pose[0], robot.pose[1] + 1000 / math.radians(450))]

    assert distances == [pytest.approx(1000 / math.radians(450), abs=2)]


def test_speed_is_reached_with_limited_acceleration() -> None:
    world, robot = alone(exact(acceleration=100))
    robot.drive(100, 0)
    run(world, 1)

    assert robot.pose[0] == pytest.approx(50, abs=2)


def test_a_wall_stops_a_robot_at_its_hull() -> None:
    world, robot = alone(exact("ebo"), (800, 0, 0))
    robot.drive(200, 0)
    run(world, 3)

    assert robot.pose == pytest.approx((1000 - 75, 0, 0), abs=1)
    assert robot.distance_driven == pytest.approx(125, abs=4)


def test_a_robot_pushes_a_light_box_and_not_a_heavy_one() -> None:
    boxes = (
        Box(x=300.0, y=500.0, mass=0.1, name="light"),
        Box(x=300.0, y=-500.0, mass=20.0, name="heavy"),
    )
    world = World(WorldDescription(box=boxes))
    for name, y in (("a", 500), ("b", -500)):
        world.add_robot(exact("ebo"), name, (100, y, 0)).drive(100, 0)
    run(world, 4)
    light, heavy = (pushed.pose for pushed in world.physics.pushed)

    assert light.x > 400
    assert heavy.x == pytest.approx(300, abs=1)


def test_a_pushed_box_stops_when_the_push_ends() -> None:
    world = World(WorldDescription(box=(Box(x=300.0, y=0.0, mass=0.1),)))
    robot = world.add_robot(exact("ebo"), start=(100, 0, 0))
    robot.drive(200, 0)
    run(world, 2)
    robot.drive(-200, 0)
    run(world, 1)
    before = world.physics.pushed[0].pose
    run(world, 1)

    assert world.physics.pushed[0].pose == before


def test_two_robots_bump_into_each_other() -> None:
    world = World(load_world("empty"))
    left = world.add_robot(exact("ebo"), "left", (-300, 0, 0))
    right = world.add_robot(exact("ebo"), "right", (300, 0, 180))
    left.drive(100, 0)
    right.drive(100, 0)
    run(world, 5)

    assert right.pose[0] - left.pose[0] == pytest.approx(150, abs=1)


def test_a_placed_robot_is_at_rest_and_has_not_driven() -> None:
    world, robot = alone(exact())
    robot.drive(100, 0)
    run(world, 1)
    driven = robot.distance_driven
    robot.drive(0, 0)
    robot.place(500, 500, 90)
    run(world, 1)

    assert robot.pose == pytest.approx((500, 500, 90))
    assert robot.distance_driven == driven


def test_a_heading_stays_between_minus_180_and_180() -> None:
    world, robot = alone(exact())
    robot.drive(0, 90)
    run(world, 3)

    assert robot.pose[2] == pytest.approx(-90, abs=2)


def test_wheels_differ_from_seed_to_seed_by_less_than_a_percent() -> None:
    headings = []
    for seed in range(5):
        world = World(load_world("empty"), seed)
        robot = world.add_robot(load_robot("thymio"), start=(-500, 0, 0))
        robot.drive(100, 0)
        run(world, 5)
        headings.append(robot.pose[2])

    assert len(set(headings)) == 5
    # One wheel 1 % larger than the other would turn it by 0.01 * 500 mm / 95 mm, or 3 degrees.
    assert max(map(abs, headings)) < 3


@pytest.mark.parametrize("speeds", [(math.nan, 0), (0, math.inf)])
def test_a_speed_that_is_not_a_number_is_refused(speeds: tuple[float, float]) -> None:
    _, robot = alone(exact())

    with pytest.raises(ValueError, match="expected a finite number"):
        robot.drive(*speeds)


def driven(slip: float, seed: int = 0) -> RobotBody:
    """A robot after a straight way of 500 mm by its wheels."""
    world = World(floor_with(slip=slip), seed=seed)
    robot = world.add_robot(exact(), start=(0, 0, 0))
    robot.drive(100, 0)
    run(world, 5)
    return robot


def test_slip_loses_its_part_of_the_way_on_average() -> None:
    robots = [driven(0.1, seed) for seed in range(20)]

    assert sum(robot.pose[0] for robot in robots) / 20 == pytest.approx(450, abs=3)
    assert len({robot.pose for robot in robots}) == 20


def test_encoders_do_not_notice_slip() -> None:
    robot = driven(0.2)

    assert robot.odometry == pytest.approx((500, 0, 0), abs=0.001)
    assert robot.wheels_rolled == pytest.approx((500, 500))


def test_odometry_follows_curves_exactly_without_slip() -> None:
    world, robot = alone(exact())
    for adv, rot in ((100, 45), (80, -60), (0, 90), (-50, 10)):
        robot.drive(adv, rot)
        run(world, 1)

    assert robot.odometry == pytest.approx(robot.pose, abs=1)


def test_odometry_does_not_depend_on_how_often_it_is_read() -> None:
    _, once = alone(exact())
    world, often = alone(exact())
    for robot, reads in ((once, False), (often, True)):
        world = robot._world
        for speed in (60, 30, 90):
            robot.drive(speed, speed / 2)
            for _ in range(50):
                world.step()
                assert not reads or len(robot.odometry) == 3

    assert once.odometry == pytest.approx(often.odometry, abs=1e-9)


SPEEDS = st.tuples(st.sampled_from([0.0, -0.0, 40.0, 900.0]), st.floats(-90, 90))


@given(st.lists(SPEEDS, max_size=6))
@settings(max_examples=20, deadline=None)
def test_the_same_command_again_changes_nothing(commands: list[tuple[float, float]]) -> None:
    once, often = (alone(exact()) for _ in range(2))
    for speeds in commands:
        for (world, robot), times in ((once, 1), (often, 3)):
            for _ in range(times):
                robot.drive(*speeds)
            run(world, 0.05)
    assert once[0].state == often[0].state


def test_a_command_after_a_hand_has_moved_the_robot_is_obeyed() -> None:
    world, robot = alone(exact())
    robot.drive(40, 0)
    run(world, 1)
    robot.place(0, 0, 0)
    robot.drive(40, 0)
    run(world, 1)
    assert robot.pose[0] > 30
