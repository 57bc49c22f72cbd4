"""Restrictions inside Python, with messages that a person understands.

A program can get around them, so Linux enforces the same restrictions in the kernel. On macOS and
Windows nothing else enforces them.
"""

import sys
from collections.abc import Callable
from typing import Any

from learnblock.errors import ForbiddenError

#: Audit events (PEP 578) of a program that tries to start a process, or to harm one.
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
#: Audit events of a program that tries to use the network.
_NETWORK = frozenset(
    {"socket.bind", "socket.connect", "socket.getaddrinfo", "socket.gethostbyname"}
)


def install(*, network: bool) -> None:
    """Permanently forbid starting processes, and using the network unless it is allowed."""
    refused = dict.fromkeys(_PROCESSES, "run-no-processes")
    if not network:
        refused |= dict.fromkeys(_NETWORK, "run-no-network")
    sys.addaudithook(_refusing(refused))


def _refusing(refused: dict[str, str]) -> Callable[[str, tuple[Any, ...]], None]:
    def refuse(event: str, args: tuple[Any, ...]) -> None:  # noqa: ARG001 - Python sets the parameters
        if event in refused:
            raise ForbiddenError(refused[event], event=event)

    return refuse
