"""By how much a run missed the goals of its world."""

from collections.abc import Iterator
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.evidence.evidence import Evidence
from learnblock.evidence.missed_goals import Miss, RunInWorld, missed_goal
from learnblock.robots.simulated import world_of_data
from learnblock.simulator import WorldDescription
from learnblock.simulator.game.teams import teams_of
from learnblock.why.recorded import Recorded


def first_missed(recorded: Recorded) -> Miss | None:
    """By how much a run that has ended missed the first goal that it did not reach.

    One that a goal has won has missed none.
    """
    if any("winner" in line for line in recorded.lines):
        return None
    goals = recorded.ending.get("goals") or ()
    missed = [str(goal["name"]) for goal in goals if goal.get("state") != "reached"]
    return _miss(recorded, missed, recorded.ending["time"]) if missed else None


def goal_missed(recorded: Recorded, goal: str, until: float) -> Miss | None:
    """By how much a goal was missed at a time in s; None if that can't be said."""
    return _miss(recorded, [goal], until)


def _miss(recorded: Recorded, goals: list[str], until: float) -> Miss | None:
    if (world := recorded.robot.get("world")) is None:
        return None
    try:
        description = world_of_data(world)
    except LearnBlockError:
        # Its floor's picture is on another computer.
        return None
    evidence = Evidence(tuple(_lines(recorded, until)), now=until, robot=recorded.name)
    return missed_goal(RunInWorld(evidence, description), _own(recorded, description, goals))


def _own(recorded: Recorded, world: WorldDescription, names: list[str]) -> list[str]:
    """The goals without those of other teams, of which the log does not know enough."""
    robots = [str(robot["name"]) for robot in recorded.roster] or [recorded.name]
    own = teams_of(world, robots).get(recorded.name)
    others = {goal.name for _, _, goal in world.goal.all() if goal.team not in (None, own)}
    return [name for name in names if name not in others]


def _lines(recorded: Recorded, until: float) -> Iterator[dict[str, Any]]:
    """The lines of the trace up to a time, as `Evidence` reads them."""
    for line in recorded.lines:
        if line.get("t", 0.0) <= until:
            yield {"t": line["t"], "collision": line["bump"]} if "bump" in line else line
    ending = recorded.ending
    if (pose := ending.get("pose")) and ending.get("time", 0.0) <= until:
        yield {"t": ending["time"], "pose": pose}
