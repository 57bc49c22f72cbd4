"""Converts RoboComp's units and axes to ours."""

import math

from learnblock.devices import NOTHING_SEEN, Pose
from learnblock.ice.robocomp import BaseState


def pose_of(state: BaseState) -> Pose:
    """A base's state as a pose: in RoboComp, alpha 0 faces along z, and x is to the right."""
    return state.z, 0.0 - state.x, math.degrees(state.alpha)


def in_range(mm: float) -> float:
    """A distance in mm; values that mean "nothing seen" or an error become 2000."""
    return mm if 0 < mm < NOTHING_SEEN else NOTHING_SEEN


def by_side(row: list[float]) -> dict[str, list[float]]:
    """A left-to-right row of distances, grouped by side."""
    return {"left": row[:2], "front": row[1:4], "right": row[3:]}
