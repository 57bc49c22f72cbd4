"""Checks the hand-ins of a step in a process of its own, and keeps what comes out."""

import asyncio
import sys
from collections.abc import Awaitable, Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import msgspec

from learnblock.classroom import check_process
from learnblock.classroom.check_process import CheckNews
from learnblock.classroom.collecting import plan_of
from learnblock.classroom.hand_ins import (
    RUNS,
    CheckedWork,
    CheckSummary,
    HandInShelf,
    HintSummary,
)
from learnblock.classroom.roster import Roster
from learnblock.errors import LearnBlockError, phrase_of
from learnblock.i18n import Phrase, languages
from learnblock.lessons.checks import Check
from learnblock.lessons.describing import title_of
from learnblock.lessons.grading.grading import Grading, Row
from learnblock.lessons.grading.journal import kept_only, opened_journal
from learnblock.lessons.grading.plan import Plan
from learnblock.lessons.grading.table import stars
from learnblock.lessons.grading.values import Result
from learnblock.lessons.reading import named_lesson

#: Seconds for the process to end once it is killed.
_KILLED = 5.0
#: The hints that are kept of a hand-in.
_MOST_HINTS = 2


def runs_folder(folder: Path, lesson: str, step: int) -> Path:
    """Where the finished runs of a step are kept."""
    return folder / RUNS / f"{lesson}.{step}"


@dataclass(frozen=True, slots=True)
class RunningCheck:
    """A check that is being made.

    Args:
        lesson: the name of the lesson.
        step: the number of the step.
        news: how far it is.
    """

    lesson: str
    step: int
    news: CheckNews


class Checking:
    """The check of a class, one at a time.

    Args:
        roster: the class.
        shelf: its hand-ins.
        changed: called when something has changed.
    """

    def __init__(self, roster: Roster, shelf: HandInShelf, changed: Callable[[], object]) -> None:
        self._roster = roster
        self._shelf = shelf
        self._changed = changed
        #: The check that is being made; None if there is none.
        self.running: RunningCheck | None = None
        #: What went wrong last; None if nothing did.
        self.failure: Phrase | None = None
        self._process: asyncio.subprocess.Process | None = None
        self._task: asyncio.Task[None] | None = None

    def start(self, lesson: str, step: int) -> None:
        """Begin to check the hand-ins of a step; only what is missing is made.

        Raises:
            LearnBlockError: a check is being made, or the step has no checks.
        """
        if self.running:
            raise LearnBlockError("class-checking")
        opened = named_lesson(lesson)
        if not opened.step(step).check:
            raise LearnBlockError("server-lesson-no-checks")
        self.running = RunningCheck(lesson, step, CheckNews())
        self.failure = None
        self._task = asyncio.create_task(self._check(self.running))

    def stop(self) -> None:
        """Finish the runs that are being made, and no further ones."""
        if self._process and self._process.returncode is None:
            self._process.terminate()

    async def wait(self) -> None:
        """Wait until the check has ended, if there is one."""
        if self._task:
            await asyncio.gather(self._task, return_exceptions=True)

    async def close(self) -> None:
        """End the check at once; what is finished is kept, and the next one goes on with it."""
        if self._task is None:
            return
        self._task.cancel()
        await self.wait()

    async def _check(self, wanted: RunningCheck) -> None:
        try:
            await self._noting_failure(self._make(wanted))
            # Also of what was finished before something went wrong.
            await self._noting_failure(asyncio.to_thread(self._keep, wanted))
        finally:
            self.running = None
            self._changed()

    async def _noting_failure(self, work: Awaitable[None]) -> None:
        try:
            await work
        except (LearnBlockError, OSError, ValueError) as error:
            self.failure = phrase_of(error)

    async def _make(self, wanted: RunningCheck) -> None:
        out = runs_folder(self._roster.folder, wanted.lesson, wanted.step)
        process = self._process = await asyncio.create_subprocess_exec(
            sys.executable, "-P", "-m", check_process.__name__,
            str(self._roster.folder), wanted.lesson, str(wanted.step), str(out),
            stdin=asyncio.subprocess.DEVNULL, stdout=asyncio.subprocess.PIPE,
        )  # fmt: skip
        assert process.stdout  # noqa: S101 - it is a pipe
        try:
            while line := await process.stdout.readline():
                news = msgspec.json.decode(line, type=CheckNews)
                if news.failure:
                    self.failure = news.failure
                else:
                    self.running = RunningCheck(wanted.lesson, wanted.step, news)
                self._changed()
            if await process.wait() and self.failure is None:
                raise LearnBlockError("class-check-died")
        finally:
            with suppress(ProcessLookupError):
                process.kill()
            with suppress(TimeoutError):
                await asyncio.wait_for(process.wait(), _KILLED)

    def _keep(self, wanted: RunningCheck) -> None:
        """Keep what the checks say with each hand-in whose runs are all finished."""
        plan = plan_of(self._roster, wanted.lesson, wanted.step)
        pupils = self._roster.pupils
        out = runs_folder(self._roster.folder, wanted.lesson, wanted.step)
        with opened_journal(out) as journal:
            grading = Grading(plan, journal)
            for pupil, handed_in in zip(pupils, plan.handed_in, strict=True):
                file = self._shelf.read(pupil.id, wanted.lesson, wanted.step)
                if file is None or file.work.program.text != handed_in.text:
                    continue
                checked = summary(plan, [*grading.rows_of(handed_in)])
                if checked and checked != file.checked:
                    self._shelf.keep_checked(pupil.id, file.work, checked)


