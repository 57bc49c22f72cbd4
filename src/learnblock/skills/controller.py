"""A hand controller with eight buttons."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from learnblock.devices import Controller
from learnblock.errors import UnknownNameError

if TYPE_CHECKING:
    from learnblock.client import Client

_BUTTONS = ("lUp", "lLeft", "lRight", "lDown", "rUp", "rLeft", "rRight", "rDown")


def get_8_button_controller(robot: "Client") -> Mapping[str, bool] | None:
    """Which buttons of the controller are pressed? True or False for each button by name."""
    return robot.read(Controller)


def is_press_8_button_controller(robot: "Client", button: str = "lUp") -> bool:
    """Is a button of the controller pressed?

    Args:
        button: lUp, lLeft, lRight, lDown, rUp, rLeft, rRight or rDown.

    Raises:
        UnknownNameError: the controller has no such button.
    """
    if button not in _BUTTONS:
        raise UnknownNameError("button", str(button), _BUTTONS)
    pressed = get_8_button_controller(robot) or {}
    return bool(pressed.get(button))
