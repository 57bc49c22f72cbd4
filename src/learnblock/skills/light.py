"""The brightness of the surroundings."""

from typing import TYPE_CHECKING

from learnblock.devices import number

if TYPE_CHECKING:
    from learnblock.client import Client


def get_light(robot: "Client") -> float | None:
    """How bright is it? From 0 (dark) to 1023."""
    return robot.senses.brightness()


def is_illuminated(robot: "Client", threshold: float = 500) -> bool:
    """Is it bright?

    Args:
        threshold: the brightness, 0 to 1023, above which it is bright.
    """
    light = get_light(robot)
    return light is not None and light > number("threshold", threshold)
