"""The connection to Cozmo: pycozmo's, without the faults that stall it when packets get lost.

In pycozmo 0.8.0

- every received frame restarts the resend timer, even the 30 status reports per second, so
  nothing is ever resent;
- a batch that does not fit into one frame is split with a wrong last number in the first frame;
- the latest frame is acknowledged even if an earlier one is missing, and frames without a number
  clear the pending acknowledgement;
- the connection is requested only once, and a goodbye may be left out.
"""

import select
import socket
import threading
from collections.abc import Iterator, Sequence
from queue import Empty
from typing import Any

from pycozmo import protocol_encoder as packets
from pycozmo.conn import Connection, ReceiveThread, SendThread
from pycozmo.frame import Frame
from pycozmo.protocol_declaration import MAX_FRAME_PAYLOAD_SIZE, MAX_SEQ, OOB_SEQ

from learnblock.robots.cozmo.halt import Address
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

RESEND = 0.05
"""Seconds after which unacknowledged packets are resent (Anki's ReliableConnection)."""
RETRY = 0.3
"""Seconds after which the connection is requested again."""
GLANCE = 0.005
"""Seconds between two checks whether everything has arrived."""
POLL = 0.02
"""Seconds after which a thread checks whether it should end."""
FAREWELL = 0.3
"""Seconds that a goodbye waits for earlier commands to arrive."""


class Sender(SendThread):  # type: ignore[misc] # pycozmo has no types
    """Sends packets repeatedly until the robot acknowledges them."""

    def __init__(self, sock: socket.socket, address: Address, clock: SteadyClock) -> None:
        super().__init__(sock, address)
        self._clock = clock

    def run(self) -> None:
        while not self.stop_flag:
            self._send_packets(self.overdue() + self._collect_messages(), self.last_ack)

    def ack(self, seq: int, last_ack: int) -> None:
        """Record that the robot has received up to `seq`, and we have received up to `last_ack`."""
        with self.lock:
            oldest = self.window.expected_seq
            self.window.acknowledge(seq)
            if self.window.expected_seq != oldest:
                self.last_ack_time = self._clock.now()
            self.last_ack = last_ack

    def reset(self) -> None:
        super().reset()
        # Nothing has been received yet.
        self.last_ack = OOB_SEQ

    def has_delivered(self) -> bool:
        """Whether every packet has been sent and acknowledged."""
        with self.lock:
            return self.queue.empty() and not self.window.get()

    def say_goodbye(self) -> None:
        """Send the disconnect packet once; sending it again may restart the robot."""
        if not self.window.is_full():
            self._send_packets(self._numbered([packets.Disconnect()]), self.last_ack)

    def overdue(self) -> list[tuple[int, Any]]:
        """The numbered packets that are due to be resent; their timer restarts."""
        with self.lock:
            owed: list[tuple[int, Any]] = self.window.get()
            if not owed or self._clock.now() < self.last_ack_time + RESEND:
                return []
            self.last_ack_time = self._clock.now()
        return owed

    def _collect_messages(self) -> list[tuple[int, Any]]:
        with self.lock:
            free = self.window.size - len(self.window.get())
        if not free:
            # The robot has to acknowledge some packets first.
            self._clock.sleep(self.COLLECT_INTERVAL)
            return []
        return self._numbered(list(self._waiting(free)))

    def _waiting(self, most: int) -> Iterator[Any]:
        """Packets from the queue, after a short wait for the first."""
        try:
            yield self.queue.get(timeout=self.COLLECT_INTERVAL)
            for _ in range(most - 1):
                yield self.queue.get_nowait()
        except Empty:
            return

    def _numbered(self, collected: Sequence[Any]) -> list[tuple[int, Any]]:
        for ping in (packet for packet in collected if isinstance(packet, packets.Ping)):
            self._send_ping(ping)
        with self.lock:
            if not self.window.get():
                self.last_ack_time = self._clock.now()
            return [
                (self.window.put(packet), packet)
                for packet in collected
                if not isinstance(packet, packets.Ping)
            ]

    def _send_packets(self, pkts: Sequence[tuple[int, Any]], last_ack: int) -> None:
        for batch in batches(pkts):
            contents = [packet for _, packet in batch]
            self._send_frame(contents, batch[0][0], batch[-1][0], last_ack)


