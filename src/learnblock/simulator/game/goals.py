"""The goals of games: to score, to collect, and to pass the gates."""

from collections.abc import Iterator, Sequence

from learnblock.scores import ANYTHING
from learnblock.simulator.goal import Goal, GoalKind, RobotState
from learnblock.simulator.goal_description import CollectThings, GameGoal, Gates, Score
from learnblock.simulator.world_description import WorldDescription


class CountedGoal(Goal):
    """A goal of a game, which may ask to lose no life.

    Args:
        kind: as in `GoalState`.
        described: the goal in the world's file.
    """

    def __init__(self, kind: GoalKind, described: GameGoal) -> None:
        super().__init__(kind, described)
        self._lose_nothing = described.lose_nothing

    def can_reach(self, robot: RobotState) -> bool:
        return not (self._lose_nothing and robot.lost_lives)


class ScoreGoal(CountedGoal):
    """Have a score."""

    def __init__(self, described: Score) -> None:
        super().__init__("score", described)
        self._score = described

    def progress(self, robot: RobotState) -> float:
        return _share(robot.score, self._score.points)


class SharedScoreGoal(ScoreGoal):
    """Have a score together with the other robots."""

    def _look(self, robots: Sequence[RobotState]) -> None:
        if robots:
            best = max(robots, key=lambda robot: robot.score)
            if not all(map(self.can_reach, robots)):
                self._fail(best.time)
            else:
                total = sum(robot.score for robot in robots)
                self._note(best, _share(total, self._score.points))


class CollectGoal(CountedGoal):
    """Collect things of a kind.

    Args:
        described: the goal.
        count: how many.
    """

    def __init__(self, described: CollectThings, count: int) -> None:
        super().__init__("collect", described)
        self._kind, self._count = described.kind, count

    def progress(self, robot: RobotState) -> float:
        return _share(robot.collected.get(self._kind, 0), self._count)


class GatesGoal(CountedGoal):
    """Pass all gates in their order.

    Args:
        described: the goal.
        count: how many gates have to be passed in all rounds.
    """

    def __init__(self, described: Gates, count: int) -> None:
        super().__init__("gates", described)
        self._count = count

    def progress(self, robot: RobotState) -> float:
        return _share(robot.gates, self._count)


def game_goals(world: WorldDescription) -> Iterator[Goal]:
    """The goals of games, in the order of `Goals.all`."""
    for score in world.goal.score:
        yield SharedScoreGoal(score) if score.together else ScoreGoal(score)
    for collect in world.goal.collect:
        yield CollectGoal(collect, collect.count or things_of(world, collect.kind))
    for gates in world.goal.gates:
        yield GatesGoal(gates, gates.laps * len(world.gate))


def things_of(world: WorldDescription, kind: str) -> int:
    """How many things of a kind there are in a world."""
    return sum(kind in (ANYTHING, thing.kind) for thing in world.collectable)


def _share(reached: float, wanted: float) -> float:
    return min(1.0, max(0.0, reached / wanted))
