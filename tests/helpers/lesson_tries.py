"""Many programs tried in a step of a lesson, in one batch."""

import hashlib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache

import msgspec

from learnblock.lessons.checks import Ends
from learnblock.lessons.judging import is_done
from learnblock.lessons.mutants import Mutant
from learnblock.lessons.reading import OpenLesson, find_lesson
from learnblock.lessons.trying import Attempt, JudgedRun, StepRuns, attempts, read_program
from learnblock.running.batch import Batch, WarmProcess
from learnblock.running.job import Job
from learnblock.runtime.inline import InlineWorker

#: A lesson that comes with LearnBlock, read once by all tests.
read_once = cache(find_lesson)
#: What of a trace is behaviour: not which lines ran, nor which skills asked what.
_BEHAVIOUR = ("pose", "device", "print", "goal", "send", "stroke", "end")


def tried(
    opened: OpenLesson,
    step: int,
    sources: Sequence[str],
    wanted: Sequence[Attempt],
    kept: WarmProcess | None = None,
    *,
    seconds: float | None = None,
) -> list[list[JudgedRun]]:
    """Try programs: the results of each, in the order of the attempts.

    Args:
        opened: the lesson.
        step: the number of the step.
        sources: the programs.
        wanted: the attempts of each.
        kept: a process that makes the runs, so that not every batch starts one.
        seconds: the limit of each run with a single robot; by default that of the step.
    """
    made: dict[tuple[int, int], JudgedRun] = {}
    with opened.world_file(step) as file:
        # The programs of lessons can be trusted, and a team takes turns in one thread much faster.
        programs = [
            StepRuns(opened, step, read_program(one), file, worker=InlineWorker) for one in sources
        ]
        if opened.step(step).partners:
            return [[_only(runs, attempt) for attempt in wanted] for runs in programs]
        jobs = [_limited(runs.job(attempt), seconds) for runs in programs for attempt in wanted]
        for index, result in Batch(jobs, kept=kept).results():
            program, number = divmod(index, len(wanted))
            made[program, number] = programs[program].judged(wanted[number], result)
    return [[made[one, two] for two in range(len(wanted))] for one in range(len(sources))]


def _limited(job: Job, seconds: float | None) -> Job:
    return job if seconds is None else replace(job, options=replace(job.options, seconds=seconds))


def _longest(opened: OpenLesson, step: int) -> float:
    """After how many seconds a program that still runs has failed a check, and so can be ended."""
    tried = opened.step(step)
    ends = [check.within for check in tried.check if isinstance(check, Ends) and check.within]
    return min([tried.seconds, *(within + 0.5 for within in ends)])


def _only(runs: StepRuns, attempt: Attempt) -> JudgedRun:
    [(_, result)] = runs.results([attempt])
    return runs.judged(attempt, result)


def behaviour(trace: bytes) -> str:
    """What a run's trace shows of its behaviour, as a hash."""
    kept = hashlib.sha256()
    for text in trace.splitlines():
        line = msgspec.json.decode(text)
        if not any(kind in line for kind in _BEHAVIOUR):
            continue
        kept.update(text)
    return kept.hexdigest()


def tried_until_failed(
    opened: OpenLesson,
    step: int,
    sources: Sequence[str],
    right: Sequence[JudgedRun],
    kept: WarmProcess | None = None,
) -> list[list[JudgedRun]]:
    """Try programs; one that fails in the first attempt, in another way, has no others.

    Args:
        opened: the lesson.
        step: the number of the step.
        sources: the programs.
        right: the attempts of the solution, which are those of the programs.
        kept: as of `tried`.
    """
    wanted = [one.attempt for one in right]
    seconds = _longest(opened, step)
    first = tried(opened, step, sources, wanted[:1], kept, seconds=seconds)
    open_ = [
        number
        for number, [one] in enumerate(first)
        if is_done(one.verdicts) or behaviour(one.result.trace) == behaviour(right[0].result.trace)
    ]
    if wanted[1:]:
        left = [sources[number] for number in open_]
        more = tried(opened, step, left, wanted[1:], kept, seconds=seconds)
        for number, others in zip(open_, more, strict=True):
            first[number] += others
    return first


def unnoticed(
    opened: OpenLesson,
    step: int,
    programs: Sequence[Mutant],
    kept: WarmProcess | None = None,
) -> Iterator[Mutant]:
    """Those that behave in another way than a step's solution, and that its checks accept.

    They are tried with the usual robot, in the world as it is and in all variants.
    """
    wanted = attempts(opened, step, robots=opened.robots(step)[:1])
    [right] = tried(opened, step, [opened.solution(step) or ""], wanted, kept)
    expected = [behaviour(one.result.trace) for one in right]
    sources = [one.source for one in programs]
    for program, done in zip(
        programs, tried_until_failed(opened, step, sources, right, kept), strict=True
    ):
        is_other = [behaviour(one.result.trace) for one in done] != expected
        if is_other and all(is_done(one.verdicts) for one in done):
            yield program
