"""Lamps and their colours."""

from typing import TYPE_CHECKING

from learnblock.devices import FIRST_KEY, Led, RGBLed, number

if TYPE_CHECKING:
    from learnblock.client import Client


def led(robot: "Client", intensity: "bool | float", slot: str = FIRST_KEY) -> None:
    """Switch an LED on or off; a coloured one is white when it is on.

    Args:
        intensity: False switches it off and True on; so do 0 and any number above.
        slot: which LED, by its position, such as ``Left``; ``first`` is any robot's first.
    """
    on = intensity if isinstance(intensity, bool) else number("intensity", intensity) > 0
    kinds = {type(device) for _, device in robot.devices()}
    if RGBLed in kinds and Led not in kinds:
        level = 255 if on else 0
        RGBled(robot, level, level, level, slot)
        return
    lamp = robot.device(Led, slot)
    if lamp is not None:
        lamp.set(on)


def RGBled(robot: "Client", red: int, green: int, blue: int, slot: str = FIRST_KEY) -> None:
    """Set the colour of an LED.

    Args:
        red: 0 to 255.
        green: 0 to 255.
        blue: 0 to 255.
        slot: which LED, by its position, such as ``Left``; ``first`` is any robot's first.
    """
    lamp = robot.device(RGBLed, slot)
    if lamp is not None:
        lamp.set_color(red, green, blue)
