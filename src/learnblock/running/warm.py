"""The warm process of a batch: it has loaded what runs need, and forks a child for each run.

It runs no program itself and has a single thread, so that forking is safe.
"""

import gc
import math
import os
import select
import signal
import socket
import struct
import sys
from collections import deque
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from importlib import import_module
from io import BytesIO
from pkgutil import iter_modules
from threading import Event, Thread
from time import monotonic, process_time
from types import FrameType
from typing import NoReturn

from learnblock import robots, skills
from learnblock.i18n import Phrase
from learnblock.installation import version
from learnblock.robots import RobotEntry
from learnblock.running.job import Job, Options, unpacked
from learnblock.running.plain import dead_ends, is_plain
from learnblock.running.program_run import ProgramRun
from learnblock.running.recorded_keys import RecordedKeys
from learnblock.running.report import Report
from learnblock.running.result import RunResult, packed
from learnblock.runtime.claims import NOT_CONTAINED
from learnblock.runtime.containment import kernel
from learnblock.runtime.containment.fence import contain_host
from learnblock.runtime.ending import How
from learnblock.runtime.escalation import PATIENCE
from learnblock.runtime.fork_server import ForkServer
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.limits import MEGABYTE, Limits
from learnblock.runtime.process import ProcessWorker, Worker
from learnblock.runtime.standby import Standby
from learnblock.runtime.watcher import Watcher
from learnblock.storage import skill_files

#: Before each result: the index of its job, whether its program was isolated, and its length.
HEAD = struct.Struct(">I?I")
#: The largest result, in bytes.
LARGEST = 256 * MEGABYTE
_CHUNK = MEGABYTE
#: New objects after which Python looks for garbage; by default 700.
_UNCOLLECTED = 20_000
#: The most worlds with their pictures that are kept for children, of some 15 MB each.
_PREPARED = 4
#: Seconds between two looks at whether runs that were stopped have ended.
_LOOK = 0.5
#: Seconds between two looks at whether a program lets its host run.
WATCHING = 0.5
#: The status of a child that has reported why it failed, and the limit of that report in bytes.
_FAILED, _LONGEST_CAUSE = 2, 1000
#: What runs on simulated robots load when they need it, in addition to our skills.
_PRELOADED = (
    "email.parser",
    "learnblock.client.extra_camera",
    "learnblock.closing",
    "learnblock.perception.detectors.lines",
    "learnblock.perception.detectors.tags",
    "learnblock.perception.settings",
    "learnblock.perception.sources.asking",
    "learnblock.perception.tag_names",
    "learnblock.runtime.containment.landlock",
    "learnblock.runtime.containment.paths",
    "learnblock.runtime.containment.seccomp",
    "learnblock.simulator.camera",
    "learnblock.simulator.polyline",
    "learnblock.simulator.scenery",
    "learnblock.simulator.templates",
    "platformdirs.unix",
)


class Prints(Watcher):
    """Keeps what a program prints.

    Args:
        keys: the keys that are pressed during the run.
    """

    def __init__(self, keys: RecordedKeys | None = None) -> None:
        self._parts: list[str] = []
        self._keys = keys

    @property
    def text(self) -> str:
        """All that it has printed."""
        return "".join(self._parts)

    def held_keys(self, time: float) -> Collection[str]:
        return self._keys.held(time) if self._keys else ()

    def printed(self, text: str) -> None:
        self._parts.append(text)


@dataclass(slots=True)
class _Child:
    """A run that is being made.

    Args:
        job: the index of its job.
        process: the number of its process.
        isolated: whether its program has a process of its own.
        received: what it has sent so far.
    """

    job: int
    process: int
    isolated: bool
    received: bytearray = field(default_factory=bytearray)


# Why: docs/decisions.md, "A batch forks a warm process"
def main() -> None:
    """Run as ``python -m learnblock.running.warm FD``: FD is our end of the connection."""
    kernel.die_with_parent(signal.SIGKILL)
    connection = socket.socket(fileno=int(sys.argv[1]))
    for module in (*_PRELOADED, *_skill_modules()):
        import_module(module)
    # Read from the installed packages, which a child would search again.
    robots.entries()
    skill_files.plugins()
    version()
    # Imported here because the server and the command line import this module, too.
    import cv2  # noqa: PLC0415

    # One processor for each run.
    cv2.setNumThreads(1)
    # A run leaves little that has to be collected.
    gc.set_threshold(_UNCOLLECTED)
    programs, is_frozen = ForkServer(), False
    with connection.makefile("rb") as stream:
        while length := stream.read(8):
            jobs, at_once = unpacked(stream.read(int.from_bytes(length)))
            for job in jobs:
                _load(job.robot, job.options.world)
            if not is_frozen:
                # A child that collected what we have loaded would copy all of it.
                gc.freeze()
                is_frozen = True
            runs = _Warm(connection, jobs, at_once, programs)
            try:
                runs.run()
            except (BrokenPipeError, ConnectionResetError):
                # The caller has gone. Our children end with us.
                return
            if runs.is_stopped:
                return


