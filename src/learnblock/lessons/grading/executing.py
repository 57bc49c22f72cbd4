"""A piece of a grading: one program, in one variant of the world, on one robot.

It runs wherever an executor puts it: in another process of this computer, or on a cluster.
"""

import atexit
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path
from queue import Empty, SimpleQueue
from threading import Lock
from typing import NamedTuple

import msgspec

from learnblock import robots, running
from learnblock.errors import FileError, LearnBlockError
from learnblock.evidence.evidence import Evidence, evidence_of
from learnblock.i18n import Phrase, in_each_language, languages
from learnblock.installation import version
from learnblock.lessons.expert import Experts, expert_processes
from learnblock.lessons.grading.thinning import thinned
from learnblock.lessons.grading.values import (
    DIFFERS,
    Checked,
    CheckResult,
    HintResult,
    Manner,
    Result,
    Texts,
    packed,
)
from learnblock.lessons.hints import Elsewhere, hints
from learnblock.lessons.judging import Verdict, judge
from learnblock.lessons.lesson import Lesson, Step
from learnblock.lessons.opened import OpenLesson, is_of_checks
from learnblock.lessons.reading import for_pupils
from learnblock.lessons.texts import Title, in_language
from learnblock.lessons.trying import Attempt, StepRuns
from learnblock.running import Report, Source
from learnblock.running.batch import CAN_FORK, Batch, WarmProcess
from learnblock.running.job import Job
from learnblock.running.result import RunResult
from learnblock.runtime.ending import How
from learnblock.runtime.fork_server import ForkServer
from learnblock.runtime.limits import MEGABYTE, Limits
from learnblock.simulator import WorldDescription

#: The most hints of a result, besides the one about other attempts.
MOST_HINTS = 3
#: The rules about a program that does well in the usual attempt, of which a piece knows nothing:
#: the grading leaves them out where they don't fit. A run gets one of them at most.
ABOUT_OTHERS = frozenset({"hint-only-here", "hint-other-robot"})
#: Longer traces, in bytes, are not judged: an honest run of ten minutes has a tenth of it.
LONGEST_TRACE = 48 * MEGABYTE
#: The most worlds whose files are kept; more than a process ever runs at the same time.
MOST_WORLDS = 16
#: Endings that come at no exact moment of the robot's time.
_INEXACT = frozenset({How.KILLED, How.NO_CALL, How.STOPPED})
#: Where programs seem to be: there is nothing beside them.
_NOWHERE = Path("/learnblock-handed-in")


class NotRunError(LearnBlockError, RuntimeError):
    """A run could not be made, although it was tried again: not the program's fault."""


