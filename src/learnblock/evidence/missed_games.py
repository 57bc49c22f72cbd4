"""By how much a run missed the goals of a game."""

from collections.abc import Sequence

from learnblock.evidence.evidence import Evidence
from learnblock.evidence.gaps import rounded_seconds
from learnblock.i18n import Phrase
from learnblock.scores import ANYTHING
from learnblock.simulator import WorldDescription
from learnblock.simulator.game.goals import things_of
from learnblock.simulator.goal_description import CollectThings, GameGoal, Gates, Score


def missed_game(goal: GameGoal, evidence: Evidence, world: WorldDescription) -> Phrase:
    """By how much a robot missed a goal of a game."""
    if goal.lose_nothing and (loss := _first_loss(evidence)):
        return loss
    return _shortfall(goal, evidence, world)


def _first_loss(evidence: Evidence) -> Phrase | None:
    lives: float | None = None
    for moment, line in evidence.game:
        now = line.get("lives")
        if not isinstance(now, int):
            continue
        by = line.get("thing")
        is_lost = line["game"] != "lives" or "lost" in line
        if is_lost and (lives is None or now < lives):
            at = rounded_seconds(moment.time)
            if by is None:
                return Phrase("miss-life-lost", at=at)
            return Phrase("miss-life-lost-by", thing=str(by), at=at)
        lives = now
    return None


def _shortfall(goal: GameGoal, evidence: Evidence, world: WorldDescription) -> Phrase:
    match goal:
        case Score():
            robots = [evidence.of(name) for name in evidence.team] if goal.together else [evidence]
            return Phrase("miss-score", score=sum(map(_score, robots)), asked=goal.points)
        case CollectThings():
            asked = goal.count or things_of(world, goal.kind)
            return Phrase("miss-collect", count=_collected(goal.kind, evidence), asked=asked)
        case Gates():
            asked = goal.laps * len(world.gate)
            return Phrase("miss-gates", count=len(_lines(evidence, "passed")), asked=asked)
    raise TypeError(f"not a goal of a game: {goal!r}")


def _collected(kind: str, evidence: Evidence) -> int:
    """How many things of a kind the robot has collected: they are called such as star 2."""
    lines = _lines(evidence, "collected")
    kinds = [str(line.get("thing", "")).partition(" ")[0] for line in lines]
    return sum(kind in (ANYTHING, collected) for collected in kinds)


def _score(evidence: Evidence) -> float:
    scores = [line.get("score") for _, line in evidence.game]
    return next((score for score in reversed(scores) if isinstance(score, int | float)), 0)


def _lines(evidence: Evidence, kind: str) -> Sequence[dict[str, object]]:
    return [dict(line) for _, line in evidence.game if line["game"] == kind]
