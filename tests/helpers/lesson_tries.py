"""Many programs tried in a step of a lesson, in one batch."""

from collections.abc import Iterable, Sequence

from learnblock.lessons.evidence import evidence_of
from learnblock.lessons.expert import Experts
from learnblock.lessons.judging import judge
from learnblock.lessons.reading import OpenLesson
from learnblock.lessons.trying import Attempt, Trial, Tried, read_program, try_step
from learnblock.running.batch import Batch, WarmProcess


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
        for result in Batch(jobs, kept=kept).results():
            program, number = divmod(result.job, len(wanted))
            evidence = evidence_of(result.trace, result.report)
            tree = trials[program].source.tree
            verdicts = judge(described, tree, evidence, world, Experts(opened))
            made[program, number] = Tried(
                wanted[number], verdicts, evidence, result.report, result.trace
            )
    return [[made[one, two] for two in range(len(wanted))] for one in range(len(sources))]


def _in_order(found: Iterable[Tried], wanted: Sequence[Attempt]) -> list[Tried]:
    return sorted(found, key=lambda one: wanted.index(one.attempt))
