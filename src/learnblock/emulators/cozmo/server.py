"""The robot's side of Cozmo's transport: connections, acknowledgements and repeated packets."""

import select
import socket
import threading
from collections import deque
from collections.abc import Iterable
from time import monotonic
from typing import Any, Protocol

from pycozmo import protocol_encoder as packets

from learnblock.emulators.cozmo.frames import (
    MOST_PAYLOAD,
    Datagram,
    DatagramError,
    FrameKind,
    decoded,
    encoded,
    following,
)

RESEND = 0.05
"""Seconds until packets without acknowledgement are repeated (Anki's ReliableConnection)."""
SILENCE = 5.0
"""Seconds without a frame until the robot closes the connection (docs/protocol.md)."""

_RESET_NUMBER = 1
"""The reset frame counts as the first packet."""


class Robot(Protocol):
    """The robot behind the transport."""

    def greet(self) -> Iterable[Any]:
        """The packets for a new client."""

    def handle(self, packet: Any) -> Iterable[Any]:
        """Execute a packet, and return the packets of the answer."""

    def tick(self) -> Iterable[Any]:
        """The packets of the next report."""

    def rest(self) -> None:
        """Stop the motors, because no client is connected."""


class _Session:
    """The connection of one client, from its reset to its goodbye."""

    def __init__(self, address: Any, now: float) -> None:
        self.address = address
        self.heard = now
        self.arrived = _RESET_NUMBER
        self._next = _RESET_NUMBER
        self._owed: deque[tuple[int, Any]] = deque()
        self._sent = now

    def number(self, packet: Any) -> int:
        """Keep a packet until it is acknowledged; return its number, or 0 if it needs none."""
        if packet.is_oob():
            return 0
        number, self._next = self._next, following(self._next)
        self._owed.append((number, packet))
        return number

    def acknowledge(self, number: int) -> None:
        """Forget the packets up to `number`, which the client has received."""
        if any(number == owed for owed, _ in self._owed):
            while self._owed and self._owed.popleft()[0] != number:
                continue

    def accepts(self, number: int) -> bool:
        """Whether a packet is the next one; packets out of order are dropped and sent again."""
        if number == 0:
            return True
        if number != following(self.arrived):
            return False
        self.arrived = number
        return True

    def overdue(self, now: float) -> list[tuple[int, Any]]:
        """The packets to send again."""
        if not self._owed or now - self._sent < RESEND:
            return []
        self._sent = now
        return list(self._owed)


class Server:
    """Serve one client at a time in a thread, until `close`.

    A client that resets the link takes it over, as in the robot's protocol.

    Args:
        robot: the robot behind the transport.
        address: the address to listen at.
        port: the UDP port; 0 takes a free one.
        period: the seconds between two reports of the robot.

    Raises:
        OSError: it cannot listen there.
    """

    def __init__(self, robot: Robot, address: str, port: int, period: float) -> None:
        self._robot = robot
        self._period = period
        self._session: _Session | None = None
        self._closed = threading.Event()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            self._socket.bind((address, port))
        except OSError:
            self._socket.close()
            raise
        self._socket.setblocking(False)  # noqa: FBT003 - of the standard library
        self.port: int = self._socket.getsockname()[1]
        self._thread = threading.Thread(target=self._live, name="cozmo-emulator", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """End the thread; calling it twice is harmless."""
        self._closed.set()
        self._thread.join()
        self._socket.close()

    def _live(self) -> None:
        due = monotonic()
        while not self._closed.is_set():
            self._receive_all(max(0.0, due - monotonic()))
            if (now := monotonic()) >= due:
                # After a delay, missed reports are skipped.
                due = max(due + self._period, now)
                self._tick(now)
        self._leave()

    def _receive_all(self, wait: float) -> None:
        """Handle all that has arrived, so that slow reports do not delay commands ever more."""
        while select.select((self._socket,), (), (), wait)[0]:
            self._receive()
            wait = 0.0

    def _receive(self) -> None:
        try:
            datagram, address = self._socket.recvfrom(65536)
            frame = decoded(datagram)
        except (OSError, DatagramError):
            # The client is gone, or sent invalid data; a real robot does not answer either.
            return
        if frame.kind is FrameKind.RESET:
            self._connect(address)
        elif self._session and self._session.address == address:
            self._hear(self._session, frame)

    def _connect(self, address: Any) -> None:
        self._leave()
        self._session = _Session(address, monotonic())
        self._send(self._session, (packets.Connect(), *self._robot.greet()))

    def _hear(self, session: _Session, frame: Datagram) -> None:
        session.heard = monotonic()
        session.acknowledge(frame.ack)
        answers: list[Any] = []
        for number, packet in frame.packets:
            if session.accepts(number) and packet is not None:
                answers += self._answer(packet)
        if frame.kind is FrameKind.GOODBYE or any(
            isinstance(packet, packets.Disconnect) for _, packet in frame.packets
        ):
            self._leave()
        elif answers:
            self._send(session, answers)

    def _answer(self, packet: Any) -> Iterable[Any]:
        return (packet,) if isinstance(packet, packets.Ping) else self._robot.handle(packet)

    def _tick(self, now: float) -> None:
        session = self._session
        if session is None:
            return
        if now - session.heard > SILENCE:
            self._leave()
            return
        self._emit(session, session.overdue(now))
        # Separate frames, so that each packet can get lost alone.
        for packet in self._robot.tick():
            self._send(session, (packet,))

    def _leave(self) -> None:
        self._session = None
        self._robot.rest()

    def _send(self, session: _Session, contents: Iterable[Any]) -> None:
        self._emit(session, [(session.number(packet), packet) for packet in contents])

    def _emit(self, session: _Session, numbered: list[tuple[int, Any]]) -> None:
        """Send packets in as few frames as possible."""
        batch: list[tuple[int, Any]] = []
        size = 0
        for number, packet in numbered:
            length = 4 + len(packet)
            if batch and size + length > MOST_PAYLOAD:
                self._emit_frame(session, batch)
                batch, size = [], 0
            batch.append((number, packet))
            size += length
        if batch:
            self._emit_frame(session, batch)

    def _emit_frame(self, session: _Session, batch: list[tuple[int, Any]]) -> None:
        first = next((number for number, _ in batch if number), 0)
        datagram = encoded(session.arrived, first, [packet for _, packet in batch])
        try:
            self._socket.sendto(datagram, session.address)
        except OSError:
            # The client's socket is gone, or its queue is full; the frame counts as lost.
            return
