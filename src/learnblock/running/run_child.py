"""A forked process that makes runs, seen from the process that forks it and from within.

One whose program has a process of its own makes a single run. One that a plain program shares makes
further runs of that program, in other variants of its world or with other seeds, one after the
other: being forked, contained and loaded costs as much as half a minute of a driving robot.
"""

import os
import signal
import struct
import threading
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from enum import IntEnum
from time import process_time
from typing import NamedTuple, NoReturn

import msgspec

from learnblock import robots
from learnblock.running.job import Job
from learnblock.running.library_state import LibraryState
from learnblock.running.making import made_isolated, made_together
from learnblock.running.result import RunResult, packed
from learnblock.runtime.containment import kernel
from learnblock.runtime.containment.fence import contain_host
from learnblock.runtime.ending import How
from learnblock.runtime.fork_server import ForkServer
from learnblock.runtime.limits import MEGABYTE

#: The largest result, in bytes.
LARGEST = 256 * MEGABYTE
_CHUNK = MEGABYTE
#: The limit of the report of a child on why it failed, in bytes.
_LONGEST_CAUSE = 1000
#: A child makes further runs until it has used this share of what a single run may use.
_SHARE = 0.1
#: The runs after which a program has left its process as it was.
_USUAL = frozenset({How.FINISHED, How.TIME_LIMIT})


class _Kind(IntEnum):
    """What a child sends: why it failed; its last result; or one after which it goes on."""

    FAILURE = 0
    LAST = 1
    RESULT = 2


#: Before what a child sends: its kind and its length.
_HEAD = struct.Struct(">BI")


class _Order(NamedTuple):
    """What is different in a further run."""

    seed: int | None
    variant: int | None


_decode_order = msgspec.msgpack.Decoder(_Order).decode


@dataclass(slots=True, eq=False)
class RunChild:
    """A child, seen from the process that has forked it.

    Args:
        job: the run that it was forked for.
        number: the index of the job that it makes.
        isolated: whether its program has a process of its own.
        process: the number of its process.
        results: where its results arrive.
        orders: where further runs are ordered.
        received: what it has sent of the result that it makes.
    """

    job: Job
    number: int
    isolated: bool
    process: int
    results: int
    orders: int
    received: bytearray = field(default_factory=bytearray)

    def order(self, job: Job, number: int) -> bool:
        """Let it make another run; return whether it can, after its last one."""
        if self.isolated or _alike(job) != _alike(self.job):
            return False
        order = _Order(job.options.seed, job.options.variant)
        try:
            # The pipe is empty and takes it at once, whatever the child does.
            os.write(self.orders, msgspec.msgpack.encode(order))
        except BrokenPipeError:
            return False
        self.number = number
        self.received.clear()
        return True

    def receive(self) -> bool:
        """Read from its result; return whether that has come to an end."""
        data = os.read(self.results, _CHUNK)
        self.received += data
        return not data or self.is_too_large or self._length() is not None

    @property
    def is_too_large(self) -> bool:
        """Whether it sends too much."""
        return len(self.received) > LARGEST

    @property
    def goes_on(self) -> bool:
        """Whether it waits for an order."""
        is_whole = self._length() == len(self.received)
        return is_whole and self.received[0] == _Kind.RESULT

    @property
    def result(self) -> bytes | None:
        """The result of its run; None if there is none."""
        length = self._length()
        if length is None or self.received[0] == _Kind.FAILURE:
            return None
        return bytes(self.received[_HEAD.size : length])

    def end(self) -> int:
        """Kill it, unless it has ended by itself; return its status, negative for a signal."""
        os.close(self.results)
        os.close(self.orders)
        os.kill(self.process, signal.SIGKILL)
        return os.waitstatus_to_exitcode(os.waitpid(self.process, 0)[1])

    def cause(self, status: int) -> str:
        """Why it ended without a result: what it sent, or how it ended."""
        length = self._length()
        if length and self.received[0] == _Kind.FAILURE:
            return self.received[_HEAD.size : length].decode(errors="replace")
        return signal.strsignal(-status) or str(status) if status < 0 else f"status {status}"

    def _length(self) -> int | None:
        """The length of what it sends with its head, once all of it has arrived."""
        if len(self.received) < _HEAD.size:
            return None
        length = _HEAD.size + int(_HEAD.unpack_from(self.received)[1])
        return length if length <= len(self.received) else None


def forked(
    job: Job, number: int, way: ForkServer | LibraryState, leave: Callable[[], object]
) -> RunChild:
    """Fork a child that makes a run.

    Args:
        job: the run.
        number: the index of its job.
        way: forks the program's process; or, if it shares that of its host, what its further runs
            must find unchanged.
        leave: closes, in the child, what is none of its business.
    """
    results, theirs = os.pipe()
    ordered, orders = os.pipe()
    process = os.fork()
    if process == 0:
        os.close(results)
        os.close(orders)
        leave()
        _be_child(job, theirs, ordered, way)
    os.close(theirs)
    os.close(ordered)
    return RunChild(job, number, isinstance(way, ForkServer), process, results, orders)


def is_repeatable(job: Job) -> bool:
    """Whether further runs of a plain program may be made in its process.

    A plain program changes nothing in its process but through its robot, and ours keep nothing
    beyond a run; a robot from the user's folder or a plugin may.
    """
    return robots.is_built_in(job.robot.name)


def _alike(job: Job) -> Job:
    """A job without what an order changes."""
    return replace(job, options=replace(job.options, seed=None, variant=None))


def _be_child(job: Job, results: int, orders: int, way: ForkServer | LibraryState) -> NoReturn:
    """Make runs in this process, send their results, and end."""
    status = 1
    try:
        kernel.die_with_parent(signal.SIGKILL)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        if isinstance(way, ForkServer):
            _write(results, _Kind.LAST, packed(made_isolated(job, way)))
        else:
            _make_together(job, results, orders, way)
        status = 0
    except Exception as error:  # noqa: BLE001 - our mistake, or the system's: see `_Warm._finish`
        cause = f"{type(error).__name__}: {error}".encode()
        _write(results, _Kind.FAILURE, cause[:_LONGEST_CAUSE])
    finally:
        # The child must not clean up for its parent.
        os._exit(status)


# Why: docs/decisions.md, "The runs of a plain program follow each other in one process"
def _make_together(job: Job, results: int, orders: int, state: LibraryState) -> None:
    """Make the run of a plain program, and further ones while its process is as it was."""
    contain_host(job.limits, job.options.world)
    memory = _memory()
    while True:
        result = made_together(job, is_contained=True)
        goes_on = is_repeatable(job) and _is_usual(result, job, memory) and state.is_unchanged()
        _write(results, _Kind.RESULT if goes_on else _Kind.LAST, packed(result))
        if not goes_on or not (order := os.read(orders, _CHUNK)):
            return
        seed, variant = _decode_order(order)
        job = replace(job, options=replace(job.options, seed=seed, variant=variant))


def _is_usual(result: RunResult, job: Job, memory: int) -> bool:
    """Whether a run has ended as most do, and has left neither a thread nor much of its memory."""
    return (
        result.report.ended in _USUAL
        and threading.active_count() == 1
        and _memory() - memory < _SHARE * job.limits.memory
        and process_time() < _SHARE * job.limits.cpu
    )


def _memory() -> int:
    """The most bytes of memory that this process has had; it may not read what it has now."""
    import resource  # noqa: PLC0415 - POSIX only

    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def _write(handle: int, kind: _Kind, data: bytes) -> None:
    with os.fdopen(handle, "wb", closefd=False) as pipe:
        pipe.write(_HEAD.pack(kind, len(data)) + data)
