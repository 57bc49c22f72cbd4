"""Makes one run in this process, as a process that was forked for it does."""

import os
import signal
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from dataclasses import replace
from io import BytesIO
from threading import Event, Thread
from time import process_time

from learnblock.i18n import Phrase
from learnblock.running.job import Job
from learnblock.running.plain import dead_ends, is_plain
from learnblock.running.program_run import ProgramRun
from learnblock.running.recorded_keys import RecordedKeys
from learnblock.running.report import Report
from learnblock.running.result import RunResult
from learnblock.runtime.claims import NOT_CONTAINED
from learnblock.runtime.containment.fence import contain_host
from learnblock.runtime.ending import How
from learnblock.runtime.fork_server import ForkServer
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.limits import Limits
from learnblock.runtime.process import ProcessWorker, Worker
from learnblock.runtime.standby import Standby
from learnblock.runtime.watcher import Watcher

#: Seconds between two looks at whether a program lets its host run.
WATCHING = 0.5


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


def trace_of(job: Job) -> BytesIO | None:
    """Where the trace of a job is kept, if it is wanted."""
    return BytesIO() if job.with_trace else None


def lost(reason: str) -> RunResult:
    """The result of a run that could not be made.

    Args:
        reason: why, in the words of an exception or of the system.
    """
    message = Phrase("run-lost", reason=reason)
    report = Report(ended=How.KILLED, error={"message": message, "file": "", "line": 0, "text": ""})
    return RunResult(report, lost=reason)


def made_isolated(job: Job, programs: ForkServer) -> RunResult:
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
    *,
    is_contained: bool = False,
) -> RunResult:
    """The run of a plain program in this process, which is contained from now on.

    Args:
        job: the run.
        prints: takes what the program prints, instead of the result.
        prepare: is called before the run.
        is_contained: whether the process is contained already.
    """
    if not is_contained:
        contain_host(job.limits, job.options.world)
    workers: list[InlineWorker] = []

    def worker() -> InlineWorker:
        workers.append(InlineWorker())
        return workers[0]

    with _ended_if_silent(job.limits, workers):
        return _made(job, prepare, worker, prints=prints)


@contextmanager
def _ended_if_silent(limits: Limits, workers: list[InlineWorker]) -> Iterator[None]:
    """End this process when its program computes for too long without its host."""

    def watch() -> None:
        turns, since = -1, process_time()
        while not ended.wait(WATCHING):
            now = workers[0].turns if workers else turns
            if now != turns:
                turns, since = now, process_time()
            elif process_time() - since > limits.silence:
                os._exit(1)

    ended = Event()
    # No signal: it would wait for the main thread, which waits for the host.
    watching = Thread(target=watch, daemon=True)
    watching.start()
    try:
        yield
    finally:
        ended.set()
        watching.join()


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
