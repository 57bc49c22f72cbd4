"""`learnblock` without a command: the server, with the page in a browser or in a window."""

import contextlib
import gc
import os
import re
import secrets
import signal
import socket
import threading
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from urllib.parse import quote

import click
import uvicorn

from learnblock.errors import LearnBlockError
from learnblock.server.app import create_app

DEFAULT_HOST = "127.0.0.1"
DEFAULT_PORT = 8421
#: Addresses that stand for every one of the machine's own.
_EVERYWHERE = {"0.0.0.0", "::"}  # noqa: S104 - only where the user asks for it
#: Seconds that open pages have to go when the server ends.
_FAREWELL = 1
#: Bytes; twice what a message may have, so that the page hears what is wrong and is not cut off.
_LONGEST_FRAME = 8 * 1024 * 1024
_TOKEN = re.compile(r"[\w.~-]+", re.ASCII)


@dataclass(frozen=True)
class Service:
    """What to serve, and where.

    Args:
        folder: where the projects are.
        host: the address to listen at.
        port: None for the usual one, or a free one where that is taken.
        unix_socket: listen there instead.
        base_url: the path under which everything is.
        allowed_hosts: names by which a proxy calls it.
        project: the project to open.
    """

    folder: Path
    host: str = DEFAULT_HOST
    port: int | None = None
    unix_socket: Path | None = None
    base_url: str = "/"
    allowed_hosts: tuple[str, ...] = ()
    project: str | None = None

    @property
    def hosts(self) -> tuple[str, ...]:
        """The names by which it may be called."""
        own = "*" if self.host in _EVERYWHERE else self.host
        return (own, socket.gethostname(), *self.allowed_hosts)


def serve(service: Service, *, show: Callable[[str], object] | None = None) -> None:
    """Serve until Ctrl-C or SIGTERM; then every program ends, and every project is saved.

    Args:
        service: what, and where.
        show: is called with the address once it answers, in a thread of its own.

    Raises:
        LearnBlockError: it cannot listen there, or the token of the environment is none.
    """
    with _server(service, show) as (server, listening), contextlib.suppress(KeyboardInterrupt):
        # Both are the usual end. Uvicorn ends the server, and then raises the signal again.
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        server.run([listening])


def show_in_browser(address: str) -> None:
    """Open the page in the user's browser; where there is none the printed address serves."""
    with contextlib.suppress(webbrowser.Error):
        webbrowser.open(address)


def serve_in_window(service: Service) -> None:
    """Serve while a window of its own shows the page.

    Raises:
        LearnBlockError: pywebview is not installed, or as `serve` does.
    """
    try:
        webview = import_module("webview")
    except ImportError as error:
        raise LearnBlockError(
            "a window needs pywebview: pip install 'learnblock-studio[window]', or leave out"
            " --window and use the browser"
        ) from error
    started = threading.Event()
    address = []

    def show(shown: str) -> None:
        address.append(shown)
        started.set()

    with _server(service, show) as (server, listening):
        # Windows belong to the main thread on every system.
        serving = threading.Thread(target=server.run, args=([listening],), name="server")
        serving.start()
        started.wait()
        webview.create_window("LearnBlock", address[0])
        webview.start()
        server.should_exit = True
        serving.join()


class _Server(uvicorn.Server):
    """A server that says when it answers."""

    def __init__(self, config: uvicorn.Config, answers: Callable[[], None]) -> None:
        super().__init__(config)
        self._answers = answers

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._answers()


@contextmanager
def _server(
    service: Service, show: Callable[[str], object] | None
) -> Iterator[tuple[uvicorn.Server, socket.socket]]:
    token = _token()
    app = create_app(
        service.folder,
        token=token,
        hosts=service.hosts,
        origins=service.allowed_hosts,
        base_url=service.base_url,
    )
    with _listening(service) as listening:

        def answers() -> None:
            address = _address(service, listening, token)
            click.echo(f"LearnBlock is at {address}\nStop it with Ctrl-C.")
            if show:
                threading.Thread(target=show, args=(address,), daemon=True).start()

        _collect_rarely()
        yield _Server(_config(app), answers), listening


def _collect_rarely() -> None:
    # An edit of a long program makes some hundred thousand objects, of which nearly all stay until
    # the next one: at Python's own pace the search for garbage takes as long as the edit.
    gc.freeze()
    gc.set_threshold(50_000, 20, 50)


def _config(app: object) -> uvicorn.Config:
    return uvicorn.Config(
        app,  # type: ignore[arg-type]
        loop="asyncio",
        http="h11",
        ws="websockets-sansio",
        ws_max_size=_LONGEST_FRAME,
        # The page is on the same machine, mostly: packing would cost more than it saves.
        ws_per_message_deflate=False,
        lifespan="on",
        log_config=None,
        access_log=False,
        server_header=False,
        timeout_graceful_shutdown=_FAREWELL,
    )


def _token() -> str:
    token = os.environ.get("LEARNBLOCK_TOKEN") or secrets.token_urlsafe(24)
    if not _TOKEN.fullmatch(token):
        raise LearnBlockError("LEARNBLOCK_TOKEN must be letters, digits, `-`, `_`, `.` and `~`")
    return token


def _address(service: Service, listening: socket.socket, token: str) -> str:
    path = f"/{service.base_url.strip('/')}/".replace("//", "/")
    fragment = f"#project={quote(service.project)}" if service.project else ""
    return f"http://{_place(service, listening)}{path}?token={token}{fragment}"


def _place(service: Service, listening: socket.socket) -> str:
    if service.unix_socket:
        # Only a proxy comes in there, and it has a name.
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
        with _tcp_socket(service.host, service.port) as listening:
            yield listening


def _tcp_socket(host: str, port: int | None) -> socket.socket:
    if port is None:
        try:
            return _bound(host, DEFAULT_PORT)
        except LearnBlockError:
            # Another LearnBlock, most likely: any other port will do as well.
            port = 0
    return _bound(host, port)


def _bound(host: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        return socket.create_server((host, port), family=family, backlog=128)
    except OSError as error:
        raise LearnBlockError(
            f"cannot listen at {host}, port {port}: {error.strerror}; choose another --port"
        ) from error


@contextmanager
def _unix_socket(path: Path) -> Iterator[socket.socket]:
    _remove_abandoned(path)
    with socket.socket(socket.AF_UNIX) as listening:
        try:
            listening.bind(str(path))
        except OSError as error:
            raise LearnBlockError(f"cannot listen at {path}: {error.strerror or error}") from error
        # The proxy may be another user of the same group; nobody else comes in.
        path.chmod(0o660)
        listening.listen(128)
        try:
            yield listening
        finally:
            path.unlink(missing_ok=True)


def _remove_abandoned(path: Path) -> None:
    """A server that was killed leaves its socket behind."""
    if not path.is_socket():
        return
    with socket.socket(socket.AF_UNIX) as trying:
        try:
            trying.connect(str(path))
        except ConnectionRefusedError:
            path.unlink()
            return
    raise LearnBlockError(f"another LearnBlock listens at {path}")
