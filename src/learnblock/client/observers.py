"""Observers of a robot while its program runs: calls, poses, goals and the outcome."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol

from learnblock.devices import Pose
from learnblock.scores import GameEvent


class Observer(Protocol):
    """Records what a program does with its robot, for example to write a trace."""

    def called(self, skill: str, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
        """Record that the program called a skill."""

    def missing(self, skill: str, device: str) -> None:
        """Record that a skill had no effect because the robot lacks a device (``Type:KEY``)."""


class Witness:
    """Records what happens to a robot in its world; the base class ignores it all."""

    def pose(self, time: float, pose: Pose) -> None:
        """Record the robot's pose; called every 0.1 s."""

    def placed(self, time: float, pose: Pose) -> None:
        """Record that a person lifted the robot and put it down at this pose."""

    def handled(self, time: float, how: str) -> None:
        """Record that a person shook or tilted the robot: ``shake``, ``level`` or a side."""

    def goal(self, time: float, name: str, state: str) -> None:
        """Record that a goal of the world was ``reached`` or ``failed``."""

    def collision(self, time: float, thing: str) -> None:
        """Record that the robot bumped into a thing of its world."""

    def game(self, event: GameEvent) -> None:
        """Record what happened in the game that the robot plays."""

    def stroke(
        self,
        time: float,
        points: Sequence[tuple[float, float]],
        color: tuple[int, int, int],
        width: float,
    ) -> None:
        """Record a stroke of the robot's pen that has ended: its points and width in mm."""

    def drawing_full(self, time: float) -> None:
        """Record that the pen can't draw any further, because the drawing has too many points."""


@dataclass(frozen=True, slots=True)
class Goal:
    """One of a world's goals.

    Args:
        name: the goal's name in the world.
        kind: region, line, tag.
        state: ``open``, ``reached`` or ``failed``.
        time: when it was decided, in seconds; None while it is open.
        team: the team that it is for, or "".
    """

    name: str
    kind: str
    state: Literal["open", "reached", "failed"]
    time: float | None
    team: str = ""


@dataclass(frozen=True, slots=True)
class Outcome:
    """The result of a run: the pose and the mm driven, if known, and the world's goals."""

    pose: Pose | None = None
    distance: float | None = None
    goals: tuple[Goal, ...] = ()
