"""iRobot's own program for its robots, with another back end instead of its Bluetooth.

It wants a bleak that is older than ours, so only what is not its back end is used.
"""

import json
import subprocess
import sys
from collections.abc import Iterable
from typing import Any

import pytest

#: Runs a program by iRobot's classes: kind of robot, place or nothing, and the program, in which
#: `robot` is the robot and `said` is printed. Without a place the packets are printed and not sent.
RUNNER = '''
import asyncio
import json
import sys
import textwrap

from irobot_edu_sdk.backend.backend import Backend
from irobot_edu_sdk.packet import Packet
from irobot_edu_sdk.robots import Create3, Root

TO_ROBOT = "6e400002-b5a3-f393-e0a9-e50e24dcca9e"
FROM_ROBOT = "6e400003-b5a3-f393-e0a9-e50e24dcca9e"


class Noting(Backend):
    """Notes the packets."""

    packets = []

    async def is_connected(self):
        return True

    async def write_packet(self, packet):
        self.packets.append(packet.to_bytes().hex())


class Loopback(Backend):
    """Speaks with an emulated robot, by our back end of bleak's."""

    def __init__(self, place):
        from bleak import BleakClient
        from learnblock.robots.bluetooth.loopback_client import LoopbackClient

        self.client = BleakClient(place, backend=LoopbackClient)
        self.packets = asyncio.Queue()

    async def connect(self):
        await self.client.connect()
        await self.client.start_notify(FROM_ROBOT, lambda _, data: self.packets.put_nowait(data))

    async def is_connected(self):
        return self.client.is_connected

    async def disconnect(self):
        await self.client.disconnect()

    async def write_packet(self, packet):
        await self.client.write_gatt_char(TO_ROBOT, packet.to_bytearray(), True)

    async def read_packet(self):
        return Packet.from_bytes(bytes(await self.packets.get()))


async def main(kind, place, program):
    backend = Loopback(place) if place else Noting()
    robot = {"Root": Root, "Create3": Create3}[kind](backend)
    # Where nothing answers, it must not wait.
    robot.DEFAULT_TIMEOUT = 8 if place else -1e9
    said = {}
    names = {"robot": robot, "said": said, "asyncio": asyncio}
    exec("async def play():\\n" + textwrap.indent(program, "    "), names)
    if place:
        await backend.connect()
        type(robot)._run = robot.__class__.__mro__[1]._run = True
        reading = asyncio.create_task(robot._read_packets())
        await robot.stop()
    await names["play"]()
    if place:
        reading.cancel()
        await backend.disconnect()
    print(json.dumps(said if place else backend.packets))


loop = asyncio.new_event_loop()
asyncio.set_event_loop(loop)
loop.run_until_complete(main(*sys.argv[1:]))
'''


def packets_of(kind: str, calls: Iterable[str]) -> list[bytes]:
    """What iRobot's program sends for calls of its methods."""
    sent = _run(kind, "", "\n".join(f"await robot.{call}" for call in calls))
    return [bytes.fromhex(packet) for packet in sent]


def run_sdk(kind: str, place: str, program: str) -> dict[str, Any]:
    """Run a program of iRobot's on an emulated robot; return what it has noted in `said`."""
    said: dict[str, Any] = _run(kind, place, program)
    return said


def _run(*arguments: str) -> Any:
    pytest.importorskip("irobot_edu_sdk", reason="iRobot's own program is not installed")
    done = subprocess.run(
        [sys.executable, "-c", RUNNER, *arguments], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])
