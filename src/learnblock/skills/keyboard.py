"""The keyboard of the computer, to drive a robot by hand."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from learnblock.client import Client


def is_key_pressed(robot: "Client", key: str = "space") -> bool:
    """Is this key of the keyboard held down?

    Args:
        key: up, down, left, right, space, enter, a letter from a to z or a digit from 0 to 9.

    Raises:
        UnknownNameError: there is no such key.
    """
    # In a program that only asks, time must pass too, so that a key can be pressed.
    robot.await_reading("keys")
    return robot.keyboard.is_pressed(key)
