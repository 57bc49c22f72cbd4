"""A goal of a world: its state, and what it sees of robots."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Literal

import msgspec
from msgspec.structs import replace

from learnblock.simulator.geometry import Pose
from learnblock.simulator.goal_description import AnyGoal

GoalKind = Literal[
    "reach", "follow", "visit", "tour", "stop", "show", "avoid", "score", "collect", "gates"
]


class RobotState(msgspec.Struct, frozen=True):
    """What goals see of a robot.

    Args:
        name: its name in the world.
        time: the world's time in s.
        pose: its pose.
        emotion: the emotion that it shows.
        distance: mm driven so far.
        bumps: how often it bumped into something.
        is_on_floor: whether its middle is above the floor.
        has_ended: whether its program has ended, so that it stays where it is.
        score: its score in the game.
        lost_lives: how many lives it has lost.
        collected: how many things of each kind it has collected.
        gates: how many gates it has passed in their order.
        team: the team that it plays for, or "".
    """

    name: str
    time: float
    pose: Pose
    emotion: str = "none"
    distance: float = 0.0
    bumps: int = 0
    is_on_floor: bool = True
    has_ended: bool = False
    score: float = 0
    lost_lives: int = 0
    collected: Mapping[str, int] = msgspec.field(default_factory=dict)
    gates: int = 0
    team: str = ""


class GoalState(msgspec.Struct, frozen=True):
    """The state of a goal.

    Args:
        name: unique in the world.
        kind: the kind of goal, as in a world's file.
        progress: 0 to 1.
        reached_at: when it was reached, in s, or None.
        failed_at: when it could no longer be reached, in s, or None.
        robot: the robot that reached it, or "".
        team: the team that it is for, or "".
        wins: whether reaching it wins the game.
    """

    name: str
    kind: GoalKind
    progress: float = 0.0
    reached_at: float | None = None
    failed_at: float | None = None
    robot: str = ""
    team: str = ""
    wins: bool = False

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

    def __init__(self, kind: GoalKind, described: AnyGoal) -> None:
        self._described = described
        self.state = GoalState(described.name, kind, team=described.team or "", wins=described.wins)
        #: The goal that has to be reached before this one.
        self.first: Goal | None = None

    def look(self, time: float, robots: Iterable[RobotState]) -> None:
        """Update the state from the current states of the robots."""
        if not self.state.is_open:
            return
        if self.first is None or self.first.state.reached_at is not None:
            self._look([*filter(self._is_for, robots)])
        limit = self._described.time_limit
        is_late = limit is not None and time >= limit
        is_lost = self.first is not None and self.first.state.failed_at is not None
        if self.state.is_open and (is_late or is_lost):
            self._fail(time)

    def progress(self, robot: RobotState) -> float:
        """The progress of a robot, 0 to 1."""
        raise NotImplementedError

    def can_reach(self, robot: RobotState) -> bool:  # noqa: ARG002 - most goals stay possible
        """Whether a robot can still reach the goal."""
        return True

    def _is_for(self, robot: RobotState) -> bool:
        goal = self._described
        return goal.robot in (None, robot.name) and goal.team in (None, robot.team)

    def _look(self, robots: Sequence[RobotState]) -> None:
        able = [robot for robot in robots if self.can_reach(robot)]
        for robot in able:
            if self.state.is_open:
                self._note(robot, self.progress(robot))
        if robots and not able:
            self._fail(robots[0].time)

    def _note(self, robot: RobotState, progress: float) -> None:
        if progress >= 1.0:
            self.state = replace(self.state, progress=1.0, reached_at=robot.time, robot=robot.name)
        elif progress > self.state.progress:
            self.state = replace(self.state, progress=progress)

    def _fail(self, time: float) -> None:
        self.state = replace(self.state, failed_at=time)
