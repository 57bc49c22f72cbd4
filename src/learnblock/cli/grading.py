"""A grading on the command line: what was handed in, a progress bar, and where the results are."""

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import click

from learnblock import robots as known_robots
from learnblock.cli.console import say, text, usage_error, warn
from learnblock.cli.interrupts import stopped_by_signals
from learnblock.cli.language import language
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.grading.executors import OpenWorkers, cluster, local
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.handed_in import read_all
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.output import write_results
from learnblock.lessons.grading.plan import last_with_checks, planned
from learnblock.lessons.grading.values import HandedIn
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.reading import find_lesson
from learnblock.running.batch import processors

#: The folder in that of the results for the programs in zips.
HANDED_IN = "handed-in"


@dataclass(frozen=True, slots=True)
class Choices:
    """What the teacher chooses; None leaves the choice to the lesson or to this computer.

    Args:
        lesson: the name or path of the lesson.
        step: the number of the step.
        variants: the number of variants.
        robots: the names of the robots.
        jobs: how many runs are made at once.
        scheduler: the address of a Dask cluster.
        class_name: the class whose programs are graded; None if files are.
        only_handed_in: whether pupils of the class who have not handed in are left ungraded.
        out: the folder for the results.
    """

    lesson: str
    step: int | None
    variants: int | None
    robots: tuple[str, ...] | None
    jobs: int | None
    scheduler: str | None
    class_name: str | None
    only_handed_in: bool
    out: Path


def grade(handed_in: Sequence[Path], choices: Choices) -> bool:
    """Grade, write and report the results, and return whether everything is finished."""
    opened_lesson = find_lesson(choices.lesson)
    step = choices.step or last_with_checks(opened_lesson)
    for name in choices.robots or ():
        _check_simulated(name)
    plan = planned(
        opened_lesson,
        step,
        _handed_in(handed_in, choices, opened_lesson, step),
        robots=choices.robots,
        variants=choices.variants,
    )
    if not plan.handed_in:
        raise usage_error("grade-nothing-handed-in")
    with opened_journal(choices.out) as journal:
        grading = Grading(plan, journal)
        try:
            with stopped_by_signals(grading.stop):
                _show(grading, _workers(choices))
        finally:
            # Also of what was made until the workers were lost.
            write_results(grading, choices.out, language(), lesson=choices.lesson)
            say("grade-written", file=str(choices.out / "results.html"), err=True)
    return _say_what_is_missing(grading)


def _say_what_is_missing(grading: Grading) -> bool:
    """Say what is missing; return whether nothing is."""
    if failures := grading.failures:
        reason = text(failures[0])
        say("grade-not-made", count=len(failures), reason=reason, err=True)
    if grading.is_stopped:
        say("grade-stopped", err=True)
    return not failures and not grading.is_stopped


def _show(grading: Grading, workers: OpenWorkers) -> None:
    """Make everything, with a bar that shows the remaining time."""
    progress_bar: Any = click.progressbar(
        length=1,
        label=text(Phrase("grade-running")),
        show_pos=True,
        file=sys.stderr,
    )
    with progress_bar as bar:
        for progress in grading.run(workers):
            bar.length = progress.total
            bar.update(progress.done - bar.pos)


def _workers(choices: Choices) -> OpenWorkers:
    if choices.scheduler:
        return partial(cluster, choices.scheduler)
    return partial(local, choices.jobs or processors())


def _check_simulated(name: str) -> None:
    if not known_robots.find(name).load().lockstep:
        raise LearnBlockError("grade-real-robot", robot=name)


def _handed_in(
    paths: Sequence[Path], choices: Choices, opened_lesson: OpenLesson, step: int
) -> Iterator[HandedIn]:
    """What was handed in as files, or by the pupils of a class.

    Raises:
        LearnBlockError: there is no such class, or a file can't be read.
    """
    if choices.class_name:
        # The command line needs none of it otherwise.
        from learnblock.classroom.collecting import collect  # noqa: PLC0415
        from learnblock.classroom.roster import known_class  # noqa: PLC0415

        roster = known_class(choices.class_name)
        return collect(roster, opened_lesson, step, only_handed_in=choices.only_handed_in)
    return read_all(paths, choices.out / HANDED_IN, warn)
