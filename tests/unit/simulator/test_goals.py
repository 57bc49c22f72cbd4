import math
from typing import Any

import pytest

from learnblock.simulator.geometry import Pose
from learnblock.simulator.goal import Goal, GoalState, RobotState
from learnblock.simulator.goal_description import (
    AnyGoal,
    Avoid,
    Follow,
    Goals,
    Reach,
    Show,
    Stop,
    Tour,
    Visit,
)
from learnblock.simulator.goals import goals
from learnblock.simulator.physics import Physics
from learnblock.simulator.world_description import Cylinder, Line, Part, Tag, WorldDescription

TRACK = Line(
    closed=True,
    path=(
        Part(forward=400.0),
        Part(turn=180.0, radius=200.0),
        Part(forward=400.0),
        Part(turn=180.0, radius=200.0),
    ),
)
TAG = Tag(id=1, x=500.0, y=0.0, heading=180.0)


def only(goal: AnyGoal) -> Goal:
    """Return the goal in a world with a track and a tag."""
    kind = type(goal).__name__.lower()
    world = WorldDescription(line=(TRACK,), tag=(TAG,), goal=Goals(**{kind: (goal,)}))
    (made,) = goals(world)
    return made


def look(goal: Goal, time: float, **poses: Pose) -> None:
    goal.look(time, [RobotState(name, time, pose) for name, pose in poses.items()])


def stand(goal: Goal, times: range, pose: Pose) -> None:
    """Check a goal every 50 ms while a robot stands still."""
    for tick in times:
        look(goal, tick / 20, a=pose)


def lap(parts: float, offset: float = 0.0) -> list[Pose]:
    """Return a path along the track in steps of about 10 mm, `offset` mm inside it."""
    line = TRACK.polyline()
    poses = []
    for (x, y), (to_x, to_y) in zip(line.points, line.points[1:], strict=False):
        length = math.hypot(to_x - x, to_y - y)
        count = max(1, round(length / 10))
        heading = -math.degrees(math.atan2(to_y - y, to_x - x))
        for i in range(count):
            at = Pose(x + (to_x - x) * i / count, y + (to_y - y) * i / count, heading + 90)
            poses.append(at.ahead(offset))
    return poses[: round(len(poses) * parts)]


def test_a_region_is_reached_when_a_robot_is_in_it() -> None:
    goal = only(Reach(x=100.0, y=100.0, radius=50.0))
    look(goal, 1.0, a=Pose(100, 151, 0))
    before = goal.state
    look(goal, 2.0, a=Pose(100, 149, 0))

    assert before.is_open
    assert goal.state == GoalState("reach", "reach", 1.0, reached_at=2.0, robot="a")


def test_a_goal_for_one_robot_is_not_reached_by_another() -> None:
    goal = only(Reach(x=0.0, y=0.0, robot="b"))
    look(goal, 1.0, a=Pose(0, 0, 0), b=Pose(900, 0, 0))

    assert goal.state.is_open


def test_a_goal_fails_when_its_time_is_over_and_stays_so() -> None:
    goal = only(Reach(x=0.0, y=0.0, time_limit=5.0))
    look(goal, 4.95, a=Pose(900, 0, 0))
    before = goal.state
    look(goal, 5.0, a=Pose(900, 0, 0))
    look(goal, 6.0, a=Pose(0, 0, 0))

    assert before.is_open
    assert goal.state.failed_at == 5.0
    assert goal.state.reached_at is None


@pytest.mark.parametrize("backwards", [False, True])
def test_a_lap_in_either_direction_follows_a_line(backwards: bool) -> None:
    goal = only(Follow())
    way = [*lap(1.0), lap(1.0)[0]]
    for i, pose in enumerate(reversed(way) if backwards else way):
        look(goal, i * 0.05, a=pose)

    assert goal.state.reached_at == pytest.approx(len(way) * 0.05, rel=0.03)


def test_half_a_lap_is_half_of_the_progress() -> None:
    goal = only(Follow())
    for pose in lap(0.5):
        look(goal, 0.0, a=pose)

    assert goal.state.progress == pytest.approx(0.5, abs=0.02)
    assert goal.state.is_open


def test_a_fraction_of_the_line_may_be_enough() -> None:
    goal = only(Follow(fraction=0.45))
    for pose in lap(0.5):
        look(goal, 0.0, a=pose)

    assert goal.state.progress == 1.0


