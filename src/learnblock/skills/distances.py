"""Distances to obstacles."""

from typing import TYPE_CHECKING

from learnblock.devices import Bumper, number

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
    threshold = number("threshold", threshold)
    distances = [robot.senses.distance(side) for side in ("front", "left", "right")]
    return all(mm is not None and mm >= threshold for mm in distances)


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
    choices = {"left": left, "front": front, "right": right}
    sides = [side for side, is_on in choices.items() if is_on] or list(choices)
    distances = (robot.senses.distance(side) for side in sides)
    return min((mm for mm in distances if mm is not None), default=None)


def get_obstacle_direction(robot: "Client") -> float | None:
    """In which direction is the nearest obstacle? In degrees: 0 ahead, positive to the right.

    In steps of 45 degrees, from -90 (left) to 90 (right), and 180 behind; None if the robot sees no
    obstacle. A robot that only looks ahead sees obstacles only there.
    """
    return robot.senses.obstacle_direction()


def _is_obstacle(robot: "Client", side: str, threshold: float) -> bool:
    nearest = robot.senses.distance(side)
    return nearest is not None and nearest < number("threshold", threshold)


def is_bumped(robot: "Client") -> bool:
    """Does the robot's bumper touch something?"""
    return robot.read(Bumper) or False
