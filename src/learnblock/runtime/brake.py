"""Keeps a real robot still while its program is paused, because its world cannot be."""

import threading
from collections.abc import Callable, Iterable
from functools import partial

from learnblock.devices import Base

Move = Callable[[float, float], object]


class Brake:
    """Stops the wheels while a program is paused; thread-safe.

    While it is on, the wheels do not move; commands take effect when it is released.

    Args:
        bases: the wheels that it stops.
    """

    def __init__(self, bases: Iterable[Base]) -> None:
        self._lock = threading.Lock()
        self._on = False
        self._wheels: list[_Wheels] = []
        for base in bases:
            wheels = _Wheels(base.functions["move"])
            self._wheels.append(wheels)
            base.functions["move"] = partial(self._move, wheels)

    def pause(self) -> None:
        """Stop the wheels.

        Raises:
            RobotConnectionError: the robot cannot be reached.
        """
        with self._lock:
            self._on = True
            for wheels in self._wheels:
                wheels.move(0.0, 0.0)

    def resume(self) -> None:
        """Apply the program's last command to the wheels.

        Raises:
            RobotConnectionError: the robot cannot be reached.
        """
        with self._lock:
            if self._on:
                self._on = False
                for wheels in self._wheels:
                    wheels.move(*wheels.wanted)

    def _move(self, wheels: "_Wheels", adv: float, rot: float) -> None:
        with self._lock:
            wheels.wanted = (adv, rot)
            # Stopping is always safe.
            if not self._on or wheels.wanted == (0.0, 0.0):
                wheels.move(adv, rot)


class _Wheels:
    """The function that moves a base, and the program's last command to it."""

    def __init__(self, move: Move) -> None:
        self.move = move
        self.wanted = (0.0, 0.0)
