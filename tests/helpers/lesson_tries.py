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
    plan: Sequence[Attempt],
    kept: WarmProcess | None = None,
    *,
    seconds: float | None = None,
) -> list[list[JudgedRun]]:
    """Try programs: the results of each, in the order of the attempts.

    Args:
        opened: the lesson.
        step: the number of the step.
        sources: the programs.
        plan: the attempts of each.
        kept: a process that makes the runs, so that not every batch starts one.
        seconds: the limit of each run with a single robot; by default that of the step.
    """
    results: dict[tuple[int, int], JudgedRun] = {}
    with opened.world_file(step) as file:
        # The programs of lessons can be trusted, and a team takes turns in one thread much faster.
        programs = [
            StepRuns(opened, step, read_program(source), file, worker=InlineWorker)
            for source in sources
        ]
        if opened.step(step).partners:
            return [[_only(runs, attempt) for attempt in plan] for runs in programs]
        jobs = [_limited(runs.job(attempt), seconds) for runs in programs for attempt in plan]
        for index, result in Batch(jobs, kept=kept).results():
            program, number = divmod(index, len(plan))
            results[program, number] = programs[program].judged(plan[number], result)
    return [
        [results[program, number] for number in range(len(plan))] for program in range(len(sources))
    ]


def _limited(job: Job, seconds: float | None) -> Job:
    return job if seconds is None else replace(job, options=replace(job.options, seconds=seconds))


def _longest(opened: OpenLesson, step: int) -> float:
    """After how many seconds a program that still runs has failed a check, and so can be ended."""
    lesson_step = opened.step(step)
    ends = [check.within for check in lesson_step.check if isinstance(check, Ends) and check.within]
    return min([lesson_step.seconds, *(within + 0.5 for within in ends)])


def _only(runs: StepRuns, attempt: Attempt) -> JudgedRun:
    [(_, result)] = runs.results([attempt])
    return runs.judged(attempt, result)


def behaviour(trace: bytes) -> str:
    """What a run's trace shows of its behaviour, as a hash."""
    digest = hashlib.sha256()
    for text in trace.splitlines():
        line = msgspec.json.decode(text)
        if not any(kind in line for kind in _BEHAVIOUR):
            continue
        digest.update(text)
    return digest.hexdigest()


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
    plan = [run.attempt for run in right]
    seconds = _longest(opened, step)
    first = tried(opened, step, sources, plan[:1], kept, seconds=seconds)
    open_ = [
        number
        for number, [run] in enumerate(first)
        if is_done(run.verdicts) or behaviour(run.result.trace) == behaviour(right[0].result.trace)
    ]
    if plan[1:]:
        remaining = [sources[number] for number in open_]
        more = tried(opened, step, remaining, plan[1:], kept, seconds=seconds)
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
    plan = attempts(opened, step, robots=opened.robots(step)[:1])
    [right] = tried(opened, step, [opened.solution(step) or ""], plan, kept)
    expected = [behaviour(run.result.trace) for run in right]
    sources = [mutant.source for mutant in programs]
    for program, runs in zip(
        programs, tried_until_failed(opened, step, sources, right, kept), strict=True
    ):
        is_other = [behaviour(run.result.trace) for run in runs] != expected
        if is_other and all(is_done(run.verdicts) for run in runs):
            yield program
