"""A connection to a robot by Bluetooth Low Energy."""

import asyncio
from collections.abc import Callable
from typing import TYPE_CHECKING

from learnblock.closing import Closing
from learnblock.errors import RobotConnectionError
from learnblock.robots.bluetooth import finding, loopback
from learnblock.robots.event_loop import EventLoop
from learnblock.robots.real import require
from learnblock.timing import MONOTONIC, SteadyClock

if TYPE_CHECKING:
    from bleak import BleakClient


# Why: docs/decisions.md, "Bluetooth Low Energy is bleak's, and its other end in tests a socket"
class Radio(Closing):
    """Reads and writes the characteristics of a robot, from any thread; a failure ends it.

    Args:
        robot: the robot's id, for errors.
        address: its address or its name; empty for the first robot with the service.
        service: the UUID that such robots advertise.
        clock: the clock of its limits.
        seconds: the time limit for finding and connecting it.
        fits: leaves out robots of another kind with the same service.
        shares: whether another program of this computer is connected to it, and stays so.

    Attributes:
        address: the robot's own address, also if any robot with the service would do.
        signal: how strong the robot's radio was when it was found, dBm; None for an emulated one.

    Raises:
        MissingPackageError: bleak is not installed.
        RobotNotFoundError: there is no such robot.
        RobotConnectionError: this computer's Bluetooth can't be used, or another program has it.
    """

    def __init__(
        self,
        robot: str,
        address: str,
        service: str,
        clock: SteadyClock = MONOTONIC,
        seconds: float = 15.0,
        *,
        fits: finding.Fits = finding.fits_all,
        shares: bool = False,
    ) -> None:
        bleak = require("bleak", robot)
        self.signal: int | None = None
        self.address = address
        self._fits, self._shares = fits, shares
        self._lost = asyncio.Event()
        # One at a time: BlueZ refuses a second one.
        self._writing = asyncio.Lock()
        self.loop = EventLoop(address or robot, clock, failures=(bleak.BleakError,))
        try:
            client = self.loop.run(self._made(robot, address, service), finding.LOOKING + seconds)
            self._client: BleakClient = self.loop.enter(client, seconds)
            self.loop.start(self._watch())
        except BaseException:
            self.loop.close()
            raise

    def read(self, characteristic: str, seconds: float) -> bytes:
        """The value of a characteristic."""
        return bytes(self.loop.run(self._client.read_gatt_char(characteristic), seconds))

    def write(self, characteristic: str, data: bytes, seconds: float) -> None:
        """Write a characteristic; at the end the robot has confirmed it, if it confirms writes."""
        self.loop.run(self._written(characteristic, data), seconds)

    async def _written(self, characteristic: str, data: bytes) -> None:
        async with self._writing:
            await self._client.write_gatt_char(characteristic, data)

    def hear(self, characteristic: str, note: Callable[[bytes], None], seconds: float) -> None:
        """Call a function with each value that the robot notifies, in the loop's thread."""
        hearing = self._client.start_notify(characteristic, lambda _, data: note(bytes(data)))
        self.loop.run(hearing, seconds)

    def check(self) -> None:
        """Check that the connection is intact.

        Raises:
            RobotConnectionError: it is broken.
        """
        self.loop.check()

    def close(self) -> None:
        self.loop.close()

    async def _made(self, robot: str, address: str, service: str) -> "BleakClient":
        from bleak import BleakClient  # noqa: PLC0415 - an add-on

        if loopback.is_address(address):
            from learnblock.robots.bluetooth.loopback_client import (  # noqa: PLC0415 - as above
                LoopbackClient,
                SharingClient,
            )

            backend = SharingClient if self._shares else LoopbackClient
            return BleakClient(address, self._note_loss, backend=backend)
        device = finding.known(address)
        if device is None:
            device, self.signal = await finding.find(robot, address, service, self._fits)
        self.address = finding.place(device)
        return BleakClient(device, self._note_loss)

    def _note_loss(self, _: "BleakClient") -> None:
        self._lost.set()

    async def _watch(self) -> None:
        """Fail when the robot is gone."""
        await self._lost.wait()
        raise RobotConnectionError("bluetooth-lost", place=self.loop.place)
