"""What a user has done in each lesson, over all projects."""

from collections.abc import Iterable
from typing import Annotated

from msgspec import Meta, Struct, field
from msgspec.structs import replace

from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.lesson_folder import (
    MOST,
    LessonName,
    Number,
    Progress,
    Star,
    StepNumber,
)

#: The most lessons of which the work is given.
MOST_LESSONS = 300


class LessonWork(Struct, frozen=True, omit_defaults=True):
    """What a user has done in a lesson, in all projects.

    Args:
        lesson: its name.
        at: when it was last worked on, in seconds since 1970.
        step: the farthest step that was reached.
        stars: those earned, by the number of the step.
        runs: how often a program was run.
        hints: how many levels of hints were taken.
    """

    lesson: LessonName
    at: Annotated[float, Meta(ge=0)] = 0.0
    step: StepNumber = 1
    stars: Annotated[
        dict[
            Annotated[str, Meta(pattern="^[0-9]{1,2}$")],
            Annotated[tuple[Star, ...], Meta(max_length=20)],
        ],
        Meta(max_length=30),
    ] = field(default_factory=dict)
    runs: Number = 0
    hints: Number = 0

    def earned(self, step: int) -> frozenset[str]:
        """The stars that are earned in a step."""
        return frozenset(self.stars.get(str(step), ()))


def lesson_works(folder: ProjectFolder) -> tuple[LessonWork, ...]:
    """What has been done in each lesson; at most `MOST_LESSONS`, the last ones worked on."""
    works: dict[str, LessonWork] = {}
    for entry in folder.entries():
        progress = folder.lesson(entry.name).progress()
        if progress and (progress.lesson in works or len(works) < MOST_LESSONS):
            work = works.get(progress.lesson, LessonWork(progress.lesson))
            works[progress.lesson] = _with_project(work, progress, entry.changed)
    return tuple(works.values())


def _with_project(work: LessonWork, progress: Progress, at: float) -> LessonWork:
    steps = progress.steps
    stars = {
        number: _joined(work.stars.get(number, ()), done.stars) for number, done in steps.items()
    }
    return replace(
        work,
        at=max(work.at, at),
        step=max(work.step, progress.step),
        stars={**work.stars, **stars},
        runs=min(MOST, work.runs + sum(done.runs for done in steps.values())),
        hints=min(MOST, work.hints + sum(done.hints for done in steps.values())),
    )


def _joined(known: Iterable[str], more: Iterable[str]) -> tuple[str, ...]:
    return tuple(sorted({*known, *more}))
