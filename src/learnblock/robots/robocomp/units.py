"""RoboComp's units and axes as ours."""

import math

from learnblock.devices import NOTHING_SEEN, Pose
from learnblock.ice.robocomp import BaseState


def pose_of(state: BaseState) -> Pose:
    """A base's state as a pose: RoboComp looks along z at alpha 0 and has x to its right."""
    return state.z, 0.0 - state.x, math.degrees(state.alpha)


def in_range(mm: float) -> float:
    """A ranger's distance; what it answers when it sees nothing, or fails, becomes 2000."""
    return mm if 0 < mm < NOTHING_SEEN else NOTHING_SEEN


def by_side(row: list[float]) -> dict[str, list[float]]:
    """A row of distances from left to right, by the sides to which they look."""
    return {"left": row[:2], "front": row[1:4], "right": row[3:]}
