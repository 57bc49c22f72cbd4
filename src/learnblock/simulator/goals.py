"""The goals of a world, and the progress of robots towards them."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.geometry import Polyline, Pose, forward, wrapped
from learnblock.simulator.world_description import Follow, Reach, Tag, Visit, WorldDescription

LINE_PIECE = 10.0
"""The length in mm of the pieces of a line that are checked."""
LONGEST_GAP = 100.0
"""The distance in mm that a robot may drive along a line between two checks, 50 ms apart."""

GoalKind = Literal["reach", "follow", "visit"]


@dataclass(frozen=True, slots=True)
class GoalState:
    """The state of a goal.

    Args:
        name: unique in the world.
        kind: reaching a region, following a line or visiting a tag.
        progress: 0 to 1.
        reached_at: when it was reached, in s, or None.
        failed_at: when its time limit passed, in s, or None.
        robot: the robot that reached it, or "".
    """

    name: str
    kind: GoalKind
    progress: float = 0.0
    reached_at: float | None = None
    failed_at: float | None = None
    robot: str = ""

    @property
    def is_open(self) -> bool:
        """Whether it is neither reached nor failed yet."""
        return self.reached_at is None and self.failed_at is None


class Goal:
    """One goal, checked at regular intervals.

    Args:
        kind: as in `GoalState`.
        described: the goal in the world's file.
    """

    def __init__(self, kind: GoalKind, described: Reach | Follow | Visit) -> None:
        self._described = described
        self.state = GoalState(described.name, kind)

    def look(self, time: float, poses: Mapping[str, Pose]) -> None:
        """Update the state from the current poses of the robots."""
        for robot, pose in poses.items():
            if self.state.is_open and self._described.robot in (None, robot):
                self._note(time, robot, self.progress(robot, pose))
        limit = self._described.time_limit
        if self.state.is_open and limit is not None and time >= limit:
            self.state = GoalState(
                self.state.name, self.state.kind, self.state.progress, failed_at=time
            )

    def progress(self, robot: str, pose: Pose) -> float:
        """The progress of a robot, 0 to 1."""
        raise NotImplementedError

    def _note(self, time: float, robot: str, progress: float) -> None:
        name, kind = self.state.name, self.state.kind
        if progress >= 1.0:
            self.state = GoalState(name, kind, 1.0, reached_at=time, robot=robot)
        elif progress > self.state.progress:
            self.state = GoalState(name, kind, progress)


class ReachGoal(Goal):
    """Be within a region."""

    def __init__(self, described: Reach) -> None:
        super().__init__("reach", described)
        self._region = described

    def progress(self, robot: str, pose: Pose) -> float:  # noqa: ARG002 - the same for every robot
        region = self._region
        distance = math.hypot(pose.x - region.x, pose.y - region.y)
        return 1.0 if distance <= region.radius else 0.0


class FollowGoal(Goal):
    """Drive along enough of a line, piece by piece, in either direction."""

    def __init__(self, described: Follow, line: Polyline) -> None:
        super().__init__("follow", described)
        self._follow, self._line = described, line
        self._length = line.length
        self._pieces = max(10, round(self._length / LINE_PIECE))
        self._passed: dict[str, NDArray[np.bool_]] = {}
        self._last: dict[str, int] = {}

    def progress(self, robot: str, pose: Pose) -> float:
        distance, along = self._line.nearest(pose.x, pose.y)
        if distance > self._follow.distance:
            self._last.pop(robot, None)
        else:
            self._pass(robot, int(along / self._length * self._pieces) % self._pieces)
        passed = self._passed.get(robot)
        share = 0.0 if passed is None else float(passed.mean())
        return min(1.0, share / self._follow.fraction)

    def _pass(self, robot: str, piece: int) -> None:
        passed = self._passed.setdefault(robot, np.zeros(self._pieces, np.bool_))
        last = self._last.get(robot, piece)
        steps = (piece - last + self._pieces // 2) % self._pieces - self._pieces // 2
        if abs(steps) * self._length / self._pieces > LONGEST_GAP:
            steps = 0
        between = range(min(0, steps), max(0, steps) + 1)
        passed[[(piece - step) % self._pieces for step in between]] = True
        self._last[robot] = piece


class VisitGoal(Goal):
    """Be near the front of a tag and face it."""

    def __init__(self, described: Visit, tag: Tag) -> None:
        super().__init__("visit", described)
        self._visit, self._tag = described, tag

    def progress(self, robot: str, pose: Pose) -> float:  # noqa: ARG002 - the same for every robot
        x, y = self._tag.x - pose.x, self._tag.y - pose.y
        bearing = math.degrees(math.atan2(-y, x))
        front = forward(self._tag.heading)
        is_before_it = front[0] * x + front[1] * y < 0
        is_near = math.hypot(x, y) <= self._visit.distance
        faces_it = abs(wrapped(bearing - pose.heading)) <= self._visit.angle
        return 1.0 if is_before_it and is_near and faces_it else 0.0


def goals(world: WorldDescription) -> tuple[Goal, ...]:
    """Create the goals of a world's file."""
    lines = {line.name: line for line in world.line}
    tags = {tag.id: tag for tag in world.tag}
    return (
        *(ReachGoal(reach) for reach in world.goal.reach),
        *(FollowGoal(follow, lines[follow.line].polyline()) for follow in world.goal.follow),
        *(VisitGoal(visit, tags[visit.id]) for visit in world.goal.visit),
    )