def forget_runs(roster: Roster) -> None:
    """Delete the finished runs of programs that are no longer handed in.

    Raises:
        OSError: a file can't be written.
    """
    for folder in (roster.folder / RUNS).glob("*.*"):
        lesson, _, step = folder.name.rpartition(".")
        try:
            plan = plan_of(roster, lesson, int(step))
        except (LearnBlockError, ValueError):
            # The lesson is gone, so its table can't be made any more.
            kept_only(folder, frozenset())
        else:
            kept_only(folder, frozenset(_keys(plan)))


def _keys(plan: Plan) -> Iterator[str]:
    for handed_in in plan.handed_in:
        if handed_in.reason is None:
            for keyed in (plan.pieces(handed_in), plan.isolated(handed_in)):
                yield from (key for key, _ in keyed)


def summary(plan: Plan, rows: Sequence[Row]) -> CheckedWork | None:
    """What the checks say of a hand-in in all runs; None while some are missing."""
    results = [row.result for row in rows if row.result]
    if not results or len(results) < len(rows):
        return None
    checks = plan.opened.step(plan.step).check
    # What failed is more interesting; otherwise the first.
    shown = next((row for row in rows if row.result and not stars(checks, row.result)), rows[0])
    assert shown.result  # noqa: S101 - none is missing
    hints = {hint.rule: hint for result in results for hint in result.hints}
    return CheckedWork(
        runs=len(results),
        done=sum(stars(checks, result) > 0 for result in results),
        checks=tuple(_check(check, place, results) for place, check in enumerate(checks)),
        hints=tuple(
            HintSummary(dict(hint.because), dict(hint.levels[0]))
            for hint in [*hints.values()][:_MOST_HINTS]
        ),
        way=tuple(float(value) for point in shown.result.path for value in point),
        robot=shown.attempt.robot,
        variant=shown.attempt.variant,
        seconds=shown.result.seconds,
        reason=dict(shown.result.reason) or "",
    )


def _check(check: Check, place: int, results: Sequence[Result]) -> CheckSummary:
    outcomes = [result.checks[place] for result in results if place < len(result.checks)]
    reason = next((result.reason for result in outcomes if result.state != "met"), {})
    return CheckSummary(
        say={language: title_of(check, language) for language in languages()},
        met=sum(result.state == "met" for result in outcomes),
        optional=check.optional,
        reason=dict(reason) or "",
    )
