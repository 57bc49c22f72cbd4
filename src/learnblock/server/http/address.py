"""The page's address: where other devices reach this computer, and the secret in it.

The secret, the token, gives access to the server.
"""

import os
import re
import secrets
import socket
import stat
from contextlib import suppress
from pathlib import Path

from learnblock.errors import LearnBlockError
from learnblock.storage.files import save
from learnblock.storage.home import home

VARIABLE = "LEARNBLOCK_TOKEN"
_TOKEN = re.compile(r"[\w.~-]+", re.ASCII)
#: The maximum number of characters, more than any token that we create has.
_LONGEST = 200
#: An address for documentation (RFC 5737), which no network uses.
_ELSEWHERE = ("192.0.2.1", 9)


def token(*, new: bool = False) -> str:
    """The token from the environment, or else the user's own token, which stays the same.

    An open page can therefore reconnect after the server restarts.

    Args:
        new: whether to replace the user's own, which closes every open page for good.

    Raises:
        LearnBlockError: the token in the environment can't be part of an address.
    """
    chosen = os.environ.get(VARIABLE)
    if chosen is None:
        return _own(new=new)
    if not _TOKEN.fullmatch(chosen):
        raise LearnBlockError("server-token-wrong", variable=VARIABLE)
    return chosen


def _own(*, new: bool) -> str:
    file = home() / "token"
    saved = None if new else _read(file)
    if saved is not None:
        return saved
    token = secrets.token_urlsafe(24)
    # If the token can't be saved, LearnBlock works, but its address changes with each restart.
    with suppress(OSError):
        save(file, token.encode(), private=True)
    return token


def _read(file: Path) -> str | None:
    """Read the token; None if there is none, or if other users can read it."""
    try:
        with file.open(encoding="ascii") as opened:
            if os.name == "posix" and stat.S_IMODE(os.fstat(opened.fileno()).st_mode) & 0o077:
                return None
            token = opened.read(_LONGEST + 1)
    except (OSError, UnicodeDecodeError):
        return None
    return token if len(token) <= _LONGEST and _TOKEN.fullmatch(token) else None


def own_address() -> str | None:
    """Return the numeric address of this computer in its network; None if it is in none.

    Nothing is sent: the system only chooses the interface for a datagram.
    """
    with suppress(OSError), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.connect(_ELSEWHERE)
        return str(probe.getsockname()[0])
    return None
