"""The command `learnblock`: the server, with the page in a browser or in a window."""

import contextlib
import gc
import signal
import socket
import threading
import webbrowser
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any
from urllib.parse import quote

import click
import uvicorn
from starlette.requests import HTTPConnection

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.installation import add_on
from learnblock.project.files.share_link import KEY
from learnblock.project.files.writer import Access
from learnblock.server.app import create_app
from learnblock.server.catalog.classes import ClassShelf
from learnblock.server.http.address import token as the_token
from learnblock.server.http.connections import Connections, Listening, most_connections
from learnblock.server.http.faults import faults_said_once
from learnblock.server.http.protection import Protection, is_loopback, offered_token
from learnblock.server.http.requests import Headers, Identify, TimedRequests
from learnblock.server.last_resort import Deadlines, EndingServer, LastResort
from learnblock.server.runs.memory import share_one_heap

DEFAULT_HOST = "127.0.0.1"
DEFAULT_PORT = 8421
#: Addresses that mean all network interfaces.
_EVERYWHERE = {"0.0.0.0", "::"}  # noqa: S104 - only if the user chooses it
#: Seconds that open pages have to disconnect when the server stops.
_FAREWELL = 1
#: Seconds between two checks whether a server has failed to start.
_LOOK_AGAIN = 0.5
#: The connections that the system keeps until they are accepted.
_BACKLOG = 128
#: Drivers wait for their robots with `select`, which knows 1,024 descriptors only.
_MOST_CONNECTIONS = 500
#: Bytes; twice the limit of a message, so that the page receives an error and stays connected.
_LONGEST_FRAME = 8 * 1024 * 1024


@dataclass(frozen=True)
class Service:
    """The projects to serve, and the server's address.

    Args:
        folder: the projects folder.
        host: the address to listen on.
        port: the port; None for the default, or a free one if that is taken.
        unix_socket: a socket to listen on instead.
        base_url: the path of the page.
        allowed_hosts: names that a proxy uses for the server.
        proxy_sends_token: whether a proxy sends the token for users that it has logged in.
        project: the project to open.
        link: the link of a project to open instead, without an address.
        new_token: whether the address gets a new token, with which only new pages open.
        access: the right to write to the folder.
        for_one: whether all pages belong to one person, on any device.
        deadlines: how long its end may take.
        announce: shows the user the page's address.
        classes: gives the teacher's classes; None if there can't be any.
    """

    folder: Path
    host: str = DEFAULT_HOST
    port: int | None = None
    unix_socket: Path | None = None
    base_url: str = "/"
    allowed_hosts: tuple[str, ...] = ()
    proxy_sends_token: bool = False
    project: str | None = None
    link: str | None = None
    new_token: bool = False
    access: Access = field(default_factory=Access)
    for_one: bool = False
    deadlines: Deadlines = field(default_factory=Deadlines)
    announce: Callable[[Phrase], object] = click.echo
    classes: Callable[[], ClassShelf] | None = None

    @property
    def hosts(self) -> tuple[str, ...]:
        """The allowed names of the server."""
        own = "*" if self.host in _EVERYWHERE else self.host
        return (own, socket.gethostname(), *self.allowed_hosts)

    @property
    def is_for_one(self) -> bool:
        """Whether all pages belong to one person: a hub starts a LearnBlock for each user."""
        return self.for_one or self.proxy_sends_token

    @property
    def is_for_others(self) -> bool:
        """Whether other computers can connect, directly or through a proxy."""
        return self._is_behind_proxy or not is_loopback(self.host)

    @property
    def is_reached_directly(self) -> bool:
        """Whether other computers connect directly: a proxy's connections serve all its users."""
        return self.is_for_others and not self._is_behind_proxy

    @property
    def _is_behind_proxy(self) -> bool:
        return bool(self.unix_socket or self.allowed_hosts or self.proxy_sends_token)


def serve(service: Service, *, show: Callable[[str], object] | None = None) -> None:
    """Serve until Ctrl-C or SIGTERM; then stop every program, and save every project.

    A server that hangs saves everything and ends some seconds later, or at a second Ctrl-C.

    Args:
        service: the projects and the address.
        show: called with the page's address, in a thread, once the server answers.

    Raises:
        LearnBlockError: the address is not free, or the token in the environment is invalid.
    """
    with _server(service, show) as (server, listening), contextlib.suppress(KeyboardInterrupt):
        # Both are normal ways to stop. Uvicorn stops the server, then raises the signal again.
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        server.run([listening])


