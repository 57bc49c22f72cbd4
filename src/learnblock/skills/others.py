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


def elapsedTime(robot: "Client", seconds: float) -> bool:
    """Has the program been running for longer than this?

    Args:
        seconds: since it started.
    """
    return robot.time() > number("seconds", seconds)


def reset_timer(robot: "Client") -> None:
    """Start the timer again at 0."""
    robot.timer_start = robot.time()


def get_timer(robot: "Client") -> float:
    """How many seconds have passed since the last `reset_timer`, or since the program started?"""
    return round(robot.time() - robot.timer_start, 3)
