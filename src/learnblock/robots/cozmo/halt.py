"""Stops a Cozmo whose program is gone.

It waits for its moment in a process of its own, and is then to be quick: so it speaks the few words
that it needs by itself, without pycozmo and numpy, which take longer to load than it has.
"""

import select
import socket
import struct
from time import monotonic

from learnblock.errors import RobotConnectionError

Address = tuple[str, int]

RETRY = 0.05
"""Seconds after which a frame is sent again."""
FAREWELL = 0.3
"""Seconds within which the command must have been acknowledged."""

_HEADER = struct.Struct("<7sBHHH")
_MAGIC = b"COZ\x03RE\x01"
_RESET, _PACKETS, _FROM_ROBOT = 0x01, 0x07, 0x09
_CONNECT = 0x02
# Packets: their kind, their length, their contents. The first counts as the frame that reset.
_ENABLE, _STOP_ALL_MOTORS, _DISCONNECT = b"\x04\x01\0\x25", b"\x04\x01\0\x3b", b"\x03\0\0"
_STOP = _ENABLE + _ENABLE + _STOP_ALL_MOTORS
_PACKETS_IN_STOP = 3


def halt(address: str, port: int, patience: float) -> None:
    """Take the robot over, stop its motors and let go of it.

    Args:
        address: a name or number in the network.
        port: of UDP.
        patience: seconds within which it must have answered.

    Raises:
        RobotConnectionError: it does not answer.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as wire:
        wire.connect(resolved(address, port))
        if not _insist(wire, _frame(_RESET, 1, 1, 0), patience, least=1, kind=_CONNECT):
            raise unanswered(named(address, port), patience)
        stop = _frame(_PACKETS, 1, _PACKETS_IN_STOP, 1, _STOP)
        _insist(wire, stop, FAREWELL, least=_PACKETS_IN_STOP)
        goodbye = _PACKETS_IN_STOP + 1
        _send(wire, _frame(_PACKETS, goodbye, goodbye, 1, _DISCONNECT))


def named(address: str, port: int) -> str:
    """The robot, as sentences call it."""
    return f"Cozmo at {address}:{port}"


def unanswered(name: str, patience: float) -> RobotConnectionError:
    """What is told about a robot that does not answer."""
    return RobotConnectionError(
        f"no answer from {name} within {patience:g} s: is it switched on, is this machine in its"
        " network (Cozmo_...), and are address and port right?"
    )


def resolved(address: str, port: int) -> Address:
    """The robot's number in the network.

    Raises:
        RobotConnectionError: the network knows no such name.
    """
    try:
        found = socket.getaddrinfo(address, port, socket.AF_INET, socket.SOCK_DGRAM)
    except (OSError, UnicodeError) as error:
        raise RobotConnectionError(
            f"Cozmo cannot be reached: the network knows no address `{address}` ({error})"
        ) from error
    return str(found[0][4][0]), port


def _insist(
    wire: socket.socket, frame: bytes, patience: float, *, least: int, kind: int | None = None
) -> bool:
    """Send a frame until it is acknowledged; say whether it was.

    Args:
        wire: to the robot.
        frame: what is sent.
        patience: seconds for which it is tried.
        least: the number that has to be acknowledged.
        kind: of the first packet in the robot's answer; any if it is None.
    """
    until = monotonic() + patience
    while monotonic() < until:
        _send(wire, frame)
        again = monotonic() + RETRY
        while (left := again - monotonic()) > 0:
            if _acknowledged(wire, left, kind) >= least:
                return True
    return False


def _acknowledged(wire: socket.socket, seconds: float, kind: int | None) -> int:
    """What the next frame acknowledges, or 0 if none of the kind comes within these seconds."""
    if not select.select((wire,), (), (), seconds)[0]:
        return 0
    try:
        datagram = wire.recv(65536)
    except OSError:
        # Nobody listens there.
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
        # Nobody listens there, or the network is gone: it is tried again.
        return


def _frame(kind: int, first: int, last: int, ack: int, packets: bytes = b"") -> bytes:
    return _HEADER.pack(_MAGIC, kind, first, last, ack) + packets
