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
import threading
from collections.abc import Iterator, Sequence
from queue import Empty
from time import monotonic, perf_counter
from typing import Any

from pycozmo import protocol_encoder as packets
from pycozmo.conn import Connection, ReceiveThread, SendThread
from pycozmo.frame import Frame
from pycozmo.protocol_declaration import MAX_FRAME_PAYLOAD_SIZE, MAX_SEQ, OOB_SEQ

from learnblock.robots.cozmo.halt import Address

RESEND = 0.05
"""Seconds after which unacknowledged packets are resent (Anki's ReliableConnection)."""
RETRY = 0.3
"""Seconds after which the connection is requested again."""
POLL = 0.02
"""Seconds after which a thread checks whether it should end."""
FAREWELL = 0.3
"""Seconds that a goodbye waits for earlier commands to arrive."""


class Sender(SendThread):  # type: ignore[misc] # pycozmo has no types
    """Sends packets repeatedly until the robot acknowledges them."""

    def run(self) -> None:
        while not self.stop_flag:
            self._send_packets(self._resend_messages() + self._collect_messages(), self.last_ack)

    def ack(self, seq: int, last_ack: int) -> None:
        """Record that the robot has received up to `seq`, and we have received up to `last_ack`."""
        with self.lock:
            oldest = self.window.expected_seq
            self.window.acknowledge(seq)
            if self.window.expected_seq != oldest:
                self.last_ack_time = monotonic()
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

    def _resend_messages(self) -> list[tuple[int, Any]]:
        with self.lock:
            owed: list[tuple[int, Any]] = self.window.get()
            if not owed or monotonic() - self.last_ack_time < RESEND:
                return []
            self.last_ack_time = monotonic()
        return owed

    def _collect_messages(self) -> list[tuple[int, Any]]:
        with self.lock:
            free = self.window.size - len(self.window.get())
        if not free:
            # The robot has to acknowledge some packets first.
            threading.Event().wait(self.COLLECT_INTERVAL)
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
                self.last_ack_time = monotonic()
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

    def __init__(self, *args: Any) -> None:
        super().__init__(*args)
        #: When the last frame was received.
        self.heard = monotonic()

    def run(self) -> None:
        while not self.stop_flag:
            if select.select((self.sock,), (), (), POLL)[0]:
                self._receive()

    def handle_frame(self, frame: Any) -> None:
        self.received_frames += 1
        self.heard = monotonic()
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


class Link(Connection):  # type: ignore[misc] # pycozmo has no types
    """A connection to a robot, from `start` to `hang_up`.

    Args:
        address: the robot's IP address and UDP port.
    """

    def __init__(self, address: Address) -> None:
        super().__init__(address)
        self.send_thread = Sender(self.sock, address)
        self.recv_thread = Receiver(self.sock, self.send_thread, address, self._on_packet)
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
        return monotonic() - float(self.recv_thread.heard)

    def establish(self, timeout: float) -> bool:
        """Request the connection until the robot accepts it or `timeout` seconds have passed."""
        began = asked = monotonic()
        while not self._welcomed.is_set():
            asked = monotonic()
            if asked - began > timeout:
                return False
            self.connect()
            self._welcomed.wait(min(RETRY, timeout))
        # The robot restarts the connection at each request. Nothing else may be sent before it has
        # received the last one, which takes at most as long as its first answer took.
        threading.Event().wait(asked - began)
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

    def _on_ping(self, cli: Any, pkt: Any) -> None:  # noqa: ARG002 - as pycozmo calls it
        # The robot returns the time at which the ping was sent.
        self.round_trip = max(0.0, perf_counter() - pkt.time_sent_ms)

    def _deliver_all(self) -> None:
        until = monotonic() + FAREWELL
        while not self.send_thread.has_delivered() and monotonic() < until:
            threading.Event().wait(0.005)


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
