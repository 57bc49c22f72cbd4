"""Being shaken and tilted by a person."""

from typing import TYPE_CHECKING

from learnblock.errors import UnknownNameError

if TYPE_CHECKING:
    from learnblock.client import Client

#: Degrees from which a robot counts as tilted: driving and slopes tilt it less.
_TILTED = 15
_DIRECTIONS = ("any", "front", "back", "left", "right")


def is_shaken(robot: "Client") -> bool:
    """Is the robot shaken, now or in the last half second?"""
    return robot.senses.is_shaken()


def is_tilted(robot: "Client", direction: str = "any") -> bool:
    """Is the robot tilted by more than 15 degrees?

    Args:
        direction: the side that is lower: front, back, left, right or any.

    Raises:
        UnknownNameError: there is no such side.
    """
    if direction not in _DIRECTIONS:
        raise UnknownNameError("direction", str(direction), _DIRECTIONS)
    pitch, roll = robot.senses.tilt() or (0.0, 0.0)
    lowered = {"front": -pitch, "back": pitch, "left": -roll, "right": roll}
    return max(lowered.values() if direction == "any" else [lowered[direction]]) > _TILTED
