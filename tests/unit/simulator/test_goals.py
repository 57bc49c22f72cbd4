import math

import pytest

from learnblock.simulator.geometry import Pose
from learnblock.simulator.goals import Goal, GoalState, goals
from learnblock.simulator.world_description import (
    Follow,
    Goals,
    Line,
    Part,
    Reach,
    Tag,
    Visit,
    WorldDescription,
)

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


def only(goal: Reach | Follow | Visit) -> Goal:
    """Return the goal in a world with a track and a tag."""
    kind = {Reach: "reach", Follow: "follow", Visit: "visit"}[type(goal)]
    world = WorldDescription(line=(TRACK,), tag=(TAG,), goal=Goals(**{kind: (goal,)}))
    (made,) = goals(world)
    return made


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
    goal.look(1.0, {"a": Pose(100, 151, 0)})
    before = goal.state
    goal.look(2.0, {"a": Pose(100, 149, 0)})

    assert before.is_open
    assert goal.state == GoalState("reach", "reach", 1.0, reached_at=2.0, robot="a")


def test_a_goal_for_one_robot_is_not_reached_by_another() -> None:
    goal = only(Reach(x=0.0, y=0.0, robot="b"))
    goal.look(1.0, {"a": Pose(0, 0, 0), "b": Pose(900, 0, 0)})

    assert goal.state.is_open


def test_a_goal_fails_when_its_time_is_over_and_stays_so() -> None:
    goal = only(Reach(x=0.0, y=0.0, time_limit=5.0))
    goal.look(4.95, {"a": Pose(900, 0, 0)})
    before = goal.state
    goal.look(5.0, {"a": Pose(900, 0, 0)})
    goal.look(6.0, {"a": Pose(0, 0, 0)})

    assert before.is_open
    assert goal.state.failed_at == 5.0
    assert goal.state.reached_at is None


@pytest.mark.parametrize("backwards", [False, True])
def test_a_lap_in_either_direction_follows_a_line(backwards: bool) -> None:
    goal = only(Follow())
    way = [*lap(1.0), lap(1.0)[0]]
    for i, pose in enumerate(reversed(way) if backwards else way):
        goal.look(i * 0.05, {"a": pose})

    assert goal.state.reached_at == pytest.approx(len(way) * 0.05, rel=0.03)


def test_half_a_lap_is_half_of_the_progress() -> None:
    goal = only(Follow())
    for pose in lap(0.5):
        goal.look(0.0, {"a": pose})

    assert goal.state.progress == pytest.approx(0.5, abs=0.02)
    assert goal.state.is_open


def test_a_fraction_of_the_line_may_be_enough() -> None:
    goal = only(Follow(fraction=0.45))
    for pose in lap(0.5):
        goal.look(0.0, {"a": pose})

    assert goal.state.progress == 1.0


def test_too_far_from_the_line_is_not_following() -> None:
    goal = only(Follow(distance=50.0))
    for pose in lap(1.0, offset=60):
        goal.look(0.0, {"a": pose})

    assert goal.state.progress == 0.0


def test_a_robot_carried_along_the_line_has_not_followed_it() -> None:
    goal = only(Follow())
    for pose in (lap(1.0)[0], lap(1.0)[60], lap(1.0)[120]):
        goal.look(0.0, {"a": pose})

    assert goal.state.progress < 0.05


def test_two_robots_do_not_share_a_lap() -> None:
    goal = only(Follow())
    way = lap(1.0)
    for a, b in zip(way[: len(way) // 2], way[len(way) // 2 :], strict=False):
        goal.look(0.0, {"a": a, "b": b})

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
    goal.look(1.0, {"a": pose})

    assert reached is not goal.state.is_open
