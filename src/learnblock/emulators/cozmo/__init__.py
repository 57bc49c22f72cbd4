"""Cozmo's end of its wire: what its real driver says moves the twin ``sim-cozmo``.

It follows pycozmo's description of the protocol (docs/protocol.md, docs/functions.md) and, where
that is silent, the transport that Anki published with its later robots. Left out are cubes, paths,
the robot's own memory and firmware updates: such commands are acknowledged and have no effect.
"""

from collections.abc import Mapping
from typing import Any

from learnblock.emulators.twin import Twin
from learnblock.robots.real import require

__all__ = ["Emulator"]


class Emulator:
    """A Cozmo that listens at an address of this machine.

    Args:
        twin: the robot that it drives.
        address: where it listens.
        port: of UDP; 0 takes a free one.

    Attributes:
        settings: those with which the driver reaches it.
        machine: the robot behind the wire.

    Raises:
        MissingPackageError: pycozmo is not installed.
        OSError: it cannot listen there.
    """

    def __init__(self, twin: Twin, *, address: str = "127.0.0.1", port: int = 0) -> None:
        require("pycozmo", "cozmo")
        # They need pycozmo, which only those install who want a Cozmo.
        from learnblock.emulators.cozmo.machine import TICK, Machine  # noqa: PLC0415
        from learnblock.emulators.cozmo.server import Server  # noqa: PLC0415

        self.machine = Machine(twin)
        self._server = Server(self.machine, address, port, TICK / twin.speed)
        self.settings: Mapping[str, Any] = {"address": address, "port": self._server.port}

    def close(self) -> None:
        """Stop the motors and listen no more; the second time it does nothing."""
        self._server.close()
