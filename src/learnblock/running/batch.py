"""Many runs, as many at once as there are processors, for variants and for grading.

A warm process, which has loaded what runs need, forks a contained child for each run. A program
that is `plain` shares that child with its robot and its world; any other program runs in a process
of its own, as usual. Where processes can't be forked, and on real robots, the runs are made here,
one after another.
"""

import os
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

import msgspec

from learnblock.i18n import Phrase
from learnblock.running import making, warm
from learnblock.running.job import Job, packed
from learnblock.running.program_run import ProgramRun
from learnblock.running.report import Report
from learnblock.running.result import RunResult, unpacked
from learnblock.runtime import process_group
from learnblock.runtime.claims import is_sayable
from learnblock.runtime.containment.environment import harmless
from learnblock.runtime.ending import How
from learnblock.runtime.validation import refused
from learnblock.storage.home import home

#: Seconds in which stopped runs have to end.
GRACE = 2.0
#: Why a run is lost if the process that forks the runs ended, again.
_PROCESS_ENDED = "the process that makes runs has ended"
#: The variables that runs need, in addition to those that every program gets. A program may share a
#: process with its host, so there are no secrets among them.
_OF_RUNS = (
    "HOME", "TMPDIR", "TEMP", "TMP", "LEARNBLOCK_PACE", "LEARNBLOCK_ROBOTS", "LEARNBLOCK_SEED",
    "LEARNBLOCK_VARIANT", "LEARNBLOCK_WORLD",
)  # fmt: skip
#: Whether a process can be forked for each run.
CAN_FORK = sys.platform == "linux"


class Batch:
    """Runs to be made.

    Args:
        jobs: the runs.
        at_once: how many are made at the same time; by default one for each processor.
        kept: the process that forks the runs, kept for further batches; it ends if this batch is
            stopped. Without it, or if it has ended, the batch starts one and ends it.
    """

    def __init__(
        self,
        jobs: Sequence[Job],
        at_once: int | None = None,
        *,
        kept: "WarmProcess | None" = None,
    ) -> None:
        self.jobs = tuple(jobs)
        self._at_once = at_once or processors()
        self._kept = kept
        self._warm: WarmProcess | None = None
        self._here: ProgramRun | None = None
        self._is_stopped = False

    def results(self) -> Iterator[tuple[int, RunResult]]:
        """Make the runs; yield the number of each with its result, as they end.

        A run that was stopped has none. One whose process dies is made once more; see
        `RunResult.lost`.

        Raises:
            LearnBlockError: a world or a variant is not possible.
        """
        for job in self.jobs:
            job.robot.load().check_wishes(job.options.wishes)
        simulated = all(job.robot.load().lockstep for job in self.jobs)
        yield from self._forked() if CAN_FORK and simulated else self._one_by_one()

    def stop(self) -> None:
        """End all runs within a second or two; may be called from any thread."""
        self._is_stopped = True
        if self._warm:
            self._warm.stop()
        if self._here:
            self._here.stop()

    def _one_by_one(self) -> Iterator[tuple[int, RunResult]]:
        for number, job in enumerate(self.jobs):
            watcher = making.Prints(job.keys)
            trace = making.trace_of(job)
            self._here = ProgramRun(job, watcher=watcher, trace=trace)
            report = replace(self._here.run(), output=watcher.text)
            if self._is_stopped:
                return
            trace_bytes = trace.getvalue() if trace else b""
            yield number, RunResult(report, trace_bytes)

    def _forked(self) -> Iterator[tuple[int, RunResult]]:
        remaining = [*range(len(self.jobs))]
        for process in (self._kept, None):
            if process and not process.is_running:
                continue
            for number, result in self._made_by(process, remaining):
                remaining.remove(number)
                if result.report.ended != How.STOPPED:
                    yield number, result
            if self._is_stopped or not remaining:
                return
        for number in remaining:
            yield number, making.lost(_PROCESS_ENDED)

    def _made_by(
        self, kept: "WarmProcess | None", numbers: Sequence[int]
    ) -> Iterator[tuple[int, RunResult]]:
        """Make some of the runs; fewer have a result if the process that forks them dies."""
        numbers = tuple(numbers)
        process = self._warm = kept or WarmProcess()
        jobs = tuple(self.jobs[number] for number in numbers)
        received = 0
        try:
            if self._is_stopped:
                return
            process.send(packed(jobs, self._at_once))
            for index, isolated, data in self._received(process, len(numbers)):
                received += 1
                yield numbers[index], checked_result(data, isolated=isolated)
        finally:
            # One that was left in the middle of a batch can't be given another.
            if kept is None or self._is_stopped or received < len(numbers):
                process.end()

    def _received(self, process: "WarmProcess", count: int) -> Iterator[tuple[int, bool, bytes]]:
        for _ in range(count):
            head = process.read(warm.HEAD.size)
            if self._is_stopped or len(head) < warm.HEAD.size:
                return
            index, isolated, length = warm.HEAD.unpack(head)
            data = process.read(length)
            if len(data) < length:
                return
            yield index, isolated, data


