"""Stops a Cozmo whose program is gone, and finds out whether there is one.

The guardian's process must be quick, so this module sends the few packets itself: loading pycozmo
and numpy would take too long.
"""

import select
import socket
import struct
from collections.abc import Callable

from learnblock.errors import RobotConnectionError
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

Address = tuple[str, int]

RETRY = 0.05
"""Seconds after which a frame is resent."""
FAREWELL = 0.3
"""Seconds to wait for the command's acknowledgement."""

_HEADER = struct.Struct("<7sBHHH")
_MAGIC = b"COZ\x03RE\x01"
_RESET, _PACKETS, _FROM_ROBOT = 0x01, 0x07, 0x09
_CONNECT = 0x02
# Packets: kind, length, content. The reset frame counts as the first packet.
_ENABLE, _STOP_ALL_MOTORS, _DISCONNECT = b"\x04\x01\0\x25", b"\x04\x01\0\x3b", b"\x03\0\0"
_STOP = _ENABLE + _ENABLE + _STOP_ALL_MOTORS
_PACKETS_IN_STOP = 3


def halt(address: str, port: int, timeout: float) -> None:
    """Connect to the robot, stop its motors and disconnect.

    Args:
        address: its host name or IP address.
        port: its UDP port.
        timeout: how long to wait for an answer, in seconds.

    Raises:
        RobotConnectionError: the robot does not respond.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as wire:
        wire.connect(resolved(address, port))
        if not _insist(wire, _frame(_RESET, 1, 1, 0), timeout, least=1, kind=_CONNECT):
            raise RobotConnectionError("cozmo-no-answer", place=f"{address}:{port}")
        stop = _frame(_PACKETS, 1, _PACKETS_IN_STOP, 1, _STOP)
        _insist(wire, stop, FAREWELL, least=_PACKETS_IN_STOP)
        goodbye = _PACKETS_IN_STOP + 1
        _send(wire, _frame(_PACKETS, goodbye, goodbye, 1, _DISCONNECT))


def responds(address: str, port: int, timeout: float) -> bool:
    """Whether a robot is there; it is greeted and left, and doesn't move.

    Args:
        address: its host name or IP address.
        port: its UDP port.
        timeout: how long to wait for an answer, in seconds.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as wire:
        try:
            wire.connect(resolved(address, port))
        except (RobotConnectionError, OSError):
            # Unknown address, or no network.
            return False
        if not _insist(wire, _frame(_RESET, 1, 1, 0), timeout, least=1, kind=_CONNECT):
            return False
        _send(wire, _frame(_PACKETS, 1, 1, 1, _DISCONNECT))
    return True


def resolved(address: str, port: int) -> Address:
    """The robot's IP address and port.

    Raises:
        RobotConnectionError: the name is unknown.
    """
    try:
        addresses = socket.getaddrinfo(address, port, socket.AF_INET, socket.SOCK_DGRAM)
    except (OSError, UnicodeError) as error:
        raise RobotConnectionError("cozmo-unknown-address", address=address) from error
    return str(addresses[0][4][0]), port


def _insist(
    wire: socket.socket, frame: bytes, timeout: float, *, least: int, kind: int | None = None
) -> bool:
    """Send a frame until it is acknowledged, and return whether it was.

    Args:
        wire: the socket to the robot.
        frame: the frame.
        timeout: how long to wait for an answer, in seconds.
        least: the number that has to be acknowledged.
        kind: the kind of the first packet in the robot's answer; None accepts any.
    """
    return insist(
        lambda: _send(wire, frame),
        lambda seconds: _acknowledged(wire, seconds, kind) >= least,
        timeout,
    )


def insist(
    send: Callable[[], object],
    hear: Callable[[float], bool],
    timeout: float,
    clock: SteadyClock = MONOTONIC,
) -> bool:
    """Send until there is an answer, and return whether there was one.

    Args:
        send: sends it; called again every `RETRY` seconds.
        hear: waits at most this many seconds for data; returns whether it is the answer.
        timeout: how long to wait for an answer, in seconds.
        clock: the clock of these limits.
    """
    until = Deadline.after(timeout, clock)
    while not until.is_over:
        send()
        again = Deadline.after(min(RETRY, until.left), clock)
        while not again.is_over:
            if hear(again.left):
                return True
    return False


def _acknowledged(wire: socket.socket, seconds: float, kind: int | None) -> int:
    """The number that the next frame of this kind acknowledges, or 0 if none arrives in time."""
    if not select.select((wire,), (), (), seconds)[0]:
        return 0
    try:
        datagram = wire.recv(65536)
    except OSError:
        # No program is listening there.
        return 0
    if len(datagram) < _HEADER.size:
        return 0
    magic, of_robot, _, _, ack = _HEADER.unpack_from(datagram)
    fits = kind is None or datagram[_HEADER.size : _HEADER.size + 1] == bytes((kind,))
    return int(ack) if magic == _MAGIC and of_robot == _FROM_ROBOT and fits else 0


def _send(wire: socket.socket, frame: bytes) -> None:
    try:
        wire.send(frame)
    except OSError:
        # No program is listening there, or the network is down: the frame is sent again later.
        return


def _frame(kind: int, first: int, last: int, ack: int, packets: bytes = b"") -> bytes:
    return _HEADER.pack(_MAGIC, kind, first, last, ack) + packets