class Lean(msgspec.Struct, frozen=True, array_like=True):
    """What a lesson's pieces need of it.

    Args:
        name: its name.
        lesson: its content.
        files: its programs and worlds.
    """

    name: str
    lesson: Lesson
    files: dict[str, bytes]


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece to be made: plain values, which every executor can send.

    Args:
        version: of LearnBlock, where the grading was started.
        lesson: the lesson: see `packed_lesson`.
        step: the number of the step.
        text: the program.
        is_python: whether it is Python.
        tags: the numbers of tags, by name, that it uses.
        attempt: the robot, the variant of the world and the seed.
        usual: the usual robot among those that are tried.
        manner: how the program is run.
        limits: the resources that the program may use.
    """

    version: str
    lesson: bytes
    step: int
    text: str
    is_python: bool
    tags: tuple[tuple[str, int], ...]
    attempt: Attempt
    usual: str
    manner: Manner
    limits: Limits


def packed_lesson(opened: OpenLesson, step: int) -> bytes:
    """A lesson for the pieces of a step: the same bytes for the same content."""
    folders = ["programs/"]
    if opened.world(step) in opened.own_worlds:
        folders.append("worlds/")
    files = for_pupils(opened).files
    needed = {
        path: files[path]
        for path in sorted(files)
        if is_of_checks(path) or path.startswith(tuple(folders))
    }
    return msgspec.msgpack.encode(Lean(opened.name, opened.lesson, needed), order="deterministic")


def run_piece(piece: Piece) -> bytes:
    """Make a piece; return its `Result`, packed.

    Raises:
        LearnBlockError: this computer has another version of LearnBlock.
        NotRunError: the run could not be made.
    """
    here = version()
    if here != piece.version:
        raise LearnBlockError("grade-other-version", here=here, there=piece.version)
    try:
        source = _source(piece.text, piece.is_python)
        return packed(_made(piece, source))
    except FileError as error:
        return packed(Result(ended="refused", reason=in_each_language(error.phrase)))


def _made(piece: Piece, source: Source) -> Result:
    mistake = _mistake(piece.text, piece.is_python, piece.attempt.robot)
    if mistake is not None:
        return Result(ended="refused", reason=in_each_language(mistake))
    return _PieceRun(piece, _lesson(piece.lesson), source).result()


@dataclass(frozen=True)
class _PieceRun:
    piece: Piece
    opened: OpenLesson
    source: Source

    def result(self) -> Result:
        """Run the program, and judge what it did."""
        piece, tags = self.piece, dict(self.piece.tags)
        world = _world_file(piece.lesson, piece.step)
        runs = StepRuns(self.opened, piece.step, self.source, world, piece.limits, tags=tags)
        if self._step.partners:
            return self._in_team(runs)
        job = self._job(runs)
        first = self._run(replace(job, isolated=self.piece.manner == "isolated"))
        if self.piece.manner != "compared" or first.isolated:
            return self._of(first, "isolated" if first.isolated else "shared")
        apart = self._run(replace(job, isolated=True))
        same = apart.report == first.report
        return self._of(apart, "shared, same isolated" if same else DIFFERS)

    @property
    def _step(self) -> Step:
        return self.opened.step(self.piece.step)

    def _job(self, runs: StepRuns) -> Job:
        job = runs.job(self.piece.attempt)
        return replace(job, program=replace(job.program, folder=""))

    def _run(self, job: Job) -> RunResult:
        """Make one run, in a process that is kept for the next one."""
        [(_, result)] = _forked(job) if CAN_FORK else Batch([job]).results()
        if result.lost:
            raise NotRunError("run-lost", reason=result.lost)
        return result

    def _in_team(self, runs: StepRuns) -> Result:
        """The result of a step with partners, where every program has a process of its own."""
        [(_, result)] = runs.results([self.piece.attempt])
        return self._judged(result, "isolated")

    def _of(self, run: RunResult, checked: Checked) -> Result:
        if len(run.trace) > LONGEST_TRACE:
            reason = in_each_language(
                Phrase("grade-trace-too-long", limit=LONGEST_TRACE // MEGABYTE)
            )
            return Result(ended=How.KILLED, checked=checked, reason=reason)
        return self._judged(run, checked)

    def _judged(self, run: RunResult, checked: Checked) -> Result:
        report, evidence = run.report, evidence_of(run)
        world = _world(self.piece.lesson, self.piece.step)
        with _expert_processes() as processes:
            experts = Experts(self.opened, processes=processes)
            verdicts = judge(self._step, self.source.tree, evidence, world, experts)
        return Result(
            checks=tuple(map(_check_result, verdicts)),
            ended=report.ended,
            seconds=round(report.time, 3),
            trace_sha256="" if report.ended in _INEXACT else report.trace_sha256,
            checked=checked,
            path=thinned([(placed.x, placed.y) for placed in evidence.path]),
            hints=self._hints(verdicts, evidence, world),
            reason=_reason(report),
        )

    def _hints(
        self, verdicts: Sequence[Verdict], evidence: Evidence, world: WorldDescription | None
    ) -> tuple[HintResult, ...]:
        elsewhere = Elsewhere(
            is_variant=self.piece.attempt.variant > 0,
            is_other_robot=self.piece.attempt.robot != self.piece.usual,
            passes_usually=True,
        )
        tree = self.source.tree
        fitting = hints(self._step, tree, verdicts, evidence, world=world, elsewhere=elsewhere)
        return tuple(
            HintResult(hint.rule, tuple(map(_in_all, hint.levels)), _in_all(hint.because))
            for hint in fitting[: MOST_HINTS + 1]
        )


def _forked(job: Job) -> list[tuple[int, RunResult]]:
    idle = _idle().runs
    try:
        process = idle.get_nowait()
    except Empty:
        process = WarmProcess()
    try:
        return [*Batch([job], 1, kept=process).results()]
    finally:
        if process.is_running:
            idle.put(process)


class _Idle(NamedTuple):
    """The processes that no piece uses now, for runs and what forks those of checks; and worlds.

    Args:
        runs: make the runs.
        experts: fork the processes of checks.
        worlds: the files of worlds.
    """

    runs: "SimpleQueue[WarmProcess]"
    experts: "SimpleQueue[ForkServer]"
    worlds: "WorldFiles"


class WorldFiles:
    """The files of the worlds that were needed last; a worker of a cluster may see many lessons."""

    def __init__(self) -> None:
        #: By lesson and step, the one that was needed last at the end.
        self._files: dict[tuple[bytes, int], tuple[ExitStack, str | None]] = {}
        #: A worker may make pieces in several threads.
        self._lock = Lock()

    def of(self, packed_one: bytes, step: int) -> str | None:
        """The file of a step's world."""
        key = packed_one, step
        with self._lock:
            if (kept := self._files.pop(key, None)) is None:
                while len(self._files) >= MOST_WORLDS:
                    self._delete(next(iter(self._files)))
                files = ExitStack()
                kept = files, files.enter_context(_lesson(packed_one).world_file(step))
            self._files[key] = kept
            return kept[1]

    def close(self) -> None:
        """Delete all files."""
        with self._lock:
            for key in [*self._files]:
                self._delete(key)

    def _delete(self, key: tuple[bytes, int]) -> None:
        self._files.pop(key)[0].close()


