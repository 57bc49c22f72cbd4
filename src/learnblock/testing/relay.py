"""A wire that can be made to fail: it stands between a client and its robot in tests."""

import asyncio
import random
import socket
import threading
from enum import Enum, auto
from typing import Any, Self

from learnblock.closing import Closing

_CHUNK = 65536


class Fault(Enum):
    """What is wrong with a wire."""

    NONE = auto()
    #: Nothing passes, and nobody is told: no answer, or a link that is open at one end only.
    SILENT = auto()
    #: What the robot sends arrives as nonsense.
    GARBAGE = auto()
    #: Everything passes `Relay.delay` seconds late.
    SLOW = auto()
    #: Connections are closed, and new ones refused.
    CUT = auto()


class Relay(Closing):
    """Passes on what client and robot say, over TCP or UDP, as well as its fault allows.

        with Relay(("127.0.0.1", port)) as relay:
            robot = connect("rcis", base_port=relay.port)
            relay.fault = Fault.SILENT

    Args:
        target: where the robot listens.
        udp: whether it speaks UDP instead of TCP.
        seed: of what is lost, and of nonsense.

    Attributes:
        port: where it listens itself, on 127.0.0.1.
        delay: seconds, for a slow wire.
        loss: the share of datagrams that get lost, 0 to 1.
        passed: bytes passed on so far, both ways.
        lost: datagrams lost so far, both ways.
    """

    def __init__(self, target: tuple[str, int], *, udp: bool = False, seed: int = 0) -> None:
        self.target = target
        self.delay = 0.3
        self.loss = 0.0
        self.passed = 0
        self.lost = 0
        self._fault = Fault.NONE
        self._random = random.Random(seed)  # noqa: S311 - nothing secret is drawn
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
        """What is wrong with the wire; it can be set at any time, from any thread."""
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
        # Nothing passes any more, and each of them ends by itself.
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
            # Nobody is at home: the client sees its connection end.
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
                    # Counted first: who has received it may ask at once.
                    self.passed += len(data)
                    sink.write(self._damaged(data) if back else data)
                    await sink.drain()
        except OSError:
            # One end broke the connection: so does the relay.
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
        """Pass a datagram on, if it is not lost; `sink` sends it."""
        if self._fault in {Fault.SILENT, Fault.CUT} or self._random.random() < self.loss:
            self.lost += 1
            return
        self.passed += len(data)
        wait = self.delay if self._fault is Fault.SLOW else 0.0
        self._loop.call_later(wait, lambda: sink.sendto(data, address))

    def damaged(self, data: bytes) -> bytes:
        """As the client receives it."""
        return self._damaged(data)


class _Front(asyncio.DatagramProtocol):
    """The end of the clients; each client gets a socket of its own towards the robot."""

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
    """The end of the robot, for one client."""

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

    def datagram_received(self, data: bytes, address: object) -> None:  # noqa: ARG002 - one alone
        self._relay.forward(self._relay.damaged(data), self._front, self._client)
