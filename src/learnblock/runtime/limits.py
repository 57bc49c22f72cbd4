"""The limits of a pupil's program, and how they are enforced."""

import sys
from typing import Any

import msgspec

from learnblock.errors import ForbiddenError

MEGABYTE = 1024 * 1024


class Limits(msgspec.Struct, frozen=True, array_like=True):
    """The resources that one program may use.

    Args:
        memory: bytes of address space; not enforced on systems that cannot limit it.
        cpu: the limit of processor time, in seconds.
        output: the limit of printed characters.
        file_size: the limit of each written file, in bytes.
        open_files: the limit of simultaneously open files.
        silence: how long a simulated robot waits for the program's next call, in seconds.
        preparation: how long a program may take to create its robot, in seconds.
    """

    memory: int = 2048 * MEGABYTE
    cpu: int = 3600
    output: int = MEGABYTE
    file_size: int = 16 * MEGABYTE
    open_files: int = 64
    silence: float = 5.0
    preparation: float = 15.0


#: Audit events (PEP 578) of attempts to start another process or to harm ours.
_FORBIDDEN = frozenset(
    {
        "os.exec",
        "os.fork",
        "os.forkpty",
        "os.kill",
        "os.killpg",
        "os.posix_spawn",
        "os.spawn",
        "os.startfile",
        "os.system",
        "pty.spawn",
        "subprocess.Popen",
    }
)


def contain(limits: Limits) -> None:
    """Apply the limits to this process permanently."""
    _limit_resources(limits)
    _end_with_parent()
    sys.addaudithook(_refuse)


def _limit_resources(limits: Limits) -> None:
    try:
        import resource  # noqa: PLC0415 - POSIX only
    except ImportError:
        return
    wanted = {
        resource.RLIMIT_AS: (limits.memory, limits.memory),
        # The first limit sends SIGXCPU, which shows the reason; the second one SIGKILL.
        resource.RLIMIT_CPU: (limits.cpu, limits.cpu + 1),
        resource.RLIMIT_FSIZE: (limits.file_size, limits.file_size),
        resource.RLIMIT_NOFILE: (limits.open_files, limits.open_files),
        resource.RLIMIT_CORE: (0, 0),
    }
    for kind, values in wanted.items():
        _, hard = resource.getrlimit(kind)
        most = sys.maxsize if hard == resource.RLIM_INFINITY else hard
        try:
            resource.setrlimit(kind, (min(values[0], most), min(values[1], most)))
        except (ValueError, OSError):
            # macOS refuses to limit the address space: the other limits still apply there.
            continue


def _end_with_parent() -> None:
    """Have Linux kill this process when its host dies, even in a loop that makes no call."""
    if sys.platform != "linux":
        return
    import ctypes  # noqa: PLC0415 - slow, and only Linux has prctl
    import signal  # noqa: PLC0415

    set_parent_death_signal = 1  # PR_SET_PDEATHSIG of <linux/prctl.h>
    ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)


def _refuse(event: str, args: tuple[Any, ...]) -> None:  # noqa: ARG001 - the hook's signature
    if event in _FORBIDDEN:
        raise ForbiddenError("run-no-processes", event=event)
