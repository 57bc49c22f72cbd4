"""Landlock: the kernel lets this process access only the files it lists (Linux 5.13 or later).

The numbers are from <linux/landlock.h> and never change. Each version of the interface adds rights,
so an older kernel restricts less.
"""

import os
import stat
import struct
from collections.abc import Iterable
from contextlib import suppress
from functools import cache

from learnblock.runtime.containment import kernel

_CREATE_RULESET, _ADD_RULE, _RESTRICT_SELF = 444, 445, 446
_ASK_VERSION = 1
_PATH_BENEATH = 1

_WRITE_FILE, _READ_FILE, _READ_DIR = 1 << 1, 1 << 2, 1 << 3
_REMOVE_DIR, _REMOVE_FILE = 1 << 4, 1 << 5
_MAKE_DIR, _MAKE_REG, _MAKE_FIFO = 1 << 7, 1 << 8, 1 << 10
_EXECUTE, _RENAME_ACROSS, _TRUNCATE, _CONTROL_DEVICE = 1, 1 << 13, 1 << 14, 1 << 15
#: File rights by the version that introduced them; the first version introduced thirteen.
_FILE_RIGHTS = {1: (1 << 13) - 1, 2: _RENAME_ACROSS, 3: _TRUNCATE, 5: _CONTROL_DEVICE}
#: Binding and connecting TCP sockets; signals and abstract sockets of other processes.
_NETWORK, _SCOPES = 0b11, 0b11

#: List the names in a folder and read its files; also change them.
READ = _READ_FILE | _READ_DIR
WRITE = (
    READ | _WRITE_FILE | _REMOVE_DIR | _REMOVE_FILE
    | _MAKE_DIR | _MAKE_REG | _RENAME_ACROSS | _TRUNCATE
)  # fmt: skip
#: Also start programs from it.
RUN = READ | _EXECUTE
#: Use a device file; also pass bytes to another process by a file with a name.
DEVICE = _READ_FILE | _WRITE_FILE | _TRUNCATE | _CONTROL_DEVICE
FOLDER = WRITE | _MAKE_FIFO
#: The rights that apply to files; the others apply to folders only.
_OF_A_FILE = DEVICE


@cache
def version() -> int:
    """The version of the kernel's Landlock; 0 if it is missing or cannot be used."""
    try:
        return kernel.call(_CREATE_RULESET, None, 0, _ASK_VERSION)
    except OSError:
        # The kernel is too old, was started without Landlock, or a container hides it.
        return 0


def restrict(allowed: Iterable[tuple[str, int]], *, network: bool) -> None:
    """Permanently refuse this thread all files except these; does nothing without Landlock.

    Args:
        allowed: files, and folders with everything in them, each with its rights; missing ones
            are skipped.
        network: whether it may use TCP.
    """
    if not version():
        return
    _enforce(allowed, _known_rights(), 0 if network else _NETWORK, _SCOPES)


def restrict_writing(allowed: Iterable[tuple[str, int]]) -> None:
    """Permanently refuse this thread to change files other than these; it may read all files.

    Processes that it has started before are outside its domain, but it may still end them.

    Args:
        allowed: as for `restrict`.
    """
    if version():
        _enforce(allowed, _known_rights() & ~(READ | _EXECUTE), 0, 0)


def _known_rights() -> int:
    return sum(rights for since, rights in _FILE_RIGHTS.items() if since <= version())


def _enforce(allowed: Iterable[tuple[str, int]], handled: int, network: int, scopes: int) -> None:
    ruleset = _ruleset(handled, network, scopes)
    try:
        for path, rights in allowed:
            _allow(ruleset, path, rights & handled)
        kernel.give_up_privileges()
        kernel.call(_RESTRICT_SELF, ruleset, 0)
    finally:
        os.close(ruleset)


def _ruleset(handled: int, network: int, scopes: int) -> int:
    size = 8 if version() < 4 else 16 if version() < 6 else 24
    rules = struct.pack("=QQQ", handled, network, scopes)[:size]
    return kernel.call(_CREATE_RULESET, rules, size, 0)


def _allow(ruleset: int, path: str, rights: int) -> None:
    with suppress(FileNotFoundError, NotADirectoryError, PermissionError):
        handle = os.open(path, os.O_PATH | os.O_CLOEXEC)
        try:
            if not stat.S_ISDIR(os.fstat(handle).st_mode):
                rights &= _OF_A_FILE
            rule = struct.pack("=Qi", rights, handle)
            kernel.call(_ADD_RULE, ruleset, _PATH_BENEATH, rule, 0)
        finally:
            os.close(handle)