class WarmProcess:
    """A process that has loaded what runs need, and forks a contained child for each run."""

    def __init__(self) -> None:
        self._connection, theirs = socket.socketpair()
        with theirs:
            self._process = _start(theirs.fileno())
        self._stream = self._connection.makefile("rb")

    @property
    def is_running(self) -> bool:
        """Whether it can make runs."""
        return self._process.poll() is None

    def send(self, jobs: bytes) -> None:
        """Send the runs to be made, `packed`; those that were sent before are finished."""
        with suppress(BrokenPipeError, ConnectionResetError):
            self._connection.sendall(len(jobs).to_bytes(8) + jobs)

    def read(self, length: int) -> bytes:
        """Read from the results; fewer bytes at their end."""
        try:
            return self._stream.read(length)
        except ConnectionResetError:
            return b""

    def stop(self) -> None:
        """End the current runs; may be called from any thread."""
        self._process.send_signal(signal.SIGTERM)

    def end(self) -> None:
        """End the process, and with it every current run."""
        self._process.terminate()
        with suppress(OSError):
            self._connection.shutdown(socket.SHUT_RDWR)
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(GRACE)
        process_group.kill(self._process)
        self._stream.close()
        self._connection.close()


def processors() -> int:
    """The number of processors that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def checked_result(data: bytes, *, isolated: bool) -> RunResult:
    """The result that a child has sent; a program that was not isolated may have had a part."""
    try:
        result = unpacked(data)
        How(result.report.ended)
    except (msgspec.MsgspecError, ValueError):
        return RunResult(_failed(How.KILLED, Phrase("run-link-closed")))
    message = result.report.message
    if message is not None and not is_sayable(message):
        reason = refused("an error that is not known").phrase
        return RunResult(_failed(How.ERROR, reason), isolated=isolated)
    # Only a host that no program shares can say that a run is lost.
    return RunResult(result.report, result.trace, isolated, result.lost if isolated else "")


def _start(handle: int) -> "subprocess.Popen[bytes]":
    # -P: as for programs, which may run in it.
    command = [sys.executable, "-P", "-m", warm.__name__, str(handle)]
    variables = {
        **harmless(),
        **{name: os.environ[name] for name in _OF_RUNS if name in os.environ},
        # As in a program's own process: see `containment.environment`.
        "PYTHONHASHSEED": "0",
        "LEARNBLOCK_HOME": str(home().absolute()),
        # One processor for each run.
        "OMP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
    }
    return subprocess.Popen(  # noqa: S603 - our own interpreter and module
        command,
        env=variables,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        pass_fds=(handle,),
        # Ctrl-C is for us: we decide how the runs end.
        start_new_session=True,
    )


def _failed(how: How, message: Phrase) -> Report:
    return Report(ended=how, error={"message": message, "file": "", "line": 0, "text": ""})
