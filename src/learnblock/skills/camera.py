"""Lines and tags in the camera's picture."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from learnblock.devices import Camera
from learnblock.perception.tag_names import tag_id

if TYPE_CHECKING:
    from learnblock.client import Client
    from learnblock.devices import Frame
    from learnblock.perception import Lines, Tag


def get_image(robot: "Client") -> "Frame | None":
    """The camera's picture: uint8 RGB, shape (height, width, 3); None before the first one."""
    return robot.read(Camera)


def is_center_black_line(robot: "Client") -> bool:
    """Is a black line mostly in the middle of the camera's picture?

    The camera tilts to the floor, unless the program has tilted it. A robot without a camera uses
    its ground sensors; a single one follows the line's right edge.
    """
    return robot.senses.line("black").is_center


def is_left_black_line(robot: "Client") -> bool:
    """Is a black line mostly on the left of the camera's picture?

    The camera tilts to the floor, unless the program has tilted it. A robot without a camera uses
    its ground sensors; a single one follows the line's right edge.
    """
    return robot.senses.line("black").is_left


def is_right_black_line(robot: "Client") -> bool:
    """Is a black line mostly on the right of the camera's picture?

    The camera tilts to the floor, unless the program has tilted it. A robot without a camera uses
    its ground sensors; a single one follows the line's right edge.
    """
    return robot.senses.line("black").is_right


def is_there_black_line(robot: "Client") -> bool:
    """Is there a black line in the camera's picture?

    The camera tilts to the floor, unless the program has tilted it. A robot without a camera uses
    its ground sensors; a single one follows the line's right edge.
    """
    return robot.senses.line("black").is_there


def is_center_red_line(robot: "Client") -> bool:
    """Does the camera see a red line mostly in the middle of the picture?"""
    return robot.senses.line("red").is_center


def is_left_red_line(robot: "Client") -> bool:
    """Does the camera see a red line mostly on the left of the picture?"""
    return robot.senses.line("red").is_left


def is_right_red_line(robot: "Client") -> bool:
    """Does the camera see a red line mostly on the right of the picture?"""
    return robot.senses.line("red").is_right


def is_there_red_line(robot: "Client") -> bool:
    """Does the camera see a red line anywhere in the picture?"""
    return robot.senses.line("red").is_there


def is_center_blue_line(robot: "Client") -> bool:
    """Does the camera see a blue line mostly in the middle of the picture?"""
    return robot.senses.line("blue").is_center


def is_left_blue_line(robot: "Client") -> bool:
    """Does the camera see a blue line mostly on the left of the picture?"""
    return robot.senses.line("blue").is_left


def is_right_blue_line(robot: "Client") -> bool:
    """Does the camera see a blue line mostly on the right of the picture?"""
    return robot.senses.line("blue").is_right


def is_there_blue_line(robot: "Client") -> bool:
    """Does the camera see a blue line anywhere in the picture?"""
    return robot.senses.line("blue").is_there


def is_line_crossing(robot: "Client") -> bool:
    """Does the camera see a red and a black line crossing ahead?"""
    lines = _lines(robot)
    return lines is not None and lines.is_crossing


def is_any_tag(robot: "Client") -> bool:
    """Does the camera see a tag?"""
    return bool(_tags(robot))


def is_tag(robot: "Client", idTag: int | str = 8) -> bool:
    """Does the camera see this tag?

    Args:
        idTag: the number or name of the tag.

    Raises:
        UnknownNameError: no tag has this name.
    """
    return _find(robot, idTag) is not None


def is_image(robot: "Client", id: int | str = 0) -> bool:  # noqa: A002 - the paper's name
    """Does the camera see the picture that belongs to this tag?

    Args:
        id: the number or name of the tag.

    Raises:
        UnknownNameError: no tag has this name.
    """
    return is_tag(robot, id)


def tag_on_the_left(robot: "Client", idTag: int | str | None = None) -> bool:
    """Does the camera see the tag on the left of the picture?

    Args:
        idTag: the number or name of the tag; None means the first tag seen.

    Raises:
        UnknownNameError: no tag has this name.
    """
    tag = _find(robot, idTag)
    return tag is not None and tag.is_left


def tag_on_the_right(robot: "Client", idTag: int | str | None = None) -> bool:
    """Does the camera see the tag on the right of the picture?

    Args:
        idTag: the number or name of the tag; None means the first tag seen.

    Raises:
        UnknownNameError: no tag has this name.
    """
    tag = _find(robot, idTag)
    return tag is not None and tag.is_right


def tag_on_the_center(robot: "Client", idTag: int | str | None = None) -> bool:
    """Does the camera see the tag in the middle of the picture?

    Args:
        idTag: the number or name of the tag; None means the first tag seen.

    Raises:
        UnknownNameError: no tag has this name.
    """
    tag = _find(robot, idTag)
    return tag is not None and tag.is_center


def get_tag_distance(robot: "Client", idTag: int | str | None = None) -> float | None:
    """How far is the tag from the camera, in mm?

    None if the tag is not in the picture, or if the camera's focal length is unknown. The black
    square of a tag is assumed to be 80 mm wide.

    Args:
        idTag: the number or name of the tag; None means the first tag seen.

    Raises:
        UnknownNameError: no tag has this name.
    """
    tag = _find(robot, idTag)
    return None if tag is None else tag.distance


def _lines(robot: "Client") -> "Lines | None":
    lines: Lines | None = robot.detect("lines")
    return lines


def _tags(robot: "Client") -> "Sequence[Tag]":
    return robot.detect("tags") or ()


def _find(robot: "Client", target: int | str | None) -> "Tag | None":
    """The first wanted tag in the picture: by number, by name, or None for any tag."""
    number = None if target is None else tag_id(target)
    return next((tag for tag in _tags(robot) if number is None or tag.id == number), None)
