"""An LED matrix of 8 by 16 LEDs."""

from typing import TYPE_CHECKING

from learnblock.devices import Matrix

if TYPE_CHECKING:
    from learnblock.client import Client


def matrix_number(robot: "Client", number: float, intensity: int = 4) -> None:
    """Show a number on the LED matrix.

    Args:
        number: what to show.
        intensity: brightness, 0 to 7.
    """
    matrix = robot.device(Matrix)
    if matrix is not None:
        matrix.number(number, intensity)


def matrix_text(robot: "Client", text: str, intensity: int = 4, column: int = 0) -> None:
    """Show text on the LED matrix.

    Args:
        text: what to show.
        intensity: brightness, 0 to 7.
        column: where the text starts, 0 to 15 from the left.
    """
    matrix = robot.device(Matrix)
    if matrix is not None:
        matrix.text(text, intensity, column)


def matrix_icon(robot: "Client", icon: str, intensity: int = 4) -> None:
    """Show an icon on the LED matrix.

    Args:
        icon: the icon's name.
        intensity: brightness, 0 to 7.
    """
    matrix = robot.device(Matrix)
    if matrix is not None:
        matrix.icon(icon, intensity)
