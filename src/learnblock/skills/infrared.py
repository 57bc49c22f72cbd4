"""Infrared remote controls."""

from typing import TYPE_CHECKING

from learnblock.devices import Infrared

if TYPE_CHECKING:
    from learnblock.client import Client


def get_IR(robot: "Client") -> int | None:
    """Which code did the remote control send last? None before the first one."""
    return robot.read(Infrared)


def is_this_code_IR(robot: "Client", code: int) -> bool:
    """Did the remote control send this code last?

    Args:
        code: the number of a key.
    """
    return get_IR(robot) == code


def send_code_IR(robot: "Client", code: int) -> None:
    """Send a code, as a remote control does.

    Args:
        code: the number of a key.
    """
    infrared = robot.device(Infrared)
    if infrared is not None:
        infrared.send(code)
