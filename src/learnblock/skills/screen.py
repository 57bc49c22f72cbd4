"""Text and numbers on the robot's screen."""

from typing import TYPE_CHECKING

from learnblock.devices import Screen, number

if TYPE_CHECKING:
    from learnblock.client import Client


def show_text(robot: "Client", text: str = "hello") -> None:
    """Show a text on the robot's screen, instead of what was there.

    In a world, the text of a robot without a screen is beside it. A real robot without a screen
    prints it.

    Args:
        text: at most 100 characters; the rest is cut.
    """
    _show(robot, str(text))


def show_number(robot: "Client", value: float = 0) -> None:
    """Show a number on the robot's screen, instead of what was there.

    Args:
        value: the number; it is rounded to two decimals.
    """
    rounded = round(number("value", value), 2) + 0.0
    _show(robot, f"{rounded:.2f}".rstrip("0").rstrip("."))


def clear_screen(robot: "Client") -> None:
    """Clear the robot's screen."""
    _show(robot, "")


def _show(robot: "Client", text: str) -> None:
    screen = robot.device(Screen)
    if screen is None:
        robot.unseen.show(text)
    elif not screen.show_text(text):
        robot.note_missing("Screen:text")
        robot.unseen.show(text)
