"""Distances to obstacles."""

from typing import TYPE_CHECKING

from learnblock.devices import DistanceSensors, number

if TYPE_CHECKING:
    from learnblock.client import Client


def is_front_obstacle(robot: "Client", threshold: float = 200) -> bool:
    """Is there an obstacle ahead?

    Args:
        threshold: the distance in mm within which an obstacle counts.
    """
    return _is_obstacle(robot, "front", threshold)


def is_left_obstacle(robot: "Client", threshold: float = 200) -> bool:
    """Is there an obstacle on the left?

    Args:
        threshold: the distance in mm within which an obstacle counts.
    """
    return _is_obstacle(robot, "left", threshold)


def is_right_obstacle(robot: "Client", threshold: float = 200) -> bool:
    """Is there an obstacle on the right?

    Args:
        threshold: the distance in mm within which an obstacle counts.
    """
    return _is_obstacle(robot, "right", threshold)


def is_back_obstacle(robot: "Client", threshold: float = 200) -> bool:
    """Is there an obstacle behind the robot?

    Args:
        threshold: the distance in mm within which an obstacle counts.
    """
    return _is_obstacle(robot, "back", threshold)


def is_obstacle_free(robot: "Client", threshold: float = 200) -> bool:
    """Is the way clear ahead, on the left and on the right?

    Args:
        threshold: the distance in mm that must be clear.
    """
    nearest = _nearest(robot, "front", "left", "right")
    return nearest is not None and nearest >= number("threshold", threshold)


def get_min_distance(
    robot: "Client",
    left: bool = False,  # noqa: FBT001, FBT002 - as pupils' programs write it
    front: bool = True,  # noqa: FBT001, FBT002 - as above
    right: bool = False,  # noqa: FBT001, FBT002 - as above
) -> float | None:
    """How far is the nearest obstacle, in mm? 2000 means that none is seen.

    Args:
        left: look to the left.
        front: look ahead.
        right: look to the right; without any side, all three are used.
    """
    asked = {"left": left, "front": front, "right": right}
    sides = [side for side, wanted in asked.items() if wanted] or list(asked)
    return _nearest(robot, *sides)


def _is_obstacle(robot: "Client", side: str, threshold: float) -> bool:
    nearest = _nearest(robot, side)
    return nearest is not None and nearest < number("threshold", threshold)


def _nearest(robot: "Client", *sides: str) -> float | None:
    """Millimetres to the nearest obstacle on these sides; None without a sensor there."""
    readings = robot.read(DistanceSensors) or {}
    return min((mm for side in sides for mm in readings.get(side, ())), default=None)
