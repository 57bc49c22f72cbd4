"""Many programs tried in a step of a lesson, in one batch."""

import hashlib
from collections.abc import Iterable, Iterator, Sequence
from functools import cache

import msgspec

from learnblock.lessons.evidence import evidence_of
from learnblock.lessons.expert import Experts
from learnblock.lessons.judging import is_done, judge
from learnblock.lessons.mutants import Mutant
from learnblock.lessons.reading import OpenLesson, find_lesson
from learnblock.lessons.trying import Attempt, Trial, Tried, attempts, read_program, try_step
from learnblock.running.batch import Batch, WarmProcess

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
) -> list[list[Tried]]:
    """Try programs: the results of each, in the order of the attempts.

    Args:
        opened: the lesson.
        step: the number of the step.
        sources: the programs.
        wanted: the attempts of each.
        kept: a process that makes the runs, so that not every batch starts one.
    """
    if opened.step(step).partners:
        return [_in_order(try_step(opened, step, one, wanted), wanted) for one in sources]
    described, world = opened.step(step), opened.described_world(step)
    made: dict[tuple[int, int], Tried] = {}
    with opened.world_file(step) as file:
        trials = [Trial(opened, step, read_program(one), file) for one in sources]
        jobs = [trial.job(attempt) for trial in trials for attempt in wanted]
        for index, result in Batch(jobs, kept=kept).results():
            program, number = divmod(index, len(wanted))
            evidence = evidence_of(result.trace, result.report)
            tree = trials[program].source.tree
            verdicts = judge(described, tree, evidence, world, Experts(opened))
            made[program, number] = Tried(
                wanted[number], verdicts, evidence, result.report, result.trace
            )
    return [[made[one, two] for two in range(len(wanted))] for one in range(len(sources))]


def _in_order(found: Iterable[Tried], wanted: Sequence[Attempt]) -> list[Tried]:
    return sorted(found, key=lambda one: wanted.index(one.attempt))


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
    right: Sequence[Tried],
    kept: WarmProcess | None = None,
) -> list[list[Tried]]:
    """Try programs; one that fails in the first attempt, in another way, has no others.

    Args:
        opened: the lesson.
        step: the number of the step.
        sources: the programs.
        right: the attempts of the solution, which are those of the programs.
        kept: as of `tried`.
    """
    wanted = [one.attempt for one in right]
    first = tried(opened, step, sources, wanted[:1], kept)
    open_ = [
        number
        for number, [one] in enumerate(first)
        if is_done(one.verdicts) or behaviour(one.trace) == behaviour(right[0].trace)
    ]
    if wanted[1:]:
        more = tried(opened, step, [sources[number] for number in open_], wanted[1:], kept)
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
    expected = [behaviour(one.trace) for one in right]
    sources = [one.source for one in programs]
    for program, done in zip(
        programs, tried_until_failed(opened, step, sources, right, kept), strict=True
    ):
        is_other = [behaviour(one.trace) for one in done] != expected
        if is_other and all(is_done(one.verdicts) for one in done):
            yield program
