"""seccomp: the kernel refuses this thread all system calls except those that it needs.

The filter is a program for the kernel's packet filter (classic BPF, <linux/seccomp.h>) that reads a
call's number and arguments. It cannot follow pointers: Landlock decides which files may be opened.
"""

import ctypes
import errno
import os
import struct
import sys
from collections.abc import Iterator, Mapping
from functools import cache
from typing import NamedTuple

from learnblock.runtime.containment import kernel
from learnblock.runtime.containment.syscalls import LAST_KNOWN, PROCESSORS, numbers, refused

_PR_SET_SECCOMP, _MODE_FILTER = 22, 2

# Filter instructions: load a word of the call, mask it, compare it, return.
_LOAD, _AND, _EQUAL, _GREATER, _RETURN = 0x20, 0x54, 0x15, 0x25, 0x06
_ALLOW, _KILL, _ERROR = 0x7FFF0000, 0x80000000, 0x00050000
# Offsets of the filter's input: call number, architecture, and six arguments of two words each.
_NUMBER, _PROCESSOR, _ARGUMENTS = 0, 4, 16
_ALL = 0xFFFFFFFF

_THREAD = 0x00010000
#: Flags of `clone` that make new namespaces, for which root needs no permission.
_NEW_NAMESPACES = 0x7E020000


class Condition(NamedTuple):
    """A condition on one word of a call's arguments.

    Args:
        word: the word's index: the lower half of argument n is word 2 n.
        values: the allowed values of the masked word.
        mask: the bits of the word that are compared.
    """

    word: int
    values: tuple[int, ...]
    mask: int = _ALL


class _Instruction(NamedTuple):
    code: int
    if_true: int
    if_false: int
    value: int


class _Program(ctypes.Structure):
    _fields_ = (("length", ctypes.c_ushort), ("instructions", ctypes.c_char_p))


@cache
def is_supported() -> bool:
    """Whether this kernel supports filters and we have one for this architecture."""
    if sys.maxsize < _ALL:
        # A 32-bit Python makes other calls than its 64-bit kernel's own, as on many Raspberry Pis.
        return False
    try:
        kernel.prctl(_PR_SET_SECCOMP, _MODE_FILTER, None)
    except OSError as error:
        # It complains about the missing filter only if it supports filters.
        return error.errno == errno.EFAULT and kernel.machine() in PROCESSORS
    return False


def restrict(*, network: bool) -> None:
    """Permanently refuse this thread all calls but a program's; does nothing where unsupported."""
    if is_supported():
        _enforce(_filter(kernel.machine(), network=network))


def restrict_driver(*, network: bool, programs: bool, files: bool) -> None:
    """Permanently refuse this thread what a driver does not need; as `syscalls.refused`."""
    if is_supported():
        processor = kernel.machine()
        calls = refused(processor, network=network, programs=programs, files=files)
        _enforce(_refusing(processor, calls))


