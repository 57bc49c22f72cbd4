"""A LearnBlock that is already running: its page is shown again, and it takes files in."""

import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

import msgspec

from learnblock.errors import LearnBlockError
from learnblock.project.files import ENDING
from learnblock.project.files.project import Project
from learnblock.project.files.project_file import encode
from learnblock.project.files.writer import FolderClaim
from learnblock.server import messages
from learnblock.server.http.address import token as the_token
from learnblock.server.http.protection import SUBPROTOCOL
from learnblock.server.serve import whole_address

if TYPE_CHECKING:
    from websockets.sync.client import ClientConnection

#: Seconds within which a running server answers.
PATIENCE = 5.0


@dataclass(frozen=True)
class RunningServer:
    """A server of this user on this computer.

    Args:
        address: where its page is, without the token.
        token: the token.
    """

    address: str
    token: str

    @classmethod
    def of(cls, writer: FolderClaim) -> "RunningServer | None":
        """The server that has the right to write; None if another user's, or it doesn't answer."""
        owner, token = writer.await_owner(PATIENCE), the_token()
        # Another user of the folder could write an address into it. The token is not sent there.
        if owner is None or not owner.is_here or not owner.knows(token):
            return None
        server = cls(owner.address, token)
        with suppress(OSError, LearnBlockError), server._visit():
            return server
        return None

    def page(self, project: str | None = None, link: str | None = None) -> str:
        """The address that opens its page, with a project or a link."""
        return whole_address(self.address, self.token, project, link)

    def add(self, project: Project) -> str:
        """Let it save a new project, and return the name of the project.

        Raises:
            LearnBlockError: it can't.
        """
        request = messages.Import(f"{project.name}{ENDING}", encode(project).decode())
        with self._visit() as page:
            page.send(msgspec.json.encode(request), text=True)
            for received in _received(page):
                match msgspec.json.decode(received)["kind"]:
                    case "Opened":
                        return msgspec.json.decode(received, type=messages.Opened).name
                    case "Failed":
                        failed = msgspec.json.decode(received, type=messages.Failed)
                        raise LearnBlockError(failed.message.code, **failed.message.values)
        raise LearnBlockError("server-silent", address=self.address)

    @contextmanager
    def _visit(self) -> Iterator["ClientConnection"]:
        """Connect as a page does, once the server accepts it.

        Raises:
            LearnBlockError: it does not answer.
        """
        from websockets.exceptions import WebSocketException  # noqa: PLC0415 - rarely needed
        from websockets.sync.client import connect  # noqa: PLC0415 - as above

        address = urlsplit(self.address)
        try:
            # A socket of its own, because a proxy must not be used for this computer's addresses.
            ours = socket.create_connection((address.hostname or "", address.port or 80), PATIENCE)
            with connect(
                f"ws://{address.netloc}{address.path}ws",
                sock=ours,
                subprotocols=[SUBPROTOCOL, self.token],  # type: ignore[list-item]
                open_timeout=PATIENCE,
                close_timeout=PATIENCE,
                max_size=None,
            ) as page:
                page.recv(PATIENCE)
                yield page
        except (OSError, WebSocketException) as error:
            raise LearnBlockError("server-silent", address=self.address) from error


def _received(page: "ClientConnection") -> Iterator[bytes]:
    while True:
        data = page.recv(PATIENCE)
        if isinstance(data, str):
            yield data.encode()
