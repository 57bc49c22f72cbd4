"""Waiting, and the time since the program started."""

from typing import TYPE_CHECKING

from learnblock.devices import number

if TYPE_CHECKING:
    from learnblock.client import Client


def sleep(robot: "Client", seconds: float = 1) -> None:
    """Wait; meanwhile the robot keeps moving.

    Args:
        seconds: how long to wait.
    """
    robot.clock.sleep(number("seconds", seconds))


def elapsedTime(robot: "Client", seconds: float = 0) -> bool:
    """Has the program been running for longer than this?

    Args:
        seconds: since it started.
    """
    return robot.time() > number("seconds", seconds)