@lru_cache(maxsize=_PREPARED)
def _load(robot: RobotEntry, world: str | None) -> object:
    """Read and draw what each child would read and draw again, since it can't keep it."""
    kind = robot.load()
    kind.known_equipment()
    # Our caller has made such a world, too: it is possible.
    return kind.prepared(Options(world=world).wishes)


def _skill_modules() -> Iterator[str]:
    """Our skills; those of the user's folder are loaded where they are contained."""
    return (module.name for module in iter_modules(skills.__path__, f"{skills.__name__}."))


def is_shared(job: Job) -> bool:
    """Whether the program shares a process with its robot."""
    # The network is for programs that import something, which have a process of their own.
    if job.options.network or job.isolated or not is_plain(job.program):
        return False
    # Only a host in another process can end it: see `_end_if_silent`.
    return not dead_ends(job.program)


def trace_of(job: Job) -> BytesIO | None:
    """Where the trace of a job is kept, if it is wanted."""
    return BytesIO() if job.with_trace else None


class _Warm:
    """The runs of a batch.

    Args:
        connection: where results are sent.
        jobs: the runs.
        at_once: how many are made at the same time.
        programs: forks the processes of isolated programs.
    """

    def __init__(
        self, connection: socket.socket, jobs: Sequence[Job], at_once: int, programs: ForkServer
    ) -> None:
        self._connection = connection
        self._programs = programs
        self._jobs = jobs
        self._at_once = at_once
        #: The runs to be made: the index of each job, and whether its program is isolated.
        self._waiting = deque((number, not is_shared(job)) for number, job in enumerate(jobs))
        #: The runs that are being made, by the end of the pipe at which their results arrive.
        self._children: dict[int, _Child] = {}
        #: The runs whose child died once: the index of each job, and whether it was isolated.
        self._died: set[tuple[int, bool]] = set()
        self.is_stopped = False
        #: When the runs are killed, once they have been asked to stop.
        self._deadline = math.inf
        signal.signal(signal.SIGTERM, self._stop)

    def run(self) -> None:
        """Make all runs."""
        while self._waiting or self._children:
            while self._waiting and len(self._children) < self._at_once:
                self._start(*self._waiting.popleft())
            for handle in select.select([*self._children], [], [], _LOOK)[0]:
                self._receive(handle)
            if self._deadline < monotonic():
                for child in self._children.values():
                    os.kill(child.process, signal.SIGKILL)

    def _stop(self, number: int, frame: FrameType | None) -> None:  # noqa: ARG002
        self.is_stopped = True
        self._deadline = monotonic() + PATIENCE.stopped + PATIENCE.killed
        self._waiting.clear()
        self._at_once = 0
        for child in self._children.values():
            os.kill(child.process, signal.SIGTERM)

    def _start(self, number: int, isolated: bool) -> None:  # noqa: FBT001 - as it is kept
        if isolated:
            self._programs.begin()
        ours, theirs = os.pipe()
        process = os.fork()
        if process == 0:
            # Neither the results of others nor what is sent to our caller are its business.
            for handle in (ours, *self._children, self._connection.fileno()):
                os.close(handle)
            if not isolated:
                self._programs.let_go()
            _be_child(self._jobs[number], theirs, self._programs if isolated else None)
        os.close(theirs)
        self._children[ours] = _Child(number, process, isolated)

    def _receive(self, handle: int) -> None:
        child = self._children[handle]
        data = os.read(handle, _CHUNK)
        child.received += data
        if not data or len(child.received) > LARGEST:
            os.close(handle)
            self._finish(self._children.pop(handle))

    def _finish(self, child: _Child) -> None:
        is_too_large = len(child.received) > LARGEST
        if is_too_large:
            os.kill(child.process, signal.SIGKILL)
        status = os.waitstatus_to_exitcode(os.waitpid(child.process, 0)[1])
        if status == 0:
            self._send(child, child.received)
        elif not self._at_once:
            return
        elif is_too_large and child.isolated:
            self._send(child, b"")
        elif self._deserves_another(child, status):
            self._waiting.appendleft((child.job, child.isolated))
        elif not child.isolated:
            # It did not let its host run, or took too much: see how it ends in its own process.
            self._waiting.appendleft((child.job, True))
        else:
            self._send(child, packed(lost(_cause(status, child.received))))

    def _deserves_another(self, child: _Child, status: int) -> bool:
        """Whether a run is made again as it was, because its program may not be to blame."""
        run = (child.job, child.isolated)
        if run in self._died or len(child.received) > LARGEST:
            return False
        self._died.add(run)
        # In a process of its own, a program can't end that of its host.
        return child.isolated or status == -signal.SIGKILL

    def _send(self, child: _Child, result: bytes | bytearray) -> None:
        head = HEAD.pack(child.job, child.isolated, len(result))
        self._connection.sendall(head + result)