def show_in_browser(address: str) -> None:
    """Open the page in the user's browser, if there is one; the address is also printed."""
    with contextlib.suppress(webbrowser.Error):
        webbrowser.open(address)


def serve_in_window(service: Service) -> None:
    """Serve while a separate window shows the page.

    Raises:
        LearnBlockError: pywebview is not installed, or see `serve`.
    """
    webview = _webview()
    started = threading.Event()
    address = []

    def show(shown: str) -> None:
        address.append(shown)
        started.set()

    with _server(service, show) as (server, listening):
        # A window needs the main thread on every system.
        serving = threading.Thread(target=server.run, args=([listening],), name="server")
        serving.start()
        while not started.wait(_LOOK_AGAIN) and serving.is_alive():
            pass
        if address:
            _show_window(webview, address[0])
        server.end()
        # Its last resort ends this process if that hangs.
        serving.join()


def show_in_window(address: str) -> None:
    """Show a page in a separate window until it is closed.

    Raises:
        LearnBlockError: pywebview is not installed.
    """
    _show_window(_webview(), address)


def _webview() -> Any:
    try:
        return import_module("webview")
    except ImportError as error:
        raise LearnBlockError("server-no-window", command=add_on("window")) from error


def _show_window(webview: Any, address: str) -> None:
    webview.create_window("LearnBlock", address)
    webview.start()


class _Server(EndingServer):
    """A server that stops when another one wants to take over.

    Args:
        config: its configuration.
        service: the projects, and the address.
        answers: called when it answers.
        save: saves everything, see `LastResort`.
    """

    def __init__(
        self,
        config: uvicorn.Config,
        service: Service,
        answers: Callable[[], None],
        save: Callable[[], Iterable[Phrase]],
    ) -> None:
        self._service = service
        last_resort = LastResort(
            save,
            service.announce,
            service.deadlines,
            is_asked=self._is_taken_over,
            begin=self._make_room,
        )
        super().__init__(config, last_resort, answers)

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        await super().shutdown(sockets)
        # Everything is saved now. A window may stay open, but another server need not wait for it.
        if self._service.access.writer:
            self._service.access.writer.release()

    def _is_taken_over(self) -> bool:
        # The other server may be another user's, so a file is the only way to send it a request.
        writer = self._service.access.writer
        return writer is not None and writer.is_asked_to_end

    def _make_room(self) -> None:
        self._service.announce(Phrase("server-taken-over"))
        self.should_exit = True


@contextmanager
def _server(
    service: Service, show: Callable[[str], object] | None
) -> Iterator[tuple[_Server, socket.socket]]:
    share_one_heap()
    token = the_token(new=service.new_token)
    app = create_app(
        service.folder,
        token=token,
        hosts=service.hosts,
        origins=service.allowed_hosts,
        proxy_sends_token=service.proxy_sends_token,
        base_url=service.base_url,
        read_only=service.access.read_only,
        for_others=service.is_for_others,
        for_one=service.is_for_one,
        classes=service.classes,
    )
    connections = Connections(min(most_connections(), _MOST_CONNECTIONS))
    with _listening(service) as plain, faults_said_once():
        counts = service.is_reached_directly
        listening = Listening(plain, connections) if counts else plain

        def answers() -> None:
            address = _page_address(service, listening)
            if service.access.writer:
                service.access.writer.describe(address, token)
            shown_token = None if service.proxy_sends_token else token
            address = whole_address(address, shown_token, service.project, service.link)
            service.announce(Phrase("server-started", address=address))
            if service.access.read_only:
                service.announce(service.access.read_only)
            if service.is_for_others:
                threading.Thread(target=_warn, args=(service,), name="survey").start()
            if show:
                threading.Thread(target=show, args=(address,), daemon=True).start()

        collect_rarely()
        identify = partial(_person, Protection.of(token))
        config = configured(app, connections=connections if counts else None, identify=identify)
        save = partial(app.state.save, service.deadlines.saving)
        yield _Server(config, service, answers, save), listening


def _person(protection: Protection, headers: Headers) -> str:
    """Who sends these headers: everyone with the token counts as one person; "" without it."""
    request = HTTPConnection({"type": "http", "headers": list(headers), "query_string": b""})
    subprotocols = request.headers.get("sec-websocket-protocol", "").split(", ")
    knows = protection.knows(offered_token(subprotocols)) or protection.trusts(request)
    return "with the token" if knows else ""


