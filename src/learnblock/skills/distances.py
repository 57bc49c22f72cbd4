"""How far away things are."""

from typing import TYPE_CHECKING

from learnblock.devices import DistanceSensors, number

if TYPE_CHECKING:
    from learnblock.client import Client


def is_front_obstacle(robot: "Client", threshold: float = 200) -> bool:
    """Is something in the way ahead?

    Args:
        threshold: mm below which a thing counts.
    """
    return _is_obstacle(robot, "front", threshold)


def is_left_obstacle(robot: "Client", threshold: float = 200) -> bool:
    """Is something near on the left?

    Args:
        threshold: mm below which a thing counts.
    """
    return _is_obstacle(robot, "left", threshold)


def is_right_obstacle(robot: "Client", threshold: float = 200) -> bool:
    """Is something near on the right?

    Args:
        threshold: mm below which a thing counts.
    """
    return _is_obstacle(robot, "right", threshold)


def is_back_obstacle(robot: "Client", threshold: float = 200) -> bool:
    """Is something near behind the robot?

    Args:
        threshold: mm below which a thing counts.
    """
    return _is_obstacle(robot, "back", threshold)


def is_obstacle_free(robot: "Client", threshold: float = 200) -> bool:
    """Is the way free ahead, on the left and on the right?

    Args:
        threshold: mm that must be free.
    """
    nearest = _nearest(robot, "front", "left", "right")
    return nearest is not None and nearest >= number("threshold", threshold)


def get_min_distance(
    robot: "Client",
    left: bool = False,  # noqa: FBT001, FBT002 - as pupils' programs write it
    front: bool = True,  # noqa: FBT001, FBT002 - as above
    right: bool = False,  # noqa: FBT001, FBT002 - as above
) -> float | None:
    """How far is the nearest thing, in mm? 2000 means that nothing is seen.

    Args:
        left: look to the left.
        front: look ahead.
        right: look to the right; when no side is asked for, all three are.
    """
    asked = {"left": left, "front": front, "right": right}
    sides = [side for side, wanted in asked.items() if wanted] or list(asked)
    return _nearest(robot, *sides)


def _is_obstacle(robot: "Client", side: str, threshold: float) -> bool:
    nearest = _nearest(robot, side)
    return nearest is not None and nearest < number("threshold", threshold)


def _nearest(robot: "Client", *sides: str) -> float | None:
    """Millimetres to the nearest thing on these sides; None where no sensor looks there."""
    readings = robot.read(DistanceSensors) or {}
    return min((mm for side in sides for mm in readings.get(side, ())), default=None)
