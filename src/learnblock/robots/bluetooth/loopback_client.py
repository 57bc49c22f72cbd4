"""bleak's back end that reaches an emulated robot over a socket; it imports bleak."""

import asyncio
import json
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from bleak.args import SizedBuffer
from bleak.backends.characteristic import BleakGATTCharacteristic
from bleak.backends.client import BaseBleakClient, NotifyCallback
from bleak.backends.descriptor import BleakGATTDescriptor
from bleak.backends.service import BleakGATTService, BleakGATTServiceCollection
from bleak.exc import BleakError, BleakGATTProtocolError

from learnblock.errors import RobotBusyError
from learnblock.robots.bluetooth.loopback import LONGEST_LINE, place


class LoopbackClient(BaseBleakClient):
    """A client of `learnblock.emulators.gatt`."""

    #: What it sends first.
    opening = b""

    def __init__(self, address_or_ble_device: Any, **options: Any) -> None:
        super().__init__(
            address_or_ble_device,
            disconnected_callback=options["disconnected_callback"],
            timeout=options["timeout"],
        )
        self._name = ""
        self._largest = 20
        self._writer: asyncio.StreamWriter | None = None
        self._reading: asyncio.Task[None] | None = None
        self._answer: asyncio.Future[dict[str, Any]] | None = None
        self._asking = asyncio.Lock()
        self._listeners: dict[str, NotifyCallback] = {}

    @property
    def name(self) -> str:
        return self._name

    @property
    def mtu_size(self) -> int:
        # A write has three bytes more than its value.
        return self._largest + 3

    @property
    def is_connected(self) -> bool:
        return self._writer is not None

    async def connect(self, pair: bool, **_: Any) -> None:  # noqa: FBT001, ARG002 - bleak's own
        host, port = place(self.address)
        reader, writer = await asyncio.open_connection(host, port, limit=LONGEST_LINE)
        try:
            writer.write(self.opening)
            greeting = await self._greeted(reader)
        except BaseException:
            await _hang_up(writer)
            raise
        self._writer = writer
        self._name, self._largest = greeting["name"], greeting["largest"]
        self.services = self._collected(greeting["services"])
        self._reading = asyncio.create_task(self._read(reader))

    async def _greeted(self, reader: asyncio.StreamReader) -> dict[str, Any]:
        """The robot's first line, which describes it."""
        line = await reader.readline()
        if not line:
            raise BleakError("the connection was closed")
        try:
            greeting: dict[str, Any] = json.loads(line)
        except ValueError as error:
            raise BleakError("what answers is no emulated robot") from error
        if "taken" in greeting:
            raise RobotBusyError("bluetooth-taken", place=self.address)
        return greeting

    async def disconnect(self) -> None:
        # The driver asked for this, so the callback for a lost robot must not run.
        self._disconnected_callback = None
        if self._writer:
            await _hang_up(self._writer)
        if self._reading:
            # It may have been cancelled.
            await asyncio.wait({self._reading})

    async def pair(self, *_: Any, **__: Any) -> None:
        """Do nothing: an emulated robot needs no pairing."""

    async def unpair(self) -> None:
        """Do nothing, as above."""

    async def read_gatt_char(self, characteristic: BleakGATTCharacteristic, **_: Any) -> bytearray:
        answer = await self._ask({"read": characteristic.uuid})
        return bytearray.fromhex(answer["value"])

    async def write_gatt_char(
        self,
        characteristic: BleakGATTCharacteristic,
        data: SizedBuffer,
        response: bool,  # noqa: FBT001, ARG002 - bleak's own; all are confirmed here
    ) -> None:
        await self._ask({"write": characteristic.uuid, "value": bytes(data).hex()})

    async def read_gatt_descriptor(self, descriptor: BleakGATTDescriptor, **_: Any) -> bytearray:
        raise BleakError(f"an emulated robot has no descriptor {descriptor}")

    async def write_gatt_descriptor(
        self,
        descriptor: BleakGATTDescriptor,
        data: SizedBuffer,  # noqa: ARG002 - bleak's own
    ) -> None:
        raise BleakError(f"an emulated robot has no descriptor {descriptor}")

    async def start_notify(
        self, characteristic: BleakGATTCharacteristic, callback: NotifyCallback, **_: Any
    ) -> None:
        self._listeners[characteristic.uuid] = callback
        await self._ask({"hear": characteristic.uuid})

    async def stop_notify(self, characteristic: BleakGATTCharacteristic) -> None:
        self._listeners.pop(characteristic.uuid, None)

    async def _ask(self, request: dict[str, str]) -> dict[str, Any]:
        """Send a request, and return its answer."""
        async with self._asking:
            if self._writer is None:
                raise BleakError("not connected")
            self._answer = asyncio.get_running_loop().create_future()
            self._writer.write(json.dumps(request).encode() + b"\n")
            answer = await self._answer
        if "error" in answer:
            raise BleakGATTProtocolError(answer["error"])
        return answer

    async def _read(self, reader: asyncio.StreamReader) -> None:
        """Receive answers and notifications until the connection ends."""
        try:
            with suppress(OSError, ValueError):
                while line := await reader.readline():
                    self._take(json.loads(line))
        finally:
            await self._end()

    def _take(self, message: dict[str, Any]) -> None:
        if "notify" in message:
            listener = self._listeners.get(message["notify"])
            if listener:
                listener(bytearray.fromhex(message["value"]))
        elif self._answer and not self._answer.done():
            self._answer.set_result(message)

    async def _end(self) -> None:
        writer, self._writer = self._writer, None
        if writer:
            await _hang_up(writer)
        if self._answer and not self._answer.done():
            self._answer.set_exception(BleakError("disconnected"))
        lost: Callable[[], None] | None = self._disconnected_callback
        if lost:
            lost()

    def _collected(self, services: dict[str, dict[str, Any]]) -> BleakGATTServiceCollection:
        """The services as bleak knows them; it finds each by a number of its own."""
        collection = BleakGATTServiceCollection()
        handle = 0
        for service_uuid, characteristics in services.items():
            service = BleakGATTService(None, handle := handle + 1, service_uuid)
            collection.add_service(service)
            for uuid, properties in characteristics.items():
                characteristic = BleakGATTCharacteristic(
                    None, handle := handle + 1, uuid, properties, lambda: self._largest, service
                )
                collection.add_characteristic(characteristic)
        return collection


class SharingClient(LoopbackClient):
    """Shares the connection that another program of this computer has."""

    opening = b'{"share": true}\n'


async def _hang_up(writer: asyncio.StreamWriter) -> None:
    writer.close()
    with suppress(OSError):
        await writer.wait_closed()
