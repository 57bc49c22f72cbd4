"""An LED matrix of 8 by 16 LEDs; a robot without one shows text and numbers on its screen."""

from typing import TYPE_CHECKING

from learnblock.devices import Matrix
from learnblock.skills.screen import show_number, show_text

if TYPE_CHECKING:
    from learnblock.client import Client


def matrix_number(robot: "Client", number: float, intensity: int = 4) -> None:
    """Show a number on the LED matrix; without one, as `show_number` does.

    Args:
        number: what to show.
        intensity: brightness of the LEDs, 0 to 7.
    """
    matrix = _matrix(robot)
    if matrix is not None:
        matrix.number(number, intensity)
    elif robot.senses.text_display():
        show_number(robot, number)
    else:
        robot.unseen.show(str(number))


def matrix_text(robot: "Client", text: str, intensity: int = 4, column: int = 0) -> None:
    """Show text on the LED matrix; without one, as `show_text` does.

    Args:
        text: what to show.
        intensity: brightness of the LEDs, 0 to 7.
        column: of the LEDs, 0 to 15 from the left, where the text starts.
    """
    matrix = _matrix(robot)
    if matrix is not None:
        matrix.text(text, intensity, column)
    elif robot.senses.text_display():
        show_text(robot, text)
    else:
        robot.unseen.show(str(text))


def matrix_icon(robot: "Client", icon: str, intensity: int = 4) -> None:
    """Show an icon on the LED matrix.

    Args:
        icon: the icon's name.
        intensity: brightness, 0 to 7.
    """
    matrix = robot.device(Matrix)
    if matrix is not None:
        matrix.icon(icon, intensity)


def _matrix(robot: "Client") -> Matrix | None:
    """The matrix; that a robot has none is not worth a report where its screen serves."""
    return robot.device(Matrix) if robot.has(Matrix) else None
