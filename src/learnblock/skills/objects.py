"""Objects of one colour in the camera's picture."""

from typing import TYPE_CHECKING, Literal

from learnblock.errors import UnknownNameError

if TYPE_CHECKING:
    from learnblock.client import Client
    from learnblock.perception import ColouredObject

_COLOURS = ("red", "orange", "yellow", "green", "blue", "purple")


def is_there_object(
    robot: "Client",
    colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red",
) -> bool:
    """Does the camera see something of this colour?

    Args:
        colour: red, orange, yellow, green, blue or purple.

    Raises:
        UnknownNameError: there is no such colour.
    """
    return _largest(robot, colour) is not None


def is_left_object(
    robot: "Client",
    colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red",
) -> bool:
    """Is the largest object of this colour on the left of the picture?

    Args:
        colour: red, orange, yellow, green, blue or purple.

    Raises:
        UnknownNameError: there is no such colour.
    """
    largest = _largest(robot, colour)
    return largest is not None and largest.is_left


def is_center_object(
    robot: "Client",
    colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red",
) -> bool:
    """Is the largest object of this colour in the middle of the picture?

    Args:
        colour: red, orange, yellow, green, blue or purple.

    Raises:
        UnknownNameError: there is no such colour.
    """
    largest = _largest(robot, colour)
    return largest is not None and largest.is_center


def is_right_object(
    robot: "Client",
    colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red",
) -> bool:
    """Is the largest object of this colour on the right of the picture?

    Args:
        colour: red, orange, yellow, green, blue or purple.

    Raises:
        UnknownNameError: there is no such colour.
    """
    largest = _largest(robot, colour)
    return largest is not None and largest.is_right


def get_object_size(
    robot: "Client",
    colour: Literal["red", "orange", "yellow", "green", "blue", "purple"] = "red",
) -> float | None:
    """How much of the picture does the largest object of this colour cover, in percent?

    The value grows as the robot comes closer. None without a camera.

    Args:
        colour: red, orange, yellow, green, blue or purple.

    Raises:
        UnknownNameError: there is no such colour.
    """
    if _objects(robot) is None:
        return None
    largest = _largest(robot, colour)
    return 0.0 if largest is None else 100 * largest.share


def _objects(robot: "Client") -> "tuple[ColouredObject, ...] | None":
    objects: tuple[ColouredObject, ...] | None = robot.detect("objects")
    return objects


def _largest(robot: "Client", colour: str) -> "ColouredObject | None":
    if colour not in _COLOURS:
        raise UnknownNameError("colour", str(colour), _COLOURS)
    # The detector sorts them by size.
    return next((item for item in _objects(robot) or () if item.colour == colour), None)
