"""Python's own refusals, in words that a person understands.

A program can get around them; the kernel holds where it can. On macOS and Windows they are all.
"""

import sys
from collections.abc import Callable
from typing import Any

from learnblock.errors import ForbiddenError

#: Audit events (PEP 578) by which a program would start another process or harm ours.
_PROCESSES = frozenset(
    {
        "os.exec",
        "os.fork",
        "os.forkpty",
        "os.kill",
        "os.killpg",
        "os.posix_spawn",
        "os.spawn",
        "os.startfile",
        "os.system",
        "pty.spawn",
        "subprocess.Popen",
    }
)
#: Those by which it would use the network.
_NETWORK = frozenset(
    {"socket.bind", "socket.connect", "socket.getaddrinfo", "socket.gethostbyname"}
)


def install(*, network: bool) -> None:
    """Refuse processes, and the network unless it is allowed, for good."""
    refused = dict.fromkeys(_PROCESSES, "run-no-processes")
    if not network:
        refused |= dict.fromkeys(_NETWORK, "run-no-network")
    sys.addaudithook(_refusing(refused))


def _refusing(refused: dict[str, str]) -> Callable[[str, tuple[Any, ...]], None]:
    def refuse(event: str, args: tuple[Any, ...]) -> None:  # noqa: ARG001 - as Python calls it
        if event in refused:
            raise ForbiddenError(refused[event], event=event)

    return refuse
