"""How far a project has come in its lesson, which is saved beside the project."""

from collections.abc import Callable, Sequence

from anyio import to_thread
from msgspec.structs import replace

from learnblock.lessons.lesson import Step
from learnblock.lessons.opened import OpenLesson
from learnblock.project.files.lesson_folder import MOST, LessonFolder, Progress, StepProgress
from learnblock.server import catalog


class KeptProgress:
    """The current step of a project's lesson, and what has been done in each step.

    Args:
        opened: the lesson.
        progress: the progress as it was saved last.
        folder: returns where it is saved; the project may be renamed.
    """

    def __init__(
        self, opened: OpenLesson, progress: Progress, folder: Callable[[], LessonFolder]
    ) -> None:
        self._opened = opened
        self._folder = folder
        #: The progress in all steps.
        self.whole = replace(progress, step=min(progress.step, len(opened.lesson.step)))

    @property
    def folder(self) -> LessonFolder:
        """Where it is saved, with the programs of the steps."""
        return self._folder()

    @property
    def number(self) -> int:
        """The number of the current step, from 1."""
        return self.whole.step

    @property
    def step(self) -> Step:
        """The current step."""
        return self._opened.step(self.number)

    @property
    def done(self) -> StepProgress:
        """What has been done in the current step."""
        return self.whole.of(self.number)

    def go_to(self, number: int) -> None:
        """Make another step the current one."""
        self.whole = replace(self.whole, step=number)

    async def earn(self, stars: Sequence[str]) -> int:
        """Earn stars of the current step, and save; return how many are new."""
        names = tuple(catalog.star_names(self.step))
        new = [star for star in stars if star in names and star not in self.done.stars]
        self._change(replace(self.done, stars=(*self.done.stars, *new)))
        await self.save()
        return len(new)

    async def count_hint(self) -> None:
        """Count a hint that was given, and save."""
        self._change(replace(self.done, hints=min(self.done.hints + 1, MOST)))
        await self.save()

    def count_run(self) -> None:
        """Count a run that has ended; it is saved with the stars that it has earned."""
        self._change(replace(self.done, runs=min(self.done.runs + 1, MOST)))

    async def count_try(self, star: str, *, right: bool) -> None:
        """Count an answer to a question of the current step, and save.

        Args:
            star: the star of the question.
            right: whether it is right, so that the star is earned.
        """
        self._change(replace(self.done, tries=min(self.done.tries + 1, MOST)))
        await self.earn((star,) if right else ())

    def choose(self, choices: Sequence[int]) -> None:
        """Note the choices of an answer to the quiz."""
        self._change(replace(self.done, quiz=tuple(sorted(choices))))

    async def save(self) -> None:
        """Save it."""
        await to_thread.run_sync(self.folder.keep_progress, self.whole)

    def _change(self, done: StepProgress) -> None:
        self.whole = self.whole.with_step(self.number, done)
