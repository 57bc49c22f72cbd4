"""What the three kinds of scenes have in common: devices, and a sign of life."""

from collections.abc import Callable, Iterator
from typing import Protocol

from learnblock.devices import Device


class Scene(Protocol):
    """A robot in a scene of CoppeliaSim."""

    def devices(self) -> Iterator[tuple[Device, str]]:
        """Its devices with their keys."""

    def move(self, adv: float, rot: float) -> None:
        """Drive at mm/s and degrees/s clockwise."""

    @property
    def beat(self) -> Callable[[], None] | None:
        """Tells the robot that its program lives; None where nobody listens for that."""
