"""The limits that every POSIX system can set on a process."""

import os
import sys

from learnblock.runtime.limits import Limits


def limit(limits: Limits) -> None:
    """Limit memory, processor time and files of this process, for good."""
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


def address_space() -> int:
    """The bytes of address space that this process uses; 0 if the system does not report it."""
    try:
        with open("/proc/self/statm", "rb") as sizes:  # noqa: PTH123 - as fast as can be
            return int(sizes.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    except OSError:
        return 0
