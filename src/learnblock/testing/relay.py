"""A link between a client and its robot that can be made to fail in tests."""

import asyncio
import random
import socket
import threading
from enum import Enum, auto
from typing import Any, Self

from learnblock.closing import Closing

_CHUNK = 65536


class Fault(Enum):
    """A fault of a link."""

    NONE = auto()
    #: Nothing passes, and no connection is closed: the robot hangs, or is out of range.
    SILENT = auto()
    #: The robot's data arrives damaged.
    GARBAGE = auto()
    #: All data arrives `Relay.delay` seconds late.
    SLOW = auto()
    #: Connections are closed, and new ones rejected.
    CUT = auto()


class Relay(Closing):
    """Forward data between client and robot over TCP or UDP, subject to a fault.

        with Relay(("127.0.0.1", port)) as relay:
            robot = connect("rcis", base_port=relay.port)
            relay.fault = Fault.SILENT

    Args:
        target: the robot's address and port.
        udp: use UDP instead of TCP.
        seed: the seed for lost datagrams and damaged data.

    Attributes:
        port: its own port on 127.0.0.1.
        delay: the delay in seconds of a slow link.
        loss: the share of lost datagrams, 0 to 1.
        passed: the bytes forwarded so far in both directions.
        lost: the datagrams lost so far in both directions.
    """

    def __init__(self, target: tuple[str, int], *, udp: bool = False, seed: int = 0) -> None:
        self.target = target
        self.delay = 0.3
        self.loss = 0.0
        self.passed = 0
        self.lost = 0
        self._fault = Fault.NONE
        self._random = random.Random(seed)  # noqa: S311 - needs no secure numbers
        self._loop = asyncio.new_event_loop()
        self._socket = socket.socket(
            socket.AF_INET, socket.SOCK_DGRAM if udp else socket.SOCK_STREAM
        )
        self._socket.bind(("127.0.0.1", 0))
        if not udp:
            self._socket.listen()
        self._socket.settimeout(0)
        self.port: int = self._socket.getsockname()[1]
        self._wires: set[asyncio.StreamWriter] = set()
        self._serve = self._serve_udp if udp else self._serve_tcp
        self._thread = threading.Thread(target=self._run, name="relay", daemon=True)
        self._ended = asyncio.Event()

    @property
    def fault(self) -> Fault:
        """The current fault; it can be set at any time, from any thread."""
        return self._fault

    @fault.setter
    def fault(self, fault: Fault) -> None:
        self._fault = fault
        if fault is Fault.CUT:
            self._loop.call_soon_threadsafe(self._close_wires)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def close(self) -> None:
        if self._thread.is_alive():
            self._loop.call_soon_threadsafe(self._ended.set)
            self._thread.join()

    def _run(self) -> None:
        try:
            self._loop.run_until_complete(self._serve())
        finally:
            self._socket.close()
            self._loop.close()

    # TCP.

    async def _serve_tcp(self) -> None:
        server = await asyncio.start_server(self._join, sock=self._socket)
        await self._ended.wait()
        server.close()
        # Nothing passes any more, so that each connection ends.
        self.fault = Fault.CUT
        self._close_wires()
        await asyncio.gather(*asyncio.all_tasks() - {asyncio.current_task()})

    def _close_wires(self) -> None:
        for wire in self._wires:
            wire.transport.abort()
        self._wires.clear()

    async def _join(self, client: asyncio.StreamReader, to_client: asyncio.StreamWriter) -> None:
        if not self._admits():
            to_client.transport.abort()
            return
        try:
            robot, to_robot = await asyncio.open_connection(*self.target)
        except OSError:
            # The robot does not listen, so the client's connection is closed.
            to_client.transport.abort()
            return
        if not self._admits():
            to_robot.transport.abort()
            to_client.transport.abort()
            return
        self._wires |= {to_client, to_robot}
        ends = (
            self._pass_on(client, to_robot, back=False),
            self._pass_on(robot, to_client, back=True),
        )
        await asyncio.gather(*ends)
        self._wires -= {to_client, to_robot}

    def _admits(self) -> bool:
        return self._fault is not Fault.CUT

    async def _pass_on(
        self, source: asyncio.StreamReader, sink: asyncio.StreamWriter, *, back: bool
    ) -> None:
        try:
            while data := await source.read(_CHUNK):
                if self._fault is Fault.SLOW:
                    await asyncio.sleep(self.delay)
                if self._fault is not Fault.SILENT:
                    # Counted first, because the receiver may read the counter at once.
                    self.passed += len(data)
                    sink.write(self._damaged(data) if back else data)
                    await sink.drain()
        except OSError:
            # One end closed the connection, so the relay closes the other.
            pass
        finally:
            sink.close()

    def _damaged(self, data: bytes) -> bytes:
        return self._random.randbytes(len(data)) if self._fault is Fault.GARBAGE else data

    # UDP.

    async def _serve_udp(self) -> None:
        front = _Front(self)
        await self._loop.create_datagram_endpoint(lambda: front, sock=self._socket)
        await self._ended.wait()
        front.close()

    def forward(self, data: bytes, sink: asyncio.DatagramTransport, address: Any) -> None:
        """Forward a datagram through `sink` unless it gets lost."""
        if self._fault in {Fault.SILENT, Fault.CUT} or self._random.random() < self.loss:
            self.lost += 1
            return
        self.passed += len(data)
        wait = self.delay if self._fault is Fault.SLOW else 0.0
        self._loop.call_later(wait, lambda: sink.sendto(data, address))

    def damaged(self, data: bytes) -> bytes:
        """The data as the client receives it."""
        return self._damaged(data)


class _Front(asyncio.DatagramProtocol):
    """The end of the clients; each client gets its own socket towards the robot."""

    def __init__(self, relay: Relay) -> None:
        self._relay = relay
        self._backs: dict[object, _Back] = {}

    def close(self) -> None:
        for back in self._backs.values():
            back.close()
        self._transport.close()

    def connection_made(self, transport: asyncio.DatagramTransport) -> None:  # type: ignore[override]
        self._transport = transport

    def datagram_received(self, data: bytes, address: object) -> None:
        back = self._backs.get(address)
        if back is None:
            back = self._backs[address] = _Back(self._relay, self._transport, address)
            loop = asyncio.get_running_loop()
            back.opening = loop.create_task(self._open(back))
        back.send(data)

    async def _open(self, back: "_Back") -> None:
        loop = asyncio.get_running_loop()
        await loop.create_datagram_endpoint(lambda: back, remote_addr=self._relay.target)


class _Back(asyncio.DatagramProtocol):
    """The robot's end of the link of one client."""

    def __init__(self, relay: Relay, front: asyncio.DatagramTransport, client: object) -> None:
        self.opening: asyncio.Task[None] | None = None
        self._relay, self._front, self._client = relay, front, client
        self._transport: asyncio.DatagramTransport | None = None
        self._waiting: list[bytes] = []

    def connection_made(self, transport: asyncio.DatagramTransport) -> None:  # type: ignore[override]
        self._transport = transport
        for data in self._waiting:
            self._relay.forward(data, transport, None)

    def close(self) -> None:
        if self._transport:
            self._transport.close()

    def send(self, data: bytes) -> None:
        if self._transport is None:
            self._waiting.append(data)
        else:
            self._relay.forward(data, self._transport, None)

    def datagram_received(self, data: bytes, address: object) -> None:  # noqa: ARG002 - there is only one
        self._relay.forward(self._relay.damaged(data), self._front, self._client)
