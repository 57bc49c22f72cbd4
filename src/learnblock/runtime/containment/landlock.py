"""Landlock: the kernel refuses this process every file but those it names (Linux 5.13 or later).

The numbers are those of <linux/landlock.h>, which never change; each version of the interface adds
some, so an older kernel contains less.
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
_MAKE_DIR, _MAKE_REG = 1 << 7, 1 << 8
_RENAME_ACROSS, _TRUNCATE = 1 << 13, 1 << 14
#: Rights on files by the version that brought them; the first one brought thirteen.
_FILE_RIGHTS = {1: (1 << 13) - 1, 2: _RENAME_ACROSS, 3: _TRUNCATE, 5: 1 << 15}
#: Binding and connecting TCP sockets; signals and abstract sockets of other processes.
_NETWORK, _SCOPES = 0b11, 0b11

#: The names in a folder; its files too; changing all of that.
LIST = _READ_DIR
READ = _READ_FILE | LIST
WRITE = (
    READ | _WRITE_FILE | _REMOVE_DIR | _REMOVE_FILE
    | _MAKE_DIR | _MAKE_REG | _RENAME_ACROSS | _TRUNCATE
)  # fmt: skip
#: Those of these rights that a file can have; the others are a folder's.
_OF_A_FILE = _READ_FILE | _WRITE_FILE | _TRUNCATE


@cache
def version() -> int:
    """The version of the kernel's Landlock; 0 if it has none, or none for us."""
    try:
        return kernel.call(_CREATE_RULESET, None, 0, _ASK_VERSION)
    except OSError:
        # Too old, switched off at its start, or hidden by a container.
        return 0


def restrict(allowed: Iterable[tuple[str, int]], *, network: bool) -> None:
    """Refuse this process all files but these, for good; does nothing without Landlock.

    Args:
        allowed: files, and folders with all they contain, each with the rights to it; those that
            are missing are skipped.
        network: whether it may use TCP.
    """
    if not version():
        return
    handled = sum(rights for since, rights in _FILE_RIGHTS.items() if since <= version())
    ruleset = _ruleset(handled, network=network)
    try:
        for path, rights in allowed:
            _allow(ruleset, path, rights & handled)
        kernel.give_up_privileges()
        kernel.call(_RESTRICT_SELF, ruleset, 0)
    finally:
        os.close(ruleset)


def _ruleset(handled: int, *, network: bool) -> int:
    size = 8 if version() < 4 else 16 if version() < 6 else 24
    refused = 0 if network else _NETWORK
    rules = struct.pack("=QQQ", handled, refused, _SCOPES)[:size]
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
