"""The robot's end of a wire, driven by our simulator.

An emulator speaks a robot's own protocol, and what it is told moves a twin in a world: to test a
driver, or to try it without the robot (``learnblock emulate cozmo --world tags``).

    >>> from learnblock.emulators import emulate
    >>> from learnblock.robots import connect
    >>> with emulate("cozmo", world="empty") as emulator:  # doctest: +SKIP
    ...     robot = connect("cozmo", **emulator.settings)
    ...     robot.move_straight(50)
"""

import importlib
import threading
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from functools import partial
from typing import Any, Protocol

from learnblock.closing import Closing
from learnblock.emulators.twin import Twin
from learnblock.errors import UnknownNameError

#: The twin of each robot that can be emulated. RCIS's robot is built like EBO, and CoppeliaSim's
#: scene of the paper like an EV3.
TWINS: Mapping[str, str] = {
    "cozmo": "sim-cozmo",
    "coppeliasim": "sim-ev3",
    "ebo": "sim-ebo",
    "ev3": "sim-ev3",
    "rcis": "sim-ebo",
}


#: Robots with a simulator of their own, in which our worlds are built.
SIMULATED_ELSEWHERE = frozenset({"thymio"})


class Emulator(Protocol):
    """The robot's end of a wire: a class ``Emulator`` in the module of the robot's name.

    It is made with the twin that it drives, or with the name of a world where a simulator of others
    moves the robot, and listens from then on.
    """

    #: The settings with which a client reaches it.
    settings: Mapping[str, Any]

    def close(self) -> None:
        """Listen no more."""


class Emulation(Closing):
    """An emulator with its twin, while they run: a context manager.

    Args:
        begin: makes the emulator.
        twin: the robot that is moved; None where a simulator of others moves it.

    Attributes:
        settings: those with which a client reaches it.
        note: what the emulator lacks, and what to do about it; empty where it lacks nothing.
    """

    def __init__(self, begin: Callable[[], Emulator], twin: Twin | None = None) -> None:
        self.twin = twin
        self._ending = ExitStack()
        if twin is not None:
            self._ending.enter_context(twin)
        try:
            emulator = begin()
        except BaseException:
            self._ending.close()
            raise
        self._ending.callback(emulator.close)
        self.settings = emulator.settings
        self.note: str = getattr(emulator, "note", "")

    def wait(self) -> None:
        """Wait for ever, or for Ctrl-C."""
        threading.Event().wait()

    def close(self) -> None:
        """End both; the second time it does nothing."""
        self._ending.close()


def emulate(robot: str, world: str | None = None, *, seed: int = 0, **place: Any) -> Emulation:
    """Begin to emulate a robot.

    Args:
        robot: its id, such as ``cozmo``.
        world: a world's name or the path of its file; by default the twin's own.
        seed: of all noise; a simulator of others has noise of its own.
        place: where the emulator listens, if not at a free port of this machine.

    Raises:
        UnknownNameError: this robot cannot be emulated, or there is no such world.
        MissingPackageError: a simulator of others is not installed.
        OSError: it cannot listen there.
    """
    if robot not in {*TWINS, *SIMULATED_ELSEWHERE}:
        raise UnknownNameError("emulator", robot, [*TWINS, *SIMULATED_ELSEWHERE])
    make = importlib.import_module(f"learnblock.emulators.{robot}").Emulator
    if robot in SIMULATED_ELSEWHERE:
        return Emulation(partial(make, world, **place))
    twin = Twin(TWINS[robot], world, seed=seed)
    return Emulation(partial(make, twin, **place), twin)
