"""Runs with a log, in tests."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from learnblock import robots, running
from learnblock.running import Job, Options, ProgramRun, Report
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.log.blocks import EventBlock
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.process import ThreadWorker
from learnblock.runtime.watcher import Watcher
from learnblock.why import EventHistory
from learnblock.why.recorded import Recorded
from runs import EXAMPLES, Holder, person


@dataclass(frozen=True)
class Logged:
    """A finished run with its log."""

    report: Report
    recorded: Recorded
    blocks: tuple[EventBlock, ...]

    @property
    def history(self) -> EventHistory:
        """The log, read."""
        return EventHistory(self.recorded)


def logged_file(
    path: Path, robot: str, *, watcher: Watcher | None = None, **options: Any
) -> Logged:
    """Run a program's file with a log."""
    source, entry = running.read(path), robots.find(robot)
    program = running.program(source, entry)
    log = RunLog(program)
    # A real robot goes on while its program computes.
    worker = InlineWorker if entry.load().lockstep else ThreadWorker
    job = Job(program, entry, Options(**options))
    run = ProgramRun(job, worker=worker, watcher=watcher, log=log)
    if isinstance(watcher, Holder):
        watcher.session = run
    report = run.run()
    return Logged(report, Recorded.of(log.blocks), log.blocks)


def logged_example(name: str, robot: str, **options: Any) -> Logged:
    """Run one of the examples with a log, and with its `person`."""
    return logged_file(EXAMPLES / name, robot, watcher=person(name), **options)


def logged_blocks(name: str, robot: str, **options: Any) -> tuple[EventBlock, ...]:
    """The log of a run of one of the examples, as it is stored."""
    return logged_example(name, robot, **options).blocks


def logged_text(folder: Path, text: str, robot: str = "sim-ebo", **options: Any) -> Logged:
    """Run a program in Block-Text with a log."""
    path = folder / "program.bt"
    path.write_text(text, encoding="utf-8")
    return logged_file(path, robot, **options)
