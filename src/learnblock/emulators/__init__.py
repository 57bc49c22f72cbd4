"""Emulators: they speak a robot's protocol and move a twin in our simulator.

They are for testing a driver, or for trying it without the robot (``learnblock emulate cozmo
--world tags``).

    >>> from learnblock.emulators import emulate
    >>> from learnblock.robots import connect
    >>> with emulate("cozmo", world="empty") as emulator:  # doctest: +SKIP
    ...     robot = connect("cozmo", **emulator.settings)
    ...     robot.move_straight(50)
"""

import importlib
import socket
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from functools import partial
from typing import Any, Protocol

from learnblock.closing import Closing
from learnblock.emulators.twin import Twin
from learnblock.errors import UnknownNameError
from learnblock.i18n import Phrase
from learnblock.robots.bluetooth import loopback

#: The twin of each robot that can be emulated. RCIS's robot is an EBO, and the paper's scene in
#: CoppeliaSim contains an EV3.
TWINS: Mapping[str, str] = {
    "cozmo": "sim-cozmo",
    "coppeliasim": "sim-ev3",
    "create3": "sim-create3",
    "ebo": "sim-ebo",
    "ev3": "sim-ev3",
    "legoed": "sim-legoed",
    "rcis": "sim-ebo",
    "root": "sim-root",
    "spike": "sim-spike",
}


#: Robots with Bluetooth, which a page finds by itself if they are emulated at their usual place.
BY_BLUETOOTH = frozenset({"create3", "legoed", "root", "spike"})

#: Robots that are emulated in another simulator, to which our worlds are converted.
SIMULATED_ELSEWHERE = frozenset({"thymio"})


class Emulator(Protocol):
    """A robot's emulator: the class ``Emulator`` in the module with the robot's name.

    Its first argument is the twin that it drives, or, if another simulator moves the robot, the
    name of a world. It listens as soon as it is made.
    """

    #: The settings with which a client reaches it.
    settings: Mapping[str, Any]

    def close(self) -> None:
        """Stop listening."""


class Emulation(Closing):
    """A running emulator with its twin: a context manager.

    Args:
        begin: makes the emulator.
        twin: the robot that is moved; None if another simulator moves it.

    Attributes:
        settings: the settings with which a client reaches it.
        note: a missing part and what to do about it; None if nothing is missing.
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
        self.note: Phrase | None = getattr(emulator, "note", None)

    def close(self) -> None:
        """End the emulator and the twin; calling it twice is harmless."""
        self._ending.close()


def emulate(robot: str, world: str | None = None, *, seed: int = 0, **place: Any) -> Emulation:
    """Start to emulate a robot.

    Args:
        robot: its id, such as ``cozmo``.
        world: a world's name or the path of its file; by default the twin's world.
        seed: the seed of all noise; another simulator has its own noise.
        place: the address and port; by default a free port of this computer.

    Raises:
        UnknownNameError: this robot cannot be emulated, or there is no such world.
        MissingPackageError: another simulator is needed and not installed.
        EmulatorError: the emulator does not start.
        OSError: the port is not available.
    """
    if robot not in {*TWINS, *SIMULATED_ELSEWHERE}:
        raise UnknownNameError("emulator", robot, [*TWINS, *SIMULATED_ELSEWHERE])
    make = importlib.import_module(f"learnblock.emulators.{robot}").Emulator
    if robot in SIMULATED_ELSEWHERE:
        return Emulation(partial(make, world, **place))
    twin = Twin(TWINS[robot], world, seed=seed)
    return Emulation(partial(make, twin, **place), twin)


def usual_place(robot: str) -> dict[str, Any]:
    """Where a page finds an emulated robot by itself, as `emulate` takes it; empty if nowhere.

    Args:
        robot: its id.
    """
    if robot not in BY_BLUETOOTH:
        return {}
    address, port = loopback.place(loopback.HOME)
    try:
        socket.create_server((address, port)).close()
    except OSError:
        # Another robot is emulated there.
        return {}
    return {"address": address, "port": port}
