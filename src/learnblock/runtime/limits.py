"""The limits of a pupil's program; `containment` enforces them."""

import msgspec

MEGABYTE = 1024 * 1024


class Limits(msgspec.Struct, frozen=True, array_like=True):
    """The resources that one program may use.

    Args:
        memory: bytes of address space; not enforced on systems that cannot limit it.
        cpu: the maximum processor time, in seconds.
        output: the maximum number of printed characters.
        file_size: the maximum size of each written file, in bytes.
        open_files: the maximum number of simultaneously open files.
        silence: how long a program may compute before its next call, in seconds of processor time.
        preparation: the same before it creates its robot.
        blocked: how long it may wait for anything but its robot, such as a file, in seconds.
    """

    memory: int = 2048 * MEGABYTE
    cpu: int = 3600
    output: int = MEGABYTE
    file_size: int = 16 * MEGABYTE
    open_files: int = 64
    disk: int = 64 * MEGABYTE
    files: int = 1000
    threads: int = 100
    silence: float = 5.0
    preparation: float = 15.0
    blocked: float = 30.0