class Receiver(ReceiveThread):  # type: ignore[misc] # pycozmo has no types
    """Receives frames, and acknowledges only those that arrived in order."""

    def __init__(self, clock: SteadyClock, *args: Any) -> None:
        super().__init__(*args)
        self._clock = clock
        #: When the last frame was received.
        self.heard = clock.now()

    def run(self) -> None:
        while not self.stop_flag:
            if select.select((self.sock,), (), (), POLL)[0]:
                self._receive()

    def handle_frame(self, frame: Any) -> None:
        self.received_frames += 1
        self.heard = self._clock.now()
        for packet in frame.pkts:
            self.handle_pkt(packet)
        self.deliver_sequence()
        self.send_thread.ack(frame.ack, (self.window.expected_seq - 1) % MAX_SEQ)

    def _receive(self) -> None:
        try:
            datagram, address = self.sock.recvfrom(65536)
        except OSError:
            # No program is listening there, which some systems report as an error.
            return
        frame = decoded(datagram)
        if frame is None or address != self.sender_address:
            self.discarded_frames += 1
        else:
            self.handle_frame(frame)


class CozmoLink(Connection):  # type: ignore[misc] # pycozmo has no types
    """A connection to a robot, from `start` to `hang_up`.

    Args:
        address: the robot's IP address and UDP port.
        clock: the clock of its limits.
    """

    def __init__(self, address: Address, clock: SteadyClock = MONOTONIC) -> None:
        super().__init__(address)
        self._clock = clock
        self.send_thread = Sender(self.sock, address, clock)
        self.recv_thread = Receiver(clock, self.sock, self.send_thread, address, self._on_packet)
        self._welcomed = threading.Event()
        #: Seconds from the newest answered ping to its answer; None before the first one.
        self.round_trip: float | None = None

    @property
    def is_open(self) -> bool:
        """Whether the robot has accepted the connection."""
        return bool(self.state == self.CONNECTED)

    @property
    def silence(self) -> float:
        """Seconds since the last frame from the robot."""
        return self._clock.now() - float(self.recv_thread.heard)

    def establish(self, timeout: float) -> bool:
        """Request the connection until the robot accepts it or `timeout` seconds have passed."""
        began = requested = self._clock.now()
        until = Deadline(self._clock, began + timeout)
        while not self._welcomed.is_set():
            if until.is_over:
                return False
            requested = self._clock.now()
            self.connect()
            self._clock.wait(self._welcomed, min(RETRY, until.left))
        # The robot restarts the connection at each request. Nothing else may be sent before it has
        # received the last one, which takes at most as long as its first answer took.
        self._clock.sleep(requested - began)
        return True

    def hang_up(self) -> None:
        """Deliver pending packets, disconnect and end all threads; in 0.5 s at most."""
        if self.is_open:
            self._deliver_all()
        self.send_thread.stop()
        if self.is_open:
            self.send_thread.say_goodbye()
        self.stop()

    def _on_connect(self, cli: Any, pkt: Any) -> None:
        super()._on_connect(cli, pkt)
        self._welcomed.set()

    def _send_ping(self) -> None:
        self.send(packets.Ping(self._clock.now(), self.ping_counter, 0))
        self.ping_counter += 1

    def _on_ping(self, cli: Any, pkt: Any) -> None:  # noqa: ARG002 - as pycozmo calls it
        # The robot returns the time at which the ping was sent.
        self.round_trip = max(0.0, self._clock.now() - pkt.time_sent_ms)

    def _deliver_all(self) -> None:
        until = Deadline.after(FAREWELL, self._clock)
        while not self.send_thread.has_delivered() and not until.is_over:
            self._clock.sleep(min(GLANCE, until.left))


def batches(numbered: Sequence[tuple[int, Any]]) -> Iterator[list[tuple[int, Any]]]:
    """Packets grouped into as few frames as possible."""
    batch: list[tuple[int, Any]] = []
    size = 0
    for number, packet in numbered:
        length = 4 + len(packet)
        if batch and size + length > MAX_FRAME_PAYLOAD_SIZE:
            yield batch
            batch, size = [], 0
        batch.append((number, packet))
        size += length
    if batch:
        yield batch


def decoded(datagram: bytes) -> Any:
    """The frame in a datagram, or None if it is invalid."""
    try:
        return Frame.from_bytes(datagram)
    except Exception:  # noqa: BLE001 - pycozmo raises any error of its slices and asserts
        return None
