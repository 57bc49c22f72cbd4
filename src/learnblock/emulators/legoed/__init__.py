"""Emulates LEGO Education's devices: each with Bluetooth services of its own, as the real ones.

The maker's own Python programs drive them, too:

    learnblock emulate legoed --world line
    LEGOEDUCATION_BLE_IMPL=learnblock.emulators.legoed.transport:LoopbackTransport python program.py
"""

import threading
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any

from learnblock.emulators.gatt import GattServer
from learnblock.emulators.legoed.devices import ColourSensor, HandController, SingleMotor
from learnblock.emulators.legoed.double_motor import LEFT, RIGHT, DoubleMotor
from learnblock.emulators.legoed.firmware import DeviceFirmware
from learnblock.emulators.twin import Twin
from learnblock.emulators.vehicle import Vehicle
from learnblock.robots.legoed.messages import Product
from learnblock.robots.legoed.nearby import OTHERS

#: Seconds between two looks of the firmware at its motors.
TICK = 0.01
#: How often another row of free ports is looked for, when other programs take one of them.
_TRIES = 20


class Emulator:
    """A Double Motor, a Color Sensor, a Controller and a Single Motor with one connection card.

    Args:
        twin: the robot that they drive.
        address: the local address on which they listen.
        port: the Double Motor's port; free ones by default. The others are at the next ports.

    Attributes:
        settings: the settings with which a client reaches them.
        devices: the emulated devices, by kind.

    Raises:
        MissingPackageError: LEGO's package is not installed.
    """

    def __init__(self, twin: Twin, *, address: str = "127.0.0.1", port: int = 0) -> None:
        vehicle = Vehicle(twin, LEFT, RIGHT)
        self.devices: Mapping[Product, DeviceFirmware] = {
            Product.DOUBLE_MOTOR: DoubleMotor(vehicle, twin),
            Product.COLOUR_SENSOR: ColourSensor(vehicle),
            Product.CONTROLLER: HandController(),
            Product.SINGLE_MOTOR: SingleMotor(twin),
        }
        self._servers = _served(list(self.devices.values()), address, port)
        places = [f"{address}:{server.port}" for server in self._servers]
        names = ("address", *(OTHERS[product] for product in list(self.devices)[1:]))
        self.settings: Mapping[str, Any] = dict(zip(names, places, strict=True))
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._live, name="legoed", daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._closed.set()
        self._thread.join()
        for server in self._servers:
            server.close()

    def _live(self) -> None:
        while not self._closed.wait(TICK):
            for device in self.devices.values():
                device.tick()


def _served(devices: Sequence[DeviceFirmware], address: str, port: int) -> list[GattServer]:
    """Serve each device at the port after that of the one before, or else at a free one.

    Raises:
        OSError: the first port is not available.
    """
    servers = _in_a_row(devices, address, port)
    for _ in range(_TRIES if port == 0 else 0):
        if len(servers) == len(devices):
            break
        for server in servers:
            server.close()
        servers = _in_a_row(devices, address, port)
    # Their addresses are in the settings anyway; only the page looks at the next ports.
    return servers + [GattServer(device, address, 0) for device in devices[len(servers) :]]


def _in_a_row(devices: Sequence[DeviceFirmware], address: str, port: int) -> list[GattServer]:
    """Serve the devices at ports that follow one another, up to the first that is taken."""
    servers = [GattServer(devices[0], address, port)]
    with suppress(OSError, OverflowError):
        for device in devices[1:]:
            servers.append(GattServer(device, address, servers[-1].port + 1))
    return servers
