"""The command `learnblock class`: a class that is open until Ctrl-C."""

import contextlib
import signal
import socket
import threading
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import uvicorn

from learnblock.classroom.app import create_app
from learnblock.classroom.badges import Badges, Visitors
from learnblock.classroom.certificate import Certificate
from learnblock.classroom.room import Room
from learnblock.classroom.roster import Roster
from learnblock.i18n import Phrase
from learnblock.server.http.address import own_address
from learnblock.server.http.connections import Connections, Listening, most_connections
from learnblock.server.http.event_loop import EventLoop
from learnblock.server.http.faults import faults_said_once
from learnblock.server.messages.lessons import LessonText
from learnblock.server.serve import collect_rarely, configured, tcp_socket

EVERYWHERE = "0.0.0.0"  # noqa: S104 - pupils come from other computers


@dataclass(frozen=True)
class ClassService:
    """A class to open.

    Args:
        roster: the class.
        lessons: those that can be handed out: name and title.
        host: the address to listen on.
        port: the port; None for the default, or a free one if that is taken.
        certificate: for HTTPS; None for HTTP.
        allowed_hosts: more names of this computer.
        announce: shows the teacher how to come in.
    """

    roster: Roster
    announce: Callable[[Phrase], object]
    lessons: Iterable[tuple[str, LessonText]] = ()
    host: str = EVERYWHERE
    port: int | None = None
    certificate: Certificate | None = None
    allowed_hosts: tuple[str, ...] = ()


def serve_class(service: ClassService, *, show: Callable[[str], object] | None = None) -> None:
    """Hold a class until Ctrl-C or SIGTERM; then save everything of every pupil.

    Args:
        service: the class and its address.
        show: called with the address of the teacher's wall, in a thread, once it answers.

    Raises:
        LearnBlockError: the address is not free.
    """
    connections = Connections(most_connections())
    plain = tcp_socket(service.host, service.port)
    with Listening(plain, connections) as listening, faults_said_once():
        address = _address(service, listening)
        room = Room(service.roster, address, service.lessons)
        # Browsers keep one badge for each port.
        cookie = f"learnblock_class_{listening.getsockname()[1]}"
        visitors = Visitors(Badges(service.roster), cookie)
        app = create_app(
            room,
            visitors,
            hosts=(socket.gethostname(), *service.allowed_hosts),
            tls=service.certificate is not None,
        )
        config = configured(
            app,
            connections=connections,
            identify=visitors.person,
            **_tls(service.certificate),
        )
        server = _Server(config, _opened(service, address, show))
        collect_rarely()
        # Uvicorn stops the server, then raises the signal again.
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        with contextlib.suppress(KeyboardInterrupt):
            server.run([listening])


class _Server(uvicorn.Server):
    """A server that reports when it is ready."""

    def __init__(self, config: uvicorn.Config, answers: Callable[[], object]) -> None:
        super().__init__(config)
        self._answers = answers

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._answers()


def _opened(
    service: ClassService, address: str, show: Callable[[str], object] | None
) -> Callable[[], None]:
    roster = service.roster
    wall = f"{address}/teacher?key={roster.key}"

    def opened() -> None:
        service.announce(
            Phrase(
                "class-opened",
                title=roster.title,
                address=address,
                word=roster.word,
                wall=wall,
                projector=f"{address}/projector",
            )
        )
        if show:
            threading.Thread(target=show, args=(wall,), daemon=True).start()

    return opened


def _tls(certificate: Certificate | None) -> dict[str, Any]:
    if certificate is None:
        return {}
    return {
        "ssl_certfile": certificate.file,
        "ssl_keyfile": certificate.key,
        "loop": f"{EventLoop.__module__}:{EventLoop.__qualname__}",
    }


def _address(service: ClassService, listening: socket.socket) -> str:
    host, port = listening.getsockname()[:2]
    if host == EVERYWHERE:
        host = own_address() or "127.0.0.1"
    scheme = "https" if service.certificate else "http"
    return f"{scheme}://{host}:{port}"
