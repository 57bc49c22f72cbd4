"""Emulates an EV3: ev3dev with our agent or rpyc, or LEGO's own firmware."""

import secrets
from collections.abc import Callable, Mapping
from importlib import resources
from pathlib import Path
from typing import Any

from learnblock.emulators.ev3.ev3dev import RPYC, Ev3dev
from learnblock.emulators.ev3.firmware import Firmware
from learnblock.emulators.ev3.motors import LEFT, RIGHT
from learnblock.emulators.twin import Twin
from learnblock.emulators.vehicle import Vehicle
from learnblock.errors import UnknownNameError

#: The agent's file.
AGENT = Path(str(resources.files("learnblock.robots.ev3"))) / "agent.py"


class Emulator:
    """A brick with two motors and four sensors, and one kind of connection.

    Args:
        twin: the robot that it drives.
        connection: ``agent``, ``rpyc`` or ``direct``.
        address: the local address on which it listens.
        port: its port; a free one by default.

    Attributes:
        settings: the settings with which a client reaches it.
        brick: the emulated brick.
    """

    def __init__(
        self, twin: Twin, *, connection: str = "agent", address: str = "127.0.0.1", port: int = 0
    ) -> None:
        if connection not in _BRICKS:
            raise UnknownNameError("connection", connection, _BRICKS)
        self.brick, settings = _BRICKS[connection](Vehicle(twin, LEFT, RIGHT), address, port)
        self.settings: Mapping[str, Any] = {
            "connection": connection,
            "address": address,
            **settings,
        }

    def close(self) -> None:
        self.brick.close()


def _agent(
    vehicle: Vehicle, address: str, port: int
) -> tuple[Ev3dev | Firmware, dict[str, object]]:
    brick = Ev3dev(vehicle)
    try:
        token = secrets.token_hex(8)
        (brick.folder / "token").write_text(token)
        place = ("--address", address, "--port", str(port))
        files = ("--token", str(brick.folder / "token"), "--sysfs", str(brick.sysfs))
        # With only the standard library, as on the brick.
        port = brick.start("-I", "-S", str(AGENT), *place, *files)
    except BaseException:
        brick.close()
        raise
    return brick, {"agent_port": port, "token": token}


def _rpyc(vehicle: Vehicle, address: str, port: int) -> tuple[Ev3dev | Firmware, dict[str, object]]:
    brick = Ev3dev(vehicle)
    try:
        port = brick.start("-c", RPYC, str(brick.sysfs), address, str(port))
    except BaseException:
        brick.close()
        raise
    return brick, {"rpyc_port": port}


def _direct(
    vehicle: Vehicle, address: str, port: int
) -> tuple[Ev3dev | Firmware, dict[str, object]]:
    firmware = Firmware(vehicle, address, port)
    return firmware, {"direct_port": firmware.port}


_BRICKS: dict[str, Callable[[Vehicle, str, int], tuple[Ev3dev | Firmware, dict[str, object]]]] = {
    "agent": _agent,
    "rpyc": _rpyc,
    "direct": _direct,
}
