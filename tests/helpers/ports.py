"""Ports of this computer at which nothing answers."""

import socket
from contextlib import ExitStack, contextmanager


def free_port():
    """Return a port at which nothing listens."""
    (port,) = free_ports(1)
    return port


def free_ports(count):
    """Return different ports at which nothing listens."""
    with ExitStack() as stack:
        sockets = [
            stack.enter_context(socket.create_server(("127.0.0.1", 0))) for _ in range(count)
        ]
        return [listener.getsockname()[1] for listener in sockets]


@contextmanager
def mute_server():
    """Accept connections and send nothing; yield the port."""
    # The system accepts them: nothing has to run here.
    with socket.create_server(("127.0.0.1", 0)) as listener:
        yield listener.getsockname()[1]