def lost(reason: str) -> RunResult:
    """The result of a run that could not be made.

    Args:
        reason: why, in the words of an exception or of the system.
    """
    message = Phrase("run-lost", reason=reason)
    report = Report(ended=How.KILLED, error={"message": message, "file": "", "line": 0, "text": ""})
    return RunResult(report, lost=reason)


def _cause(status: int, output: bytes | bytearray) -> str:
    """Why a child ended early: what it said, or its signal."""
    if status == _FAILED:
        return output.decode(errors="replace")
    return signal.strsignal(-status) or str(status) if status < 0 else f"status {status}"


def _be_child(job: Job, handle: int, programs: ForkServer | None) -> NoReturn:
    """Make a run in this process, send its result, and end.

    Args:
        job: the run.
        handle: where its result is sent.
        programs: forks the program's process; None if it shares this one.
    """
    status = 1
    try:
        kernel.die_with_parent(signal.SIGKILL)
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        _write(handle, packed(_isolated(job, programs) if programs else made_together(job)))
        status = 0
    except Exception as error:  # noqa: BLE001 - our mistake, or the system's: see `_Warm._finish`
        _write(handle, f"{type(error).__name__}: {error}".encode()[:_LONGEST_CAUSE])
        status = _FAILED
    finally:
        # The child must not clean up for its parent.
        os._exit(status)


def _write(handle: int, data: bytes) -> None:
    with os.fdopen(handle, "wb", closefd=False) as pipe:
        pipe.write(data)


def _isolated(job: Job, programs: ForkServer) -> RunResult:
    """The run of a program in a process of its own."""

    def prepare(run: ProgramRun) -> None:
        signal.signal(signal.SIGTERM, lambda *_: run.stop())

    if is_plain(job.program):
        job = replace(job, program=replace(job.program, dead_ends=dead_ends(job.program)))
    result = _made(job, prepare, standby=programs.standby())
    if _has_begun(result.report):
        return result
    again = _made(job, prepare, standby=programs.standby())
    if _is_not_contained(again.report):
        return lost(str(again.report.message))
    return again


def _has_begun(report: Report) -> bool:
    """Whether a program had its chance: a busy computer may end its process at the start."""
    died_at_once = report.ended == How.KILLED and report.time == 0
    return not died_at_once and not _is_not_contained(report)


def _is_not_contained(report: Report) -> bool:
    return report.message is not None and report.message.code == NOT_CONTAINED


def made_together(
    job: Job,
    prints: Prints | None = None,
    prepare: Callable[[ProgramRun], object] = lambda _: None,
) -> RunResult:
    """The run of a plain program in this process, which is contained from now on.

    Args:
        job: the run.
        prints: takes what the program prints, instead of the result.
        prepare: is called before the run.
    """
    contain_host(job.limits, job.options.world)
    workers: list[InlineWorker] = []

    def worker() -> InlineWorker:
        workers.append(InlineWorker())
        return workers[0]

    def begin(run: ProgramRun) -> None:
        _end_if_silent(job.limits, workers)
        prepare(run)

    return _made(job, begin, worker, prints=prints)


def _end_if_silent(limits: Limits, workers: list[InlineWorker]) -> None:
    """End this process when its program computes for too long without its host."""

    def watch() -> None:
        turns, since = -1, 0.0
        while not ended.wait(WATCHING):
            now = workers[0].turns
            if now != turns:
                turns, since = now, process_time()
            elif process_time() - since > limits.silence:
                os._exit(1)

    ended = Event()
    # No signal: it would wait for the main thread, which waits for the host.
    Thread(target=watch, daemon=True).start()


def _made(
    job: Job,
    prepare: Callable[[ProgramRun], object],
    worker: Callable[[], Worker] = ProcessWorker,
    standby: Standby | None = None,
    prints: Prints | None = None,
) -> RunResult:
    """Make a run."""
    prints, trace = prints or Prints(job.keys), trace_of(job)
    run = ProgramRun(job, trace=trace, watcher=prints, worker=worker, standby=standby)
    prepare(run)
    report = replace(run.run(), output=prints.text)
    trace_bytes = trace.getvalue() if trace else b""
    return RunResult(report, trace_bytes, isolated=worker is ProcessWorker)


if __name__ == "__main__":
    main()
