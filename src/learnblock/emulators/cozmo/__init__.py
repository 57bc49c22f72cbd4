"""An emulated Cozmo, which speaks its protocol and drives the twin ``sim-cozmo``.

It follows pycozmo's description of the protocol (docs/protocol.md, docs/functions.md) and, for the
rest, the transport that Anki published with its later robots. Cubes, paths, the robot's memory and
firmware updates are missing: their commands are acknowledged and have no effect.
"""

from collections.abc import Mapping
from typing import Any

from learnblock.emulators.twin import Twin
from learnblock.robots.real import require

__all__ = ["Emulator"]


class Emulator:
    """A Cozmo on a port of this machine.

    Args:
        twin: the simulated robot that it drives.
        address: the address to listen at.
        port: the UDP port; 0 takes a free one.

    Attributes:
        settings: the settings that make the driver connect to it.
        machine: the emulated robot.

    Raises:
        MissingPackageError: pycozmo is not installed.
        OSError: it cannot listen there.
    """

    def __init__(self, twin: Twin, *, address: str = "127.0.0.1", port: int = 0) -> None:
        require("pycozmo", "cozmo")
        # These modules need pycozmo, which is not always installed.
        from learnblock.emulators.cozmo.machine import TICK, CozmoMachine  # noqa: PLC0415
        from learnblock.emulators.cozmo.server import Server  # noqa: PLC0415

        self.machine = CozmoMachine(twin)
        self._server = Server(self.machine, address, port, TICK / twin.speed)
        self.settings: Mapping[str, Any] = {"address": address, "port": self._server.port}

    def close(self) -> None:
        """Stop the motors and close the port; calling it twice is harmless."""
        self._server.close()
