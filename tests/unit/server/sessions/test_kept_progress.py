"""How far a project has come in its lesson is kept, and each star earned once."""

import asyncio

from msgspec.structs import replace

from learnblock.lessons.checks import Drives, Ends
from learnblock.lessons.opened import OpenLesson
from learnblock.project.files.lesson_folder import EVERYWHERE, GOALS, LessonFolder, Progress
from learnblock.server.sessions.kept_progress import KeptProgress
from lesson_files import LESSON, STEP


def kept(tmp_path, *steps, progress=None):
    opened = OpenLesson("small", replace(LESSON, step=steps), None, {})
    folder = LessonFolder("square", tmp_path)
    return KeptProgress(opened, progress or Progress("small"), lambda: folder), folder


CHECKED = replace(STEP, check=(Drives(at_least=100), Ends(optional=True)))


def test_a_star_of_the_step_is_earned_once_and_saved(tmp_path):
    progress, folder = kept(tmp_path, CHECKED)

    async def earn():
        return [await progress.earn((GOALS, "check-1", EVERYWHERE)) for _ in range(2)]

    # The step has no variants, so there is no star for them.
    assert asyncio.run(earn()) == [2, 0]
    assert progress.done.stars == (GOALS, "check-1")
    assert folder.progress() == progress.whole


def test_answers_are_counted_in_their_step_only(tmp_path):
    progress, folder = kept(tmp_path, CHECKED, CHECKED)
    progress.go_to(2)
    asyncio.run(progress.count_try(GOALS, right=False))
    asyncio.run(progress.count_hint())
    assert (progress.done.tries, progress.done.hints, progress.done.stars) == (1, 1, ())
    assert (progress.whole.of(1).tries, folder.progress().step) == (0, 2)


def test_a_lesson_that_has_lost_steps_goes_on_at_its_last_one(tmp_path):
    progress, _ = kept(tmp_path, CHECKED, progress=Progress("small", step=7))
    assert (progress.number, progress.step) == (1, CHECKED)
