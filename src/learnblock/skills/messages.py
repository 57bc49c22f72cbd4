"""Messages between the robots of one run."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from learnblock.client import Client


def send(robot: "Client", message: str = "go", value: "str | None" = None) -> None:
    """Send a message to all other robots.

    Args:
        message: the name of the message, such as "go".
        value: a number, a text, true or false, or a list of these that goes with it.
    """
    _take_time(robot)
    robot.mailbox.send(message, value)


# Why: docs/decisions.md, "Messages are skills, not syntax"
def received(robot: "Client", message: str = "go") -> bool:
    """Has another robot sent this message? Each message is answered with yes once.

    Args:
        message: the name of the message.
    """
    _take_time(robot)
    return robot.mailbox.take(message)


def message_value(robot: "Client", message: str = "go") -> Any:
    """What came with the message that was received last; None before the first one.

    Args:
        message: the name of the message.
    """
    return robot.mailbox.value(message)


def _take_time(robot: "Client") -> None:
    """A program that only asks must let time pass, or nothing could arrive."""
    if not robot.readings.frozen:
        robot.clock.charge()
