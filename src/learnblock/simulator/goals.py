"""The goals of a world, and the progress of robots towards them."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from learnblock.simulator.game.goals import game_goals
from learnblock.simulator.geometry import Point, Pose, forward, wrapped
from learnblock.simulator.goal import Goal, RobotState
from learnblock.simulator.goal_description import (
    Avoid,
    Follow,
    Reach,
    Show,
    Stop,
    Tour,
    Visit,
)
from learnblock.simulator.physics import Pushed
from learnblock.simulator.world_description import Tag, WorldDescription

if TYPE_CHECKING:
    from learnblock.simulator.polyline import Polyline

LINE_PIECE = 10.0
"""The length in mm of the pieces of a line that are checked."""
LONGEST_GAP = 100.0
"""The distance in mm that a robot may drive along a line between two checks, 50 ms apart."""

STILL = (2.0, 2.0)
"""The mm and degrees by which a robot may move and still count as standing still."""

ROUNDING = 0.001
"""Seconds by which the difference of two rounded times may be too short."""


class ReachGoal(Goal):
    """Be within a region."""

    def __init__(self, described: Reach) -> None:
        super().__init__("reach", described)
        self._region = described

    def progress(self, robot: RobotState) -> float:
        return float(_is_in(self._region, robot.pose))


class BringGoal(Goal):
    """Bring an object into a region; the robot nearest to it has most likely brought it.

    Args:
        described: the goal.
        thing: the object.
    """

    def __init__(self, described: Reach, thing: Pushed) -> None:
        super().__init__("reach", described)
        self._region, self._thing = described, thing

    def _look(self, robots: Sequence[RobotState]) -> None:
        if robots and _is_in(self._region, self._thing.pose):
            self._note(min(robots, key=self._away), 1.0)

    def _away(self, robot: RobotState) -> float:
        thing = self._thing.pose
        return math.hypot(robot.pose.x - thing.x, robot.pose.y - thing.y)


class TogetherGoal(Goal):
    """Be within a region with all other robots, or those of the team.

    The one at the edge has most likely come last.
    """

    def __init__(self, described: Reach) -> None:
        super().__init__("reach", described)
        self._region = described

    def _look(self, robots: Sequence[RobotState]) -> None:
        if robots:
            inside = sum(_is_in(self._region, robot.pose) for robot in robots)
            self._note(max(robots, key=self._away), inside / len(robots))

    def _away(self, robot: RobotState) -> float:
        return math.hypot(robot.pose.x - self._region.x, robot.pose.y - self._region.y)


class AloneGoal(Goal):
    """Be the only one of several robots within a region; for a team, its robots alone."""

    def __init__(self, described: Reach) -> None:
        super().__init__("reach", described)
        self._region = described

    def _look(self, robots: Sequence[RobotState]) -> None:
        inside = [robot for robot in robots if _is_in(self._region, robot.pose)]
        team = self._region.team
        others = [robot for robot in inside[1:] if team is None or robot.team != team]
        if inside and not others and len(inside) < len(robots) and super()._is_for(inside[0]):
            self._note(inside[0], 1.0)

    def _is_for(self, robot: RobotState) -> bool:  # noqa: ARG002 - the others have to be outside
        return True


class FollowGoal(Goal):
    """Drive along enough of a line, piece by piece, in either direction."""

    def __init__(self, described: Follow, line: "Polyline") -> None:
        super().__init__("follow", described)
        self._follow, self._line = described, line
        self._length = line.length
        self._pieces = max(10, round(self._length / LINE_PIECE))
        self._passed: dict[str, set[int]] = {}
        self._last: dict[str, int] = {}

    def progress(self, robot: RobotState) -> float:
        distance, along = self._line.nearest(robot.pose.x, robot.pose.y)
        if distance > self._follow.distance:
            self._last.pop(robot.name, None)
        else:
            self._pass(robot.name, int(along / self._length * self._pieces) % self._pieces)
        share = len(self._passed.get(robot.name, ())) / self._pieces
        return min(1.0, share / self._follow.fraction)

    def _pass(self, robot: str, piece: int) -> None:
        passed = self._passed.setdefault(robot, set())
        last = self._last.get(robot, piece)
        steps = (piece - last + self._pieces // 2) % self._pieces - self._pieces // 2
        if abs(steps) * self._length / self._pieces > LONGEST_GAP:
            steps = 0
        between = range(min(0, steps), max(0, steps) + 1)
        passed.update((piece - step) % self._pieces for step in between)
        self._last[robot] = piece


class VisitGoal(Goal):
    """Be near the front of a tag and face it."""

    def __init__(self, described: Visit, tag: Tag) -> None:
        super().__init__("visit", described)
        self._visit, self._tag = described, tag

    def progress(self, robot: RobotState) -> float:
        pose = robot.pose
        x, y = self._tag.x - pose.x, self._tag.y - pose.y
        bearing = math.degrees(math.atan2(-y, x))
        front = forward(self._tag.heading)
        is_before_it = front[0] * x + front[1] * y < 0
        is_near = math.hypot(x, y) <= self._visit.distance
        faces_it = abs(wrapped(bearing - pose.heading)) <= self._visit.angle
        return 1.0 if is_before_it and is_near and faces_it else 0.0


class TourGoal(Goal):
    """Be at several places in order."""

    def __init__(self, described: Tour) -> None:
        super().__init__("tour", described)
        self._tour = described
        self._passed: dict[str, int] = {}

    def progress(self, robot: RobotState) -> float:
        points, passed = self._tour.points, self._passed.get(robot.name, 0)
        if _is_near(robot.pose, points[passed], self._tour.radius):
            passed += 1
        self._passed[robot.name] = passed
        return passed / len(points)


class StopGoal(Goal):
    """Stand still in a region, in a direction if the goal has one."""

    def __init__(self, described: Stop) -> None:
        super().__init__("stop", described)
        self._stop = described
        self._stood: dict[str, RobotState] = {}

    def progress(self, robot: RobotState) -> float:
        before = self._stood.get(robot.name)
        if before is None or not self._is_in_place(robot.pose) or _has_moved(before, robot):
            before = self._stood[robot.name] = robot
        if not self._is_in_place(robot.pose):
            return 0.0
        share = (robot.time - before.time + ROUNDING) / self._stop.seconds
        return 1.0 if robot.has_ended else min(1.0, share)

    def _is_in_place(self, pose: Pose) -> bool:
        goal = self._stop
        faces = goal.heading is None or abs(wrapped(pose.heading - goal.heading)) <= goal.angle
        return faces and _is_near(pose, (goal.x, goal.y), goal.radius)


class ShowGoal(Goal):
    """Show an emotion, in a region if the goal has one."""

    def __init__(self, described: Show) -> None:
        super().__init__("show", described)
        self._show = described

    def progress(self, robot: RobotState) -> float:
        show = self._show
        is_there = show.radius is None or _is_near(robot.pose, (show.x, show.y), show.radius)
        return float(is_there and robot.emotion == show.emotion)


class AvoidGoal(Goal):
    """Drive a distance without a bump."""

    def __init__(self, described: Avoid) -> None:
        super().__init__("avoid", described)
        self._distance = described.distance
        self._fallen: set[str] = set()

    def progress(self, robot: RobotState) -> float:
        return min(1.0, robot.distance / self._distance)

    def can_reach(self, robot: RobotState) -> bool:
        if robot.bumps or not robot.is_on_floor:
            self._fallen.add(robot.name)
        return robot.name not in self._fallen


def goals(world: WorldDescription, pushed: Sequence[Pushed] = ()) -> tuple[Goal, ...]:
    """Create the goals of a world's file.

    Args:
        world: the file's content.
        pushed: the objects that can be pushed.
    """
    goals = tuple(_made(world, {goal.thing.name: goal for goal in pushed}))
    named = {goal.state.name: goal for goal in goals}
    for goal, (_, _, described) in zip(goals, world.goal.all(), strict=True):
        goal.first = named[described.after] if described.after else None
    return goals


def _made(world: WorldDescription, pushed: Mapping[str, Pushed]) -> Iterator[Goal]:
    """The goals in the order of `Goals.all`."""
    lines = {line.name: line for line in world.line}
    tags = {tag.id: tag for tag in world.tag}
    for reach in world.goal.reach:
        yield _reaching(reach, pushed)
    for follow in world.goal.follow:
        yield FollowGoal(follow, lines[follow.line].polyline())
    for visit in world.goal.visit:
        yield VisitGoal(visit, tags[visit.id])
    yield from map(TourGoal, world.goal.tour)
    yield from map(StopGoal, world.goal.stop)
    yield from map(ShowGoal, world.goal.show)
    yield from map(AvoidGoal, world.goal.avoid)
    yield from game_goals(world)


def _reaching(reach: Reach, pushed: Mapping[str, Pushed]) -> Goal:
    if reach.object is not None:
        return BringGoal(reach, pushed[reach.object])
    if reach.together:
        return TogetherGoal(reach)
    return AloneGoal(reach) if reach.alone else ReachGoal(reach)


def _is_in(region: Reach, pose: Pose) -> bool:
    return _is_near(pose, (region.x, region.y), region.radius)


def _is_near(pose: Pose, place: Point, distance: float) -> bool:
    return math.hypot(pose.x - place[0], pose.y - place[1]) <= distance


def _has_moved(before: RobotState, now: RobotState) -> bool:
    moved, turned = STILL
    is_near = _is_near(now.pose, (before.pose.x, before.pose.y), moved)
    return not is_near or abs(wrapped(now.pose.heading - before.pose.heading)) > turned
