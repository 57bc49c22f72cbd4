"""The right to write to a projects folder, which one server has at a time."""

import hmac
import os
import socket
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Self

import msgspec
from filelock import FileLock, Timeout

from learnblock.i18n import Phrase
from learnblock.storage.files import save
from learnblock.storage.learned_types import learned

#: A larger file is not ours.
_LARGEST = 10_000
#: Seconds between two looks for a description that is still missing.
_LOOK_AGAIN = 0.05

#: Another user may have written them, and they are printed on a terminal.
_Printable = Annotated[str, msgspec.Meta(pattern="^[!-~]{0,300}$")]
_Moment = Annotated[float, msgspec.Meta(ge=0, le=4e9)]


class Owner(msgspec.Struct, frozen=True):
    """The server that writes to a folder.

    Args:
        process: its number.
        computer: the name of the computer it runs on, which matters on a network drive.
        since: seconds since 1970.
        address: where its page is; without the token, which others may not read.
        proof: proves to those who know the token that the server knows it too.
    """

    process: int
    computer: _Printable
    since: _Moment
    address: _Printable
    proof: _Printable = ""

    @classmethod
    def this_process(cls, address: str, token: str) -> "Owner":
        """Describe this server."""
        proof = _proof(token, address)
        return cls(os.getpid(), socket.gethostname(), time.time(), address, proof)

    @property
    def is_here(self) -> bool:
        """Whether it runs on this computer."""
        return self.computer == socket.gethostname()

    def knows(self, token: str) -> bool:
        """Whether the server at this address knows the token, so that it may be sent there."""
        return hmac.compare_digest(self.proof, _proof(token, self.address))

    @property
    def phrase(self) -> Phrase:
        """Describe the process for a person."""
        since = time.strftime("%Y-%m-%d %H:%M", time.localtime(self.since))
        values = {"process": str(self.process), "since": since, "address": self.address}
        if self.is_here:
            return Phrase("server-owner", **values)
        return Phrase("server-owner-elsewhere", computer=self.computer, **values)


# Why: docs/decisions.md, "One server writes to a folder"
class FolderClaim:
    """A claim to a projects folder.

    The system releases a process's lock however the process ends, so a crash blocks nothing.

    Args:
        folder: the folder, which is made if it does not exist.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        # A server in a window claims in one thread and releases in another. A lock that is only a
        # file would outlive a crash. Users that share the folder share the lock.
        self._lock = FileLock(
            folder / ".writer.lock", thread_local=False, fallback_to_soft=False, mode=0o666
        )
        self._description = folder / ".writer.json"
        self._request = folder / ".take-over"

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.release()

    def claim(self, patience: float = 0.0) -> bool:
        """Try to get the right to write; return whether this server has it.

        Args:
            patience: seconds to wait for another server to exit.

        Raises:
            OSError: nothing can be locked in this folder.
        """
        self._folder.mkdir(parents=True, exist_ok=True)
        try:
            self._lock.acquire(timeout=patience)
        except Timeout:
            return False
        # These files belong to a server that has exited.
        self._description.unlink(missing_ok=True)
        self._request.unlink(missing_ok=True)
        return True

    def take_over(self, patience: float) -> bool:
        """Ask the other server to exit; return whether this one then has the right to write.

        Args:
            patience: seconds to wait for it.

        Raises:
            OSError: the request can't be written.
        """
        self._request.touch()
        try:
            return self.claim(patience)
        finally:
            self._request.unlink(missing_ok=True)

    def describe(self, address: str, token: str) -> None:
        """Save a description of this server for others, if it has the right to write."""
        if self._lock.is_locked:
            with suppress(OSError):
                save(self._description, msgspec.json.encode(Owner.this_process(address, token)))

    @property
    def is_claimed(self) -> bool:
        """Whether a server has the right to write now; after a crash only its description is left.

        Raises:
            OSError: nothing can be locked in this folder.
        """
        try:
            with self._lock.acquire(timeout=0):
                return False
        except Timeout:
            return True

    @property
    def owner(self) -> Owner | None:
        """The server that has the right to write; None if unknown."""
        try:
            with self._description.open("rb") as file:
                return msgspec.json.decode(file.read(_LARGEST), type=learned(Owner))
        except (OSError, msgspec.MsgspecError):
            # It has just started, or this user may not read the folder.
            return None

    def await_owner(self, patience: float) -> Owner | None:
        """The server that has the right to write, once it has started; None if unknown.

        Args:
            patience: seconds to wait for it.
        """
        deadline = time.monotonic() + patience
        while (owner := self.owner) is None and time.monotonic() < deadline:
            time.sleep(_LOOK_AGAIN)
        return owner

    @property
    def owner_phrase(self) -> Phrase:
        """Describe the server that has the right to write."""
        owner = self.owner
        return owner.phrase if owner else Phrase("server-owner-unknown")

    @property
    def is_asked_to_end(self) -> bool:
        """Whether another server wants to take over."""
        return self._lock.is_locked and self._request.exists()

    def release(self) -> None:
        """Give up the right to write; calling it twice is harmless."""
        if self._lock.is_locked:
            self._description.unlink(missing_ok=True)
            self._lock.release()


@dataclass(frozen=True)
class Access:
    """What a server may do with its folder.

    Args:
        writer: the right to write; None if files in the folder can't be locked.
        read_only: why the server only reads; None if it also writes.
    """

    writer: FolderClaim | None = None
    read_only: Phrase | None = None

    @classmethod
    def reading(cls, writer: FolderClaim) -> "Access":
        """Only read, while another server may write."""
        if writer.owner is None:
            return cls(read_only=Phrase("server-reading"))
        return cls(read_only=Phrase("server-reading-beside", owner=writer.owner_phrase))


def _proof(token: str, address: str) -> str:
    return hmac.digest(token.encode(), address.encode(), "sha256").hex()
