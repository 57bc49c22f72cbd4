"""What the three kinds of scenes have in common: devices, and a sign of life."""

from collections.abc import Iterator
from typing import Protocol

from learnblock.devices import Device


class Scene(Protocol):
    """A robot in a scene of CoppeliaSim."""

    @property
    def has_watchdog(self) -> bool:
        """Whether its motors stop by themselves when nothing more is heard of the program."""

    def devices(self) -> Iterator[tuple[Device, str]]:
        """Its devices with their keys."""

    def move(self, adv: float, rot: float) -> None:
        """Drive at mm/s and degrees/s clockwise."""

    def beat(self) -> object:
        """Tell the robot that its program lives, and follow its turning."""
