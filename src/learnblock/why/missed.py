"""By how much a run missed a goal of its world."""

from collections.abc import Iterator
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.evidence.evidence import Evidence
from learnblock.evidence.missed_goals import RunInWorld, missed_goal
from learnblock.i18n import Phrase
from learnblock.robots.simulated import world_of_data
from learnblock.why.recorded import Recorded


def goal_missed_by(recorded: Recorded, goal: str, until: float) -> Phrase | None:
    """By how much a goal was missed at a time in s; None if that can't be said."""
    if (world := recorded.robot.get("world")) is None:
        return None
    try:
        description = world_of_data(world)
    except LearnBlockError:
        # Its floor's picture is on another computer.
        return None
    lines = tuple(_lines(recorded, until))
    evidence = Evidence(lines, now=until, robot=recorded.name)
    miss = missed_goal(RunInWorld(evidence, description), (goal,))
    return miss.words if miss else None


def _lines(recorded: Recorded, until: float) -> Iterator[dict[str, Any]]:
    """The lines of the trace up to a time, as `Evidence` reads them."""
    for line in recorded.lines:
        if line.get("t", 0.0) > until:
            continue
        yield {"t": line["t"], "collision": line["bump"]} if "bump" in line else line
    ending = recorded.ending
    if (pose := ending.get("pose")) and ending.get("time", 0.0) <= until:
        yield {"t": ending["time"], "pose": pose}
