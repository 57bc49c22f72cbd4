"""System calls that Python has no function for, made through the C library."""

import ctypes
import os
from functools import cache
from typing import Any

_PR_SET_PDEATHSIG = 1
_PR_SET_NO_NEW_PRIVS = 38


def machine() -> str:
    """The processor's kind, such as ``x86_64``."""
    return os.uname().machine


def prctl(option: int, *args: Any) -> None:
    """Change something about this process.

    Raises:
        OSError: the kernel refuses.
    """
    values = [*args, *[0] * (4 - len(args))]
    _checked(_libc().prctl(option, *map(_as_argument, values)))


def call(number: int, *args: Any) -> int:
    """Make the system call of this number.

    Raises:
        OSError: the kernel refuses.
    """
    return _checked(_libc().syscall(ctypes.c_long(number), *map(_as_argument, args)))


def give_up_privileges() -> None:
    """Prevent files from giving this process more rights, as Landlock and seccomp require."""
    prctl(_PR_SET_NO_NEW_PRIVS, 1)


def die_with_parent(signal: int) -> None:
    """Have the kernel send this process a signal when its parent dies."""
    prctl(_PR_SET_PDEATHSIG, signal)


@cache
def _libc() -> ctypes.CDLL:
    libc = ctypes.CDLL(None, use_errno=True)
    libc.syscall.restype = ctypes.c_long
    return libc


def _as_argument(value: Any) -> Any:
    # Without a type, ctypes passes 32 bits of a number.
    return ctypes.c_ulong(value) if isinstance(value, int) else value


def _checked(result: int) -> int:
    if result < 0:
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))
    return result
