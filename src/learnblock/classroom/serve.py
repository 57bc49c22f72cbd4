"""The command `learnblock class`: a class that is open until Ctrl-C."""

import contextlib
import signal
import socket
import threading
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import Any

from starlette.applications import Starlette

from learnblock.classroom.app import create_app
from learnblock.classroom.badges import Badges, Visitors
from learnblock.classroom.certificate import CertificateFiles
from learnblock.classroom.hub_class import HubLogin, HubServers, HubService
from learnblock.classroom.messages import LessonOffer
from learnblock.classroom.room import Room
from learnblock.classroom.roster import Roster, wall_address
from learnblock.i18n import Phrase
from learnblock.project.files.writer import FolderClaim
from learnblock.server.http.address import own_address
from learnblock.server.http.connections import Connections, Listening, most_connections
from learnblock.server.http.faults import faults_said_once
from learnblock.server.http.tls_loop import TlsLoop
from learnblock.server.last_resort import Deadlines, EndingServer, LastResort
from learnblock.server.serve import collect_rarely, configured, tcp_socket

EVERYWHERE = "0.0.0.0"  # noqa: S104 - pupils come from other computers
#: Longer than the nursery and all pupils' servers take, even if each of them has to be killed.
_DEADLINES = Deadlines(ending=25.0, saving=6.0)


@dataclass(frozen=True)
class ClassService:
    """A class to open.

    Args:
        roster: the class.
        writer: the right to write to its folder; another LearnBlock asks there for its end.
        offers: the lessons that can be handed out.
        host: the address to listen on.
        port: the port; None for the default, or a free one if that is taken.
        certificate: for HTTPS; None for HTTP.
        allowed_hosts: more names of this computer.
        deadlines: how long its end may take.
        hub: the JupyterHub whose service it is; None if it is open on its own.
        announce: shows the teacher how to come in.
    """

    roster: Roster
    writer: FolderClaim
    announce: Callable[[Phrase], object]
    offers: Iterable[LessonOffer] = ()
    host: str = EVERYWHERE
    port: int | None = None
    certificate: CertificateFiles | None = None
    allowed_hosts: tuple[str, ...] = ()
    deadlines: Deadlines = _DEADLINES
    hub: HubService | None = None


def serve_class(service: ClassService, *, show: Callable[[str], object] | None = None) -> None:
    """Hold a class until Ctrl-C or SIGTERM; then save everything of every pupil.

    A class that hangs ends some seconds later, or at a second Ctrl-C; pupils' servers save first.

    Args:
        service: the class and its address.
        show: called with the address of the teacher's wall, in a thread, once it answers.

    Raises:
        LearnBlockError: the address is not free.
    """
    connections = Connections(most_connections())
    plain = tcp_socket(service.host, service.port)
    with Listening(plain, connections) as listening, faults_said_once():
        address = service.hub.address if service.hub else _address(service, listening)
        room = _room(service, address)
        # Browsers keep one badge for each port.
        cookie = f"learnblock_class_{listening.getsockname()[1]}"
        visitors = Visitors(Badges(service.roster), cookie)
        config = configured(
            _app(service, room, visitors),
            connections=connections,
            identify=visitors.person,
            **_tls(service.certificate),
        )
        title = service.roster.title

        def close() -> None:
            server.should_exit = True

        server = EndingServer(
            config,
            _last_resort(room, service, close),
            _opened(service, address, show),
            partial(_begin_to_end, room, service),
        )
        collect_rarely()
        # Uvicorn stops the server, then raises the signal again.
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        with contextlib.suppress(KeyboardInterrupt):
            server.run([listening])
        code = "class-ended" if room.is_saved else "class-ended-by-force"
        service.announce(Phrase(code, title=title))


def _room(service: ClassService, address: str) -> Room:
    servers = HubServers(service.hub, service.roster) if service.hub else None
    return Room(service.roster, address, service.offers, servers)


def _app(service: ClassService, room: Room, visitors: Visitors) -> Starlette:
    return create_app(
        room,
        visitors,
        hosts=(socket.gethostname(), *service.allowed_hosts),
        tls=service.certificate is not None,
        hub=HubLogin(service.hub) if service.hub else None,
    )


def _last_resort(room: Room, service: ClassService, close: Callable[[], None]) -> LastResort:
    """What ends the class if it hangs, and closes it when another LearnBlock asks for that."""
    return LastResort(
        partial(_hurry, room),
        service.announce,
        service.deadlines,
        is_asked=lambda: service.writer.is_asked_to_end,
        begin=close,
    )


def _begin_to_end(room: Room, service: ClassService) -> None:
    service.announce(Phrase("class-closing", title=service.roster.title))
    # Requests that wait for a server are answered before connections are closed.
    room.end()


def _hurry(room: Room) -> Iterable[Phrase]:
    """Have every pupil's server save and end at once; it reports its own errors."""
    room.hurry()
    return ()


def _opened(
    service: ClassService, address: str, show: Callable[[str], object] | None
) -> Callable[[], None]:
    roster = service.roster
    wall = wall_address(address, roster.key)

    def opened() -> None:
        service.writer.describe(address, roster.key)
        if service.hub:
            # Its output is the hub's log, where the teacher's key has no place.
            service.announce(Phrase("class-opened-at-hub", title=roster.title, address=address))
            return
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


def _tls(certificate: CertificateFiles | None) -> dict[str, Any]:
    if certificate is None:
        return {}
    return {
        "ssl_certfile": certificate.file,
        "ssl_keyfile": certificate.key,
        "loop": f"{TlsLoop.__module__}:{TlsLoop.__qualname__}",
    }


def _address(service: ClassService, listening: socket.socket) -> str:
    host, port = listening.getsockname()[:2]
    if host == EVERYWHERE:
        host = own_address() or "127.0.0.1"
    scheme = "https" if service.certificate else "http"
    return f"{scheme}://{host}:{port}"
