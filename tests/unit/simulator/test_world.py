import math
import random

import numpy as np
import pytest

from learnblock.errors import KeyTakenError, UnknownNameError, WorldError
from learnblock.i18n import Phrase
from learnblock.simulator import World, WorldEvent, load_robot, load_world, world_names
from learnblock.simulator.world_description import Floor, Lamp, WorldDescription


def run(world: World, seconds: float) -> None:
    for _ in range(round(seconds / world.dt)):
        world.step()


def wander(world: World, robots: int, seconds: float) -> list[object]:
    """Drive robots at random, the same way each time, and return their states."""
    names = ("ebo", "thymio", "ev3", "cozmo")
    bodies = [world.add_robot(load_robot(names[i % 4]), f"robot {i}") for i in range(robots)]
    chances = [random.Random(i) for i in range(robots)]  # noqa: S311 - no secrets
    trace: list[object] = []
    for _ in range(round(seconds * 2)):
        for body, chance in zip(bodies, chances, strict=True):
            body.drive(chance.uniform(-50, 200), chance.uniform(-90, 90))
        run(world, 0.5)
        trace.append([(body.pose, body.distances(), body.ground()) for body in bodies])
    return [*trace, world.take_events()]


@pytest.mark.parametrize("name", ["obstacles", "line-and-box", "tags"])
def test_the_same_world_seed_and_commands_give_the_same_run(name: str) -> None:
    runs = [wander(World(load_world(name), seed=7), robots=5, seconds=10) for _ in range(2)]

    assert runs[0] == runs[1]


def test_another_seed_gives_another_run() -> None:
    runs = [wander(World(load_world("empty"), seed), robots=1, seconds=3) for seed in (1, 2)]

    assert runs[0] != runs[1]


def test_another_robot_far_away_changes_nothing_for_the_first() -> None:
    traces = []
    for others in (0, 1):
        world = World(load_world("empty"), seed=3)
        robot = world.add_robot(load_robot("ebo"), start=(0, 500, 0))
        for i in range(others):
            world.add_robot(load_robot("ebo"), f"other {i}", (0, -700, 180)).drive(30, 0)
        robot.drive(60, 10)
        run(world, 3)
        traces.append((robot.pose, robot.distances()["left"]))

    assert traces[0] == traces[1]


def test_reading_changes_nothing() -> None:
    poses = []
    for reads in (0, 3):
        world = World(load_world("obstacles"))
        robot = world.add_robot(load_robot("cozmo"))
        robot.drive(80, 20)
        for _ in range(200):
            world.step()
            for _ in range(reads):
                robot.gyroscope(), robot.ground(), robot.acceleration()
        poses.append((robot.pose, robot.gyroscope()))

    assert poses[0] == poses[1]


def test_time_is_the_rounded_product_of_steps_and_dt() -> None:
    world = World(load_world("empty"))
    times = []
    for _ in range(300):
        world.step()
        times.append(world.time)

    assert times == [round(0.01 * step, 2) for step in range(1, 301)]


def test_robots_take_the_start_poses_in_order() -> None:
    world = World(load_world("walls"))
    first, second = (world.add_robot(load_robot("cozmo"), name) for name in "ab")

    assert first.pose == (-700, 0, 0)
    assert second.pose == (700, -500, -90)


def test_a_robot_may_choose_a_start_pose_by_name() -> None:
    world = World(load_world("walls"))

    assert world.add_robot(load_robot("cozmo"), start="east").pose == (700, -500, -90)


def test_an_unknown_start_pose_gets_a_suggestion() -> None:
    world = World(load_world("walls"))

    with pytest.raises(UnknownNameError, match="Did you mean 'east'"):
        world.add_robot(load_robot("cozmo"), start="eest")


def test_thirty_robots_find_room_side_by_side() -> None:
    world = World(load_world("empty"))
    for i in range(30):
        world.add_robot(load_robot("ebo"), f"robot {i}")
    places = [np.array(robot.pose[:2]) for robot in world.robots.values()]
    gaps = [math.dist(a, b) for i, a in enumerate(places) for b in places[:i]]
    world.step()

    assert min(gaps) > 150
    assert world.take_events() == []


def test_a_full_floor_accepts_no_more_robots() -> None:
    world = World(WorldDescription(floor=Floor(size=(300.0, 300.0)), name="tiny"))

    world.add_robot(load_robot("ebo"), "first")

    with pytest.raises(WorldError) as refused:
        world.add_robot(load_robot("ebo"), "second")

    (problem,) = refused.value.diagnostics
    assert problem.message == Phrase("world-no-room", world="tiny")


def test_two_robots_cannot_share_a_name() -> None:
    world = World(load_world("empty"))
    world.add_robot(load_robot("ebo"), "me")

    with pytest.raises(KeyTakenError) as refused:
        world.add_robot(load_robot("ebo"), "me")

    assert refused.value.phrase == Phrase("world-robot-taken", name="me")


def test_a_collision_is_reported_once_when_it_begins() -> None:
    world = World(load_world("empty"))
    robot = world.add_robot(load_robot("ebo"), "me", (850, 0, 0))
    robot.drive(100, 0)
    run(world, 3)

    (event,) = world.take_events()

    assert event == WorldEvent(event.time, "collision", "me", "border")
    # 75 mm at 100 mm/s, and a little for accelerating.
    assert event.time == pytest.approx(0.8, abs=0.05)
    assert world.take_events() == []


def test_a_collision_of_two_robots_is_one_event() -> None:
    world = World(load_world("empty"))
    for name, x, heading in (("b", -200, 0), ("a", 200, 180)):
        world.add_robot(load_robot("ebo"), name, (x, 0, heading)).drive(100, 0)
    run(world, 3)

    told = [(event.subject, event.other) for event in world.take_events()]

    assert told == [("a", "b")]


def test_light_falls_off_with_the_distance_squared() -> None:
    lamp = Lamp(x=0.0, y=0.0, z=500.0, brightness=400.0)
    world = World(WorldDescription(ambient_light=0.0, light=(lamp,)))

    levels = [world.light_at(x, 0) for x in (0, 500, 1000)]

    assert levels == [400, 200, 80]


def test_a_robot_sees_everything_but_itself() -> None:
    world = World(load_world("obstacles"))
    for name in ("a", "b"):
        world.add_robot(load_robot("ebo"), name)
    everything = {surface.name for surface in world.surfaces()}

    assert {"floor", "border", "box", "light box", "cylinder", "a", "b"} <= everything
    assert everything - {"a"} == {surface.name for surface in world.surfaces(without="a")}


@pytest.mark.parametrize("name", world_names())
def test_every_robot_finds_a_start_in_every_shipped_world_and_touches_nothing(name: str) -> None:
    for robot in ("ebo", "thymio", "ev3", "cozmo"):
        world = World(load_world(name))
        start = world.description.start[0]
        body = world.add_robot(load_robot(robot))
        run(world, 0.1)

        assert body.pose == pytest.approx((start.x, start.y, (start.heading + 180) % 360 - 180))
        assert world.take_events() == []


def test_thymio_follows_the_line_for_a_lap_by_its_two_ground_sensors() -> None:
    world = World(load_world("line"), seed=5)
    robot = world.add_robot(load_robot("thymio"))
    while world.goals[0].is_open and world.time < 120:
        ground = robot.ground()
        left, right = (ground["left"] or 0) < 50, (ground["right"] or 0) < 50
        robot.drive(80, 40 * (right - left))
        run(world, 0.05)

    assert world.goals[0].robot == "robot"
    assert world.goals[0].reached_at == pytest.approx(robot.distance_driven / 80, rel=0.05)
