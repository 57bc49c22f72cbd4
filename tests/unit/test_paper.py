"""Section V of the paper, measured on the twins; its programs run unchanged."""

import itertools
import math

import pytest

from learnblock import language, robots, running
from learnblock.simulator import load_robot, load_world
from runs import EXAMPLES, TWINS

SQUARE_ROBOTS = ("sim-cozmo", "sim-ev3")
TAG_ROBOTS = ("sim-ebo", "sim-cozmo")
LINE_RUNS = (("line-ebo.bt", "sim-ebo"), ("line-thymio.bt", "sim-thymio"))
SWAPPED = tuple(zip(LINE_RUNS, reversed(LINE_RUNS), strict=True))

pytestmark = pytest.mark.spread


def pose_at(run, time):
    """Return the robot's position at that time, within a tenth of a second."""
    return min(run.path, key=lambda entry: abs(entry[0] - time))[1]


def corners(run):
    """Return the pose at each end of a leg: (x, y, heading) after each turn."""
    turns = [entry["t"] for entry in run.entries("call") if entry["call"] == "stop_bot"]
    ends = [pose_at(run, turn) for turn in turns]
    return [run.path[0][1], *ends], run.path[-1][1]


@pytest.mark.parametrize("robot", TWINS)
def test_the_square_is_800_mm_long_and_ends_where_it_began_on_every_twin(made, robot):
    places = [pose[:2] for _, pose in made("square.bt", robot).path]
    length = sum(itertools.starmap(math.dist, itertools.pairwise(places)))
    assert length == pytest.approx(800, rel=0.05)
    assert math.dist(places[0], places[-1]) < 40


@pytest.mark.parametrize("robot", SQUARE_ROBOTS)
def test_the_square_has_four_equal_legs_right_corners_and_ends_where_it_began(made, robot):
    run = made("square.bt", robot)
    places, end = corners(run)
    legs = [math.dist(a[:2], b[:2]) for a, b in itertools.pairwise(places)]
    headings = [pose[2] for pose in places[1:]] + [end[2]]
    turned = [(b - a) % 360 for a, b in itertools.pairwise(headings)]
    mean = sum(legs) / 4
    assert run.report.ended == "finished"
    assert len(legs) == 4
    assert max(abs(leg / mean - 1) for leg in legs) < 0.03
    assert max(abs(angle - 90) for angle in turned) < 3
    assert math.dist(places[0][:2], end[:2]) < 0.05 * sum(legs)


@pytest.mark.slow
@pytest.mark.parametrize("robot", TAG_ROBOTS)
def test_three_tags_are_searched_approached_and_answered_with_joy_surprise_and_fear(made, robot):
    run = made("tags.bt", robot)
    world = load_world("tags")
    shown = [(mark.text, mark.time, mark.pose) for mark in run.marks if mark.kind == "emotion"]
    assert [emotion for emotion, _, _ in shown] == ["neutral", "joy", "surprise", "fear"]
    for (_, _, pose), tag in zip(shown[1:], world.tag, strict=True):
        # It approaches the tag until it loses sight of it: right in front of it, and facing it.
        assert 80 < math.dist(pose[:2], (tag.x, tag.y)) < 260
    for _, time, _ in shown[1:]:
        # It stops to show its feeling for two seconds, and then searches again.
        early, late, searching = (pose_at(run, time + after) for after in (0.3, 1.9, 2.5))
        assert early == late
        assert (searching[2] - late[2]) % 360 > 5


@pytest.mark.slow
@pytest.mark.sample(1)
@pytest.mark.parametrize(("example", "robot"), [(one, other) for (one, _), (_, other) in SWAPPED])
def test_each_line_program_drives_a_lap_on_the_robot_of_the_other_one(made, example, robot):
    [goal] = made(example, robot).report.goals
    assert goal.state == "reached"


@pytest.mark.slow
@pytest.mark.parametrize(("example", "robot"), LINE_RUNS)
def test_a_lap_of_the_line_stays_within_half_a_body_width_with_joy_on_it(made, example, robot):
    run = made(example, robot)
    line = load_world("line").line[0].polyline()
    body = load_robot(robot.removeprefix("sim-")).body
    half_width = body.radius or body.width / 2
    farthest = max(line.nearest(x, y)[0] for _, (x, y, _) in run.path)
    assert [goal.state for goal in run.report.goals] == ["reached"]
    assert farthest < half_width
    assert run.report.emotions[0] == "joy"
    assert set(run.report.emotions) <= {"joy", "sadness"}


@pytest.mark.parametrize("robot", ["sim-ebo", "sim-thymio"])
def test_off_the_line_the_follower_is_sad_and_slows_down(made, robot):
    example = {robot: example for example, robot in LINE_RUNS}[robot]
    report = made(example, robot, world="empty", seconds=3).report
    assert report.emotions == ("sadness",)
    assert report.distance < 1


@pytest.mark.parametrize(
    ("example", "pair"),
    [("square.bt", SQUARE_ROBOTS), ("tags.bt", TAG_ROBOTS), ("line-ebo.bt", ("ebo", "thymio"))],
)
def test_the_python_for_two_robots_differs_in_exactly_the_import_line(example, pair):
    tree = running.read(EXAMPLES / example).tree
    one, other = (
        language.to_python(tree, robots.module_of(robot)).text.splitlines() for robot in pair
    )
    assert [a for a, b in zip(one, other, strict=True) if a != b] == [
        f"from {robots.module_of(pair[0])} import Robot"
    ]