def _enforce(filter_: Iterator[_Instruction]) -> None:
    instructions = b"".join(struct.pack("=HBBI", *instruction) for instruction in filter_)
    program = _Program(len(instructions) // 8, instructions)
    kernel.give_up_privileges()
    kernel.prctl(_PR_SET_SECCOMP, _MODE_FILTER, ctypes.byref(program))


def _filter(processor: str, *, network: bool) -> Iterator[_Instruction]:
    conditions = _conditions(os.getpid(), network=network)
    yield from _beginning(processor, _KILL)
    for name, number in numbers(processor, network=network).items():
        body = list(_verdict(name, conditions))
        yield _Instruction(_EQUAL, 0, len(body), number)
        yield from body
    yield _answer(_ERROR | errno.EPERM)


def _refusing(processor: str, calls: Mapping[str, int]) -> Iterator[_Instruction]:
    # Not the end of the process, which is the server.
    yield from _beginning(processor, _ERROR | errno.EPERM)
    for name, number in calls.items():
        starts_thread = name in {"clone", "clone3"}
        body = [*_verdict(name, _THREADS)] if starts_thread else [_answer(_ERROR | errno.EPERM)]
        yield _Instruction(_EQUAL, 0, len(body), number)
        yield from body
    yield _answer(_ALLOW)


def _beginning(processor: str, foreign: int) -> Iterator[_Instruction]:
    """Load the call's number; answer calls of other architectures, and later ones."""
    yield _load(_PROCESSOR)
    # A call made for a different architecture has different numbers.
    yield _Instruction(_EQUAL, 1, 0, PROCESSORS[processor])
    yield _answer(foreign)
    yield _load(_NUMBER)
    yield _Instruction(_GREATER, 0, 1, LAST_KNOWN)
    yield _answer(_ERROR | errno.ENOSYS)


def _verdict(name: str, conditions: Mapping[str, tuple[Condition, ...]]) -> Iterator[_Instruction]:
    """Decide about a call: it is allowed if all conditions for it are met."""
    if name == "clone3":
        # The flags are behind a pointer; the C library falls back to `clone`.
        yield _answer(_ERROR | errno.ENOSYS)
        return
    for condition in conditions.get(name, ()):
        yield _load(_ARGUMENTS + 4 * condition.word)
        yield _Instruction(_AND, 0, 0, condition.mask)
        left = len(condition.values)
        for value in condition.values:
            yield _Instruction(_EQUAL, left, 0, value)
            left -= 1
        yield _answer(_ERROR | errno.EPERM)
    yield _answer(_ALLOW)


def _conditions(process: int, *, network: bool) -> dict[str, tuple[Condition, ...]]:
    itself = (Condition(0, (process,)),)
    stream = Condition(2, (1,), mask=0xF)
    conditions = {
        **_THREADS,
        "kill": itself,
        "tgkill": itself,
        "rt_tgsigqueueinfo": itself,
        "ioctl": (Condition(2, _IOCTLS),),
        "fcntl": (Condition(2, _FCNTLS),),
        "prctl": (Condition(0, _PRCTLS),),
        # A program may read its own limits.
        "prlimit64": (Condition(0, (0,)), Condition(4, (0,)), Condition(5, (0,))),
        # A pair of datagram sockets could send to other sockets, so only streams are allowed.
        "socketpair": (Condition(0, (1,)), stream),
        # Before Linux 6.2, opening a file for reading could still truncate it.
        "open": (Condition(2, _OPENINGS, mask=_OPENING),),
        "openat": (Condition(4, _OPENINGS, mask=_OPENING),),
    }
    if network:
        internet = (Condition(0, (2, 10)), Condition(2, (1, 2), mask=0xF))
        return conditions | {"socket": internet}
    # Sending is allowed only without an address.
    return conditions | {"sendto": (Condition(8, (0,)), Condition(9, (0,)))}


#: Threads may be created, but not processes.
_THREADS = {"clone": (Condition(0, (_THREAD,), mask=_THREAD | _NEW_NAMESPACES),)}
#: Set inheritance and blocking, count the bytes to read, and query terminal properties.
_IOCTLS = (0x5451, 0x5450, 0x5421, 0x541B, 0x5401, 0x5413, 0x802C542A)
#: Copies, flags, locks and pipe sizes; not the owner, which would receive signals.
_FCNTLS = (0, 1, 2, 3, 4, 5, 6, 7, 36, 37, 38, 1030, 1031, 1032)
#: Set the names of threads and of memory areas.
_PRCTLS = (15, 16, 0x53564D41)
_OPENING = os.O_ACCMODE | os.O_TRUNC if hasattr(os, "O_ACCMODE") else 0
_OPENINGS = (os.O_RDONLY, os.O_WRONLY, os.O_RDWR, os.O_WRONLY | os.O_TRUNC, os.O_RDWR | os.O_TRUNC)


def _load(position: int) -> _Instruction:
    return _Instruction(_LOAD, 0, 0, position)


def _answer(value: int) -> _Instruction:
    return _Instruction(_RETURN, 0, 0, value)