def _warn(service: Service) -> None:
    """Report which limits are missing for programs that users of other computers run here."""
    from learnblock.runtime.containment.survey import survey  # noqa: PLC0415 - for a class only

    if free := tuple(finding.name for finding in survey() if not finding.contained):
        service.announce(Phrase("server-not-contained", free=free))


def collect_rarely() -> None:
    """Collect garbage less often than Python does by default."""
    # An edit of a long program creates a few hundred thousand objects, and nearly all of them stay
    # until the next one. With Python's defaults, garbage collection takes as long as the edit.
    gc.freeze()
    gc.set_threshold(50_000, 20, 50)


def configured(
    app: object,
    *,
    connections: Connections | None = None,
    identify: Identify = lambda _: "",
    loop: str = "asyncio",
    **others: Any,
) -> uvicorn.Config:
    """Uvicorn's settings for one of our applications.

    Args:
        app: the application.
        connections: counts the connections that wait for their browser; None if none are counted.
        identify: finds out who sent a request.
        loop: the event loop, as uvicorn names it.
        others: more settings of uvicorn.
    """
    return uvicorn.Config(
        app,  # type: ignore[arg-type]
        loop=loop,
        http=partial(TimedRequests, connections=connections, identify=identify),  # type: ignore[arg-type]
        ws="websockets-sansio",
        ws_max_size=_LONGEST_FRAME,
        # The page is mostly on the same computer, where compression costs more than it saves.
        ws_per_message_deflate=False,
        lifespan="on",
        log_config=None,
        access_log=False,
        server_header=False,
        timeout_graceful_shutdown=_FAREWELL,
        # This many are accepted at a time, before the accepted ones are read.
        backlog=_BACKLOG,
        **others,
    )


def _page_address(service: Service, listening: socket.socket) -> str:
    path = f"/{service.base_url.strip('/')}/".replace("//", "/")
    return f"http://{_place(service, listening)}{path}"


def whole_address(
    address: str, token: str | None, project: str | None, link: str | None = None
) -> str:
    """The address that opens a page: with the token, and the project or the link to open."""
    query = f"?token={token}" if token else ""
    if link:
        return f"{address}{query}#{KEY}={link}"
    return f"{address}{query}#project={quote(project)}" if project else f"{address}{query}"


def _place(service: Service, listening: socket.socket) -> str:
    if service.unix_socket:
        # Only a proxy connects there, and it has a name.
        return next(iter(service.allowed_hosts), "localhost")
    host, port = listening.getsockname()[:2]
    if host in _EVERYWHERE:
        host = socket.gethostname()
    return f"[{host}]:{port}" if ":" in host else f"{host}:{port}"


# Listening.


@contextmanager
def _listening(service: Service) -> Iterator[socket.socket]:
    if service.unix_socket:
        with _unix_socket(service.unix_socket) as listening:
            yield listening
    else:
        with tcp_socket(service.host, service.port) as listening:
            yield listening


def tcp_socket(host: str, port: int | None) -> socket.socket:
    """A socket that listens; without a port at our usual one, or at a free one if that is taken.

    Raises:
        LearnBlockError: nothing can listen there.
    """
    if port is None:
        try:
            return _bound(host, DEFAULT_PORT)
        except LearnBlockError:
            # The port is taken, probably by another LearnBlock, so use any free one.
            port = 0
    return _bound(host, port)


def _bound(host: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        return socket.create_server((host, port), family=family, backlog=_BACKLOG)
    except OSError as error:
        reason = error.strerror or str(error)
        raise LearnBlockError(
            "server-cannot-listen", host=host, port=str(port), reason=reason
        ) from error


@contextmanager
def _unix_socket(path: Path) -> Iterator[socket.socket]:
    _remove_abandoned(path)
    with socket.socket(socket.AF_UNIX) as listening:
        try:
            listening.bind(str(path))
        except OSError as error:
            reason = error.strerror or str(error)
            raise LearnBlockError(
                "server-cannot-listen-socket", path=str(path), reason=reason
            ) from error
        # The proxy may be another user of the same group; no one else may connect.
        path.chmod(0o660)
        listening.listen(_BACKLOG)
        try:
            yield listening
        finally:
            path.unlink(missing_ok=True)


def _remove_abandoned(path: Path) -> None:
    """Remove the socket of a server that was killed."""
    if not path.is_socket():
        return
    with socket.socket(socket.AF_UNIX) as trying:
        try:
            trying.connect(str(path))
        except ConnectionRefusedError:
            path.unlink()
            return
    raise LearnBlockError("server-already-listening", path=str(path))