@cache
def _idle() -> _Idle:
    atexit.register(end_idle)
    return _Idle(SimpleQueue(), SimpleQueue(), WorldFiles())


@contextmanager
def _expert_processes() -> Iterator[ForkServer]:
    """What forks the processes of checks, kept for the next piece."""
    idle = _idle().experts
    try:
        processes = idle.get_nowait()
    except Empty:
        processes = expert_processes()
    try:
        yield processes
    finally:
        idle.put(processes)


def end_idle() -> None:
    """End the processes that were kept for further runs and checks, and delete their worlds."""
    for idle in (_idle().runs, _idle().experts):
        with suppress(Empty):
            while True:
                idle.get_nowait().end()
    _idle().worlds.close()


@lru_cache(maxsize=64)
def _source(text: str, is_python: bool) -> Source:  # noqa: FBT001 - as it is sent
    name = "program.py" if is_python else "program.bt"
    return running.source_of(_NOWHERE / name, text, is_python=is_python)


@lru_cache(maxsize=64)
def _mistake(text: str, is_python: bool, robot: str) -> Phrase | None:  # noqa: FBT001 - as above
    """Why a program can't run on a robot; None if it can."""
    diagnostics = running.check(_source(text, is_python), robots.find(robot))
    return next(
        (diagnostic.message for diagnostic in diagnostics if diagnostic.severity == "error"), None
    )


@lru_cache(maxsize=4)
def _lesson(packed_one: bytes) -> OpenLesson:
    lean = msgspec.msgpack.decode(packed_one, type=Lean)
    return OpenLesson(lean.name, lean.lesson, None, lean.files)


@lru_cache(maxsize=16)
def _world(packed_one: bytes, step: int) -> WorldDescription | None:
    return _lesson(packed_one).described_world(step)


def _world_file(packed_one: bytes, step: int) -> str | None:
    """The world of a step as runs take it, the same for all pieces: it is read and drawn once."""
    return _idle().worlds.of(packed_one, step)


def _check_result(verdict: Verdict) -> CheckResult:
    reason = {} if verdict.explanation is None else in_each_language(verdict.explanation)
    at = None if verdict.at is None else round(verdict.at, 3)
    return CheckResult(verdict.state, at, reason)


def _reason(report: Report) -> Texts:
    if report.error is None:
        return {}
    message = report.error["message"]
    assert isinstance(message, Phrase)  # noqa: S101 - see `Report`
    line = f"{line}: " if (line := report.error["line"]) else ""
    return {language: line + text for language, text in in_each_language(message).items()}


def _in_all(text: Phrase | Title) -> Texts:
    if isinstance(text, Phrase):
        return in_each_language(text)
    return {language: in_language(text, language) for language in languages()}
