"""A pen that draws on the floor of a world."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from learnblock.devices import Pen
from learnblock.errors import DeviceValueError

if TYPE_CHECKING:
    from learnblock.client import Client

#: The colours by name: red, green and blue.
COLORS: Mapping[str, tuple[int, int, int]] = {
    "red": (215, 25, 25),
    "orange": (240, 135, 30),
    "yellow": (240, 205, 40),
    "green": (40, 150, 60),
    "blue": (25, 70, 215),
    "purple": (130, 60, 160),
    "pink": (240, 110, 170),
    "brown": (140, 95, 60),
    "black": (20, 20, 20),
    "white": (240, 240, 240),
}


def pen_down(robot: "Client") -> None:
    """Draw a line on the floor from now on, wherever the robot drives.

    The pen is at the middle between the wheels.
    """
    pen = robot.device(Pen)
    if pen is not None:
        pen.set(down=True)


def pen_up(robot: "Client") -> None:
    """Lift the pen, so that the robot no longer draws."""
    pen = robot.device(Pen)
    if pen is not None:
        pen.set(down=False)


def set_pen_color(robot: "Client", color: str = "red") -> None:
    """Set the colour of the pen.

    Args:
        color: the name of a colour, or red, green and blue as in "#ff8800".

    Raises:
        DeviceValueError: it is not a colour.
    """
    levels = _levels(str(color))
    pen = robot.device(Pen)
    if pen is not None:
        pen.set_color(*levels)


def set_pen_width(robot: "Client", width: float = 6) -> None:
    """Set the width of the pen.

    Args:
        width: mm, 1 to 50.
    """
    pen = robot.device(Pen)
    if pen is not None:
        pen.set_width(width)


def clear_drawing(robot: "Client") -> None:
    """Erase everything that the robot has drawn."""
    pen = robot.device(Pen)
    if pen is not None:
        pen.clear()


def _levels(color: str) -> tuple[int, int, int]:
    if color in COLORS:
        return COLORS[color]
    digits = color.removeprefix("#")
    try:
        red, green, blue = bytes.fromhex(digits)
    except ValueError:
        raise DeviceValueError(
            "device-unknown-color", color=f"{color!r:.80}", known=tuple(COLORS)
        ) from None
    return red, green, blue
