"""The interface of the three kinds of scenes."""

from collections.abc import Iterator
from typing import Protocol

from learnblock.devices import Device


class RobotScene(Protocol):
    """A robot in a scene of CoppeliaSim."""

    @property
    def has_watchdog(self) -> bool:
        """Whether the motors stop by themselves if the program sends no commands."""

    def devices(self) -> Iterator[tuple[Device, str]]:
        """The devices with their keys."""

    def move(self, adv: float, rot: float) -> None:
        """Drive at mm/s and degrees/s clockwise."""

    def beat(self) -> object:
        """Reset the robot's watchdog, and track its heading."""
