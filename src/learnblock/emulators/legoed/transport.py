"""Lets LEGO's own package reach the emulated devices; it imports that package.

Set ``LEGOEDUCATION_BLE_IMPL`` to ``learnblock.emulators.legoed.transport:LoopbackTransport``, and a
program that is written with `legoeducation` alone drives the twin of ``learnblock emulate legoed``.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from bleak import BleakClient
from legoeducation.ble_transport import BLETransport

from learnblock.robots.bluetooth import loopback
from learnblock.robots.bluetooth.loopback_client import LoopbackClient
from learnblock.robots.legoed import messages
from learnblock.robots.legoed.messages import Product
from learnblock.robots.legoed.nearby import NAMES


@dataclass(frozen=True)
class EmulatedDevice:
    """A device as the package knows it."""

    name: str
    address: str


class LoopbackTransport(BLETransport):  # type: ignore[misc]  # it has no types
    """The package's connection to devices at `home` and the next ports."""

    #: Where the Double Motor is.
    home = loopback.HOME

    def __init__(self, shutdown_callback: Callable[[], None] | None = None) -> None:
        super().__init__(shutdown_callback)
        self._clients: dict[str, BleakClient] = {}

    async def scan_devices(
        self, timeout: float, filters: Mapping[str, Any] | None = None
    ) -> list[EmulatedDevice]:
        del timeout
        wanted = (filters or {}).get("product_id")
        names = [NAMES[Product(wanted)]] if wanted else list(NAMES.values())
        host, port = loopback.place(self.home)
        places = [f"{host}:{number}" for number in range(port, port + len(NAMES))]
        greetings = {place: loopback.greeting(place) for place in places}
        return [
            EmulatedDevice(greeting["name"], place)
            for place, greeting in greetings.items()
            if greeting.get("name") in names
        ]

    async def connect(
        self,
        device: EmulatedDevice,
        notification_callback: Callable[..., Any],
        disconnect_callback: Callable[[], None],
    ) -> bool:
        client = BleakClient(
            device.address, lambda _: disconnect_callback(), backend=LoopbackClient
        )
        await client.connect()
        await client.start_notify(messages.EVENTS, notification_callback)
        self._clients[device.address] = client
        return True

    async def send(self, device: EmulatedDevice, message: bytes) -> None:
        await self._clients[device.address].write_gatt_char(messages.COMMANDS, message)

    async def device_disconnect(self, device: EmulatedDevice) -> None:
        client = self._clients.pop(device.address, None)
        if client:
            await client.disconnect()

    def shutdown_all(self) -> None:
        """Let the connections end with the program."""
        if self.shutdown_callback:
            self.shutdown_callback()