def test_too_far_from_the_line_is_not_following() -> None:
    goal = only(Follow(distance=50.0))
    for pose in lap(1.0, offset=60):
        look(goal, 0.0, a=pose)

    assert goal.state.progress == 0.0


def test_a_robot_carried_along_the_line_has_not_followed_it() -> None:
    goal = only(Follow())
    for pose in (lap(1.0)[0], lap(1.0)[60], lap(1.0)[120]):
        look(goal, 0.0, a=pose)

    assert goal.state.progress < 0.05


def test_two_robots_do_not_share_a_lap() -> None:
    goal = only(Follow())
    way = lap(1.0)
    for a, b in zip(way[: len(way) // 2], way[len(way) // 2 :], strict=False):
        look(goal, 0.0, a=a, b=b)

    assert goal.state.is_open


@pytest.mark.parametrize(
    ("pose", "reached"),
    [
        (Pose(200, 0, 0), True),
        (Pose(100, 0, 0), False),  # too far away
        (Pose(200, 0, 40), False),  # faces past it
        (Pose(800, 0, 180), False),  # is behind it
        (Pose(300, 150, 37), True),  # from the side, but facing it
    ],
)
def test_a_tag_is_visited_from_near_and_in_front(pose: Pose, reached: bool) -> None:
    goal = only(Visit(id=1))
    look(goal, 1.0, a=pose)

    assert reached is not goal.state.is_open


def test_a_tour_is_made_place_by_place_in_order() -> None:
    goal = only(Tour(points=((0.0, 0.0), (100.0, 0.0), (100.0, 100.0)), radius=10.0))
    for x, y in [(100, 0), (0, 0), (100, 100), (100, 0)]:
        look(goal, 1.0, a=Pose(x, y, 0))
    before = goal.state
    look(goal, 2.0, a=Pose(105, 95, 0))

    assert before.progress == pytest.approx(2 / 3)
    assert goal.state.reached_at == 2.0


def test_a_robot_that_drives_through_a_place_has_not_stopped_there() -> None:
    goal = only(Stop(x=0.0, y=0.0, radius=50.0, seconds=1.0))
    for tick in range(40):
        look(goal, tick / 20, a=Pose(-50 + 2.5 * tick, 0, 0))

    assert goal.state.is_open


def test_a_robot_that_stands_long_enough_has_stopped() -> None:
    goal = only(Stop(x=0.0, y=0.0, radius=50.0, seconds=1.0))
    stand(goal, range(10), Pose(300, 0, 0))
    stand(goal, range(10, 100), Pose(40, 0, 0))

    assert goal.state.reached_at == pytest.approx(1.5)


@pytest.mark.parametrize(("heading", "reached"), [(92, True), (-270, True), (84, False)])
def test_a_robot_stops_in_the_direction_of_the_goal(heading: float, reached: bool) -> None:
    goal = only(Stop(x=0.0, y=0.0, heading=90.0, angle=5.0))
    stand(goal, range(40), Pose(0, 0, heading))

    assert reached is not goal.state.is_open


@pytest.mark.parametrize(
    ("emotion", "x", "reached"), [("joy", 90, True), ("joy", 110, False), ("fear", 90, False)]
)
def test_an_emotion_is_shown_in_its_region(emotion: str, x: float, reached: bool) -> None:
    goal = only(Show(emotion="joy", radius=100.0))
    goal.look(1.0, [RobotState("a", 1.0, Pose(x, 0, 0), emotion)])

    assert reached is not goal.state.is_open


def test_an_emotion_without_a_region_is_shown_anywhere() -> None:
    goal = only(Show(emotion="joy"))
    goal.look(1.0, [RobotState("a", 1.0, Pose(4000, 0, 0), "joy")])

    assert goal.state.robot == "a"


def test_a_robot_that_drives_far_enough_without_a_bump_has_avoided_everything() -> None:
    goal = only(Avoid(distance=500.0))
    for driven in range(0, 501, 100):
        goal.look(driven, [RobotState("a", driven, Pose(0, 0, 0), distance=driven)])

    assert goal.state.reached_at == 500


@pytest.mark.parametrize("mishap", [{"bumps": 1}, {"is_on_floor": False}])
def test_a_robot_that_bumps_or_leaves_the_floor_fails(mishap: dict[str, int]) -> None:
    goal = only(Avoid(distance=500.0))
    goal.look(1.0, [RobotState("a", 1.0, Pose(0, 0, 0), distance=100.0, **mishap)])
    goal.look(2.0, [RobotState("a", 2.0, Pose(0, 0, 0), distance=600.0)])

    assert goal.state.failed_at == 1.0


def test_one_of_two_robots_may_bump() -> None:
    goal = only(Avoid(distance=500.0))
    for driven in (100.0, 600.0):
        bumped = RobotState("a", driven, Pose(0, 0, 0), distance=driven, bumps=1)
        goal.look(driven, [bumped, RobotState("b", driven, Pose(0, 0, 0), distance=driven)])

    assert goal.state.robot == "b"


def in_order(first: Goal, second: Goal, pose: Pose, time: float) -> None:
    for goal in (first, second):
        look(goal, time, a=pose)


def two_regions(limit: float | None = None) -> tuple[Goal, ...]:
    """Return two goals, of which the second counts after the first."""
    there = Reach(x=300.0, y=0.0, name="there", time_limit=limit)
    back = Reach(x=0.0, y=0.0, name="back", after="there")
    return goals(WorldDescription(goal=Goals(reach=(there, back))))


def test_a_goal_counts_only_after_the_one_before_it() -> None:
    there, back = two_regions()
    in_order(there, back, Pose(0, 0, 0), 1.0)
    before = back.state
    in_order(there, back, Pose(300, 0, 0), 2.0)
    in_order(there, back, Pose(0, 0, 0), 3.0)

    assert before.is_open
    assert (there.state.reached_at, back.state.reached_at) == (2.0, 3.0)


def test_a_goal_after_a_missed_one_is_missed_too() -> None:
    there, back = two_regions(limit=5.0)
    in_order(there, back, Pose(600, 0, 0), 5.0)

    assert (there.state.failed_at, back.state.failed_at) == (5.0, 5.0)


def at(name: str, x: float, y: float = 0.0) -> RobotState:
    """A robot at a place."""
    return RobotState(name, 1.0, Pose(x, y, 0))


def test_a_region_for_all_is_reached_when_the_last_robot_is_in_it() -> None:
    goal = only(Reach(x=0.0, y=0.0, radius=100.0, together=True))
    goal.look(1.0, [at("a", 50), at("b", 150)])
    half = goal.state
    goal.look(1.0, [at("a", 50), at("b", 90)])

    assert (half.is_open, half.progress) == (True, 0.5)
    assert (goal.state.reached_at, goal.state.robot) == (1.0, "b")


def test_a_region_for_one_is_reached_when_all_others_are_outside() -> None:
    goal = only(Reach(x=0.0, y=0.0, radius=100.0, alone=True))
    goal.look(1.0, [at("a", 50)])
    goal.look(1.0, [at("a", 50), at("b", 90)])
    goal.look(1.0, [at("a", 150), at("b", 190)])
    before = goal.state
    goal.look(1.0, [at("a", 150), at("b", 90)])

    assert before.is_open
    assert (goal.state.reached_at, goal.state.robot) == (1.0, "b")


def test_an_object_reaches_a_region_and_the_nearest_robot_has_brought_it() -> None:
    ball = Cylinder(x=500.0, y=0.0, mass=0.1, name="ball")
    reach = Reach(x=0.0, y=0.0, radius=100.0, object="ball")
    world = WorldDescription(cylinder=(ball,), goal=Goals(reach=(reach,)))
    physics = Physics(world)
    (goal,) = goals(world, physics.pushed)
    robots = [at("pusher", 20), at("other", 300)]
    goal.look(1.0, robots)
    before = goal.state
    physics.pushed[0].body.position = (90.0, 0.0)
    goal.look(1.0, robots)

    assert before.is_open
    assert (goal.state.reached_at, goal.state.robot) == (1.0, "pusher")


@pytest.mark.parametrize(
    "choice",
    [
        {"robot": "a", "together": True},
        {"object": "ball", "alone": True},
        {"together": True, "alone": True},
    ],
)
def test_a_region_is_for_one_robot_an_object_all_or_one_alone(choice: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match="world-reach-choice"):
        Reach(x=0.0, y=0.0, **choice)
