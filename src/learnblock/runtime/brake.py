"""Keeps a real robot still while its program is held: no world stands still for it."""

import threading
from collections.abc import Callable, Iterable
from functools import partial

from learnblock.devices import Base

Move = Callable[[float, float], object]


class Brake:
    """Stands between a program and the wheels; from any thread.

    While it is on, the wheels stand; what the program commands meanwhile is done afterwards.

    Args:
        bases: it is put into them.
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
            RobotConnectionError: the robot cannot be told.
        """
        with self._lock:
            self._on = True
            for wheels in self._wheels:
                wheels.move(0.0, 0.0)

    def resume(self) -> None:
        """Let the wheels turn as the program commanded last.

        Raises:
            RobotConnectionError: the robot cannot be told.
        """
        with self._lock:
            if self._on:
                self._on = False
                for wheels in self._wheels:
                    wheels.move(*wheels.wanted)

    def _move(self, wheels: "_Wheels", adv: float, rot: float) -> None:
        with self._lock:
            wheels.wanted = (adv, rot)
            # To stop is never wrong.
            if not self._on or wheels.wanted == (0.0, 0.0):
                wheels.move(adv, rot)


class _Wheels:
    """What moves a base, and what its program wants of it."""

    def __init__(self, move: Move) -> None:
        self.move = move
        self.wanted = (0.0, 0.0)
