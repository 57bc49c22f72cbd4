"""The address by which other devices reach this computer."""

import socket
from contextlib import suppress

#: An address for documentation (RFC 5737), which is in no one's own network.
_ELSEWHERE = ("192.0.2.1", 9)


def own_address() -> str | None:
    """Return the numeric address of this computer in its network; None if it is in none.

    Nothing is sent: the system only chooses the interface for a datagram.
    """
    with suppress(OSError), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.connect(_ELSEWHERE)
        return str(probe.getsockname()[0])
    return None
