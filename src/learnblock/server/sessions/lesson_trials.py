"""Tries programs of a lesson in the background, while the user keeps working."""

import asyncio
from collections.abc import Awaitable, Callable, Generator, Sequence
from contextlib import closing
from typing import Generic, TypeVar

from anyio import to_thread
from msgspec.structs import replace

from learnblock.errors import LearnBlockError, phrase_of
from learnblock.i18n import Phrase
from learnblock.lessons.checking import Follow, ProgramCheck, check_lesson, count_attempts
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.trying import Attempt, JudgedRun, StopSwitch, try_step
from learnblock.server import messages

Send = Callable[[messages.ToPage], object]
Progress = TypeVar("Progress", messages.LessonChecked, messages.LessonTried)


class _Trial(Generic[Progress]):
    """Programs that are tried in the background.

    Args:
        send: sends a message to the pages.
        progress: what was sent to them before the first trial.
    """

    def __init__(self, send: Send, progress: Progress) -> None:
        self._send = send
        self._task: asyncio.Task[None] | None = None
        self._switch = StopSwitch()
        #: The last message to the pages.
        self.progress: Progress = progress

    def stop(self) -> None:
        """Stop; runs that have not ended are ended at once."""
        self._switch.stop()

    def _begin(self, progress: Progress) -> None:
        if self.progress.running:
            raise LearnBlockError("server-lesson-checking")
        self._switch = StopSwitch()
        self._tell(progress)

    def _tell(self, progress: Progress) -> None:
        self.progress = progress
        self._send(progress)


class LessonCheck(_Trial[messages.LessonChecked]):
    """Checks a program on all variants of a step's world and on all its robots.

    Args:
        send: sends a message to the pages.
    """

    def __init__(self, send: Send) -> None:
        super().__init__(send, messages.LessonChecked())

    def start(
        self,
        opened: OpenLesson,
        step: int,
        program: messages.GivenProgram,
        attempts: Sequence[Attempt],
        on_passed: Callable[[], Awaitable[object]],
    ) -> None:
        """Begin to check a program.

        Args:
            opened: the lesson.
            step: the number of the step.
            program: the program, with the numbers of tags that it uses.
            attempts: the robots and variants.
            on_passed: called if it passes all.

        Raises:
            LearnBlockError: a check is already running.
        """
        waiting = tuple(
            messages.LessonAttempt(attempt.robot, attempt.variant) for attempt in attempts
        )
        self._begin(messages.LessonChecked(waiting, running=True))
        self._task = asyncio.create_task(self._run(opened, step, program, attempts, on_passed))

    def forget(self) -> None:
        """Forget what was checked."""
        self.progress = messages.LessonChecked()

    async def wait(self) -> None:
        """Wait until a check that was stopped has ended."""
        if self._task:
            await self._task

    async def _run(
        self,
        opened: OpenLesson,
        step: int,
        program: messages.GivenProgram,
        attempts: Sequence[Attempt],
        on_passed: Callable[[], Awaitable[object]],
    ) -> None:
        switch, loop = self._switch, asyncio.get_running_loop()

        def run() -> None:
            filename = "program.py" if program.is_python else "program.bt"
            runs = try_step(
                opened,
                step,
                program.text,
                attempts,
                filename=filename,
                tags=program.tags,
                switch=switch,
            )
            assert isinstance(runs, Generator)  # noqa: S101 - so that it can be given up
            with closing(runs):
                for judged in runs:
                    if switch.is_stopped:
                        break
                    loop.call_soon_threadsafe(self._judged, switch, judged)

        problem = None
        try:
            await to_thread.run_sync(run)
        except (LearnBlockError, OSError) as error:
            problem = phrase_of(error)
        if switch.is_stopped and self.progress.attempts == ():
            return
        # The results that the thread has handed over come first.
        await asyncio.sleep(0)
        everywhere = (
            all(attempt.passed for attempt in self.progress.attempts) and not switch.is_stopped
        )
        if everywhere:
            await on_passed()
        self._tell(replace(self.progress, running=False, everywhere=everywhere, problem=problem))

    def _judged(self, switch: StopSwitch, judged: JudgedRun) -> None:
        if switch.is_stopped:
            return
        wanted = (judged.attempt.robot, judged.attempt.variant)
        missed = [
            verdict
            for verdict in judged.verdicts
            if not verdict.check.optional and verdict.state != "met"
        ]
        reasons = tuple(
            verdict.explanation or Phrase("server-lesson-not-met") for verdict in missed
        )
        result = messages.LessonAttempt(*wanted, passed=not missed, reasons=reasons[:3])
        attempts = tuple(
            result if (attempt.robot, attempt.variant) == wanted else attempt
            for attempt in self.progress.attempts
        )
        self._tell(replace(self.progress, attempts=attempts))


class LessonTrial(_Trial[messages.LessonTried]):
    """The trial of a lesson's solutions, for one page.

    Args:
        send: sends a message to the page.
    """

    def __init__(self, send: Send) -> None:
        super().__init__(send, messages.LessonTried())

    def start(self, opened: OpenLesson) -> None:
        """Begin to try a lesson.

        Raises:
            LearnBlockError: a trial is already running.
        """
        self._begin(messages.LessonTried(count=count_attempts(opened), running=True))
        self._task = asyncio.create_task(self._run(opened))

    async def _run(self, opened: OpenLesson) -> None:
        switch, loop = self._switch, asyncio.get_running_loop()

        def watch(_: JudgedRun) -> None:
            loop.call_soon_threadsafe(self._attempted)

        def run() -> None:
            for result in check_lesson(opened, follow=Follow(watch, switch)):
                loop.call_soon_threadsafe(self._finished, result)

        problem = None
        try:
            await to_thread.run_sync(run)
        except (LearnBlockError, OSError) as error:
            # A run that is ended may be lost.
            problem = None if switch.is_stopped else phrase_of(error)
        # What the thread has handed over comes first.
        await asyncio.sleep(0)
        self._tell(replace(self.progress, running=False, problem=problem))

    def _attempted(self) -> None:
        self._tell(replace(self.progress, done=self.progress.done + 1))

    def _finished(self, result: ProgramCheck) -> None:
        program = messages.TriedProgram(
            result.kind, result.step, result.right, result.attempts, result.problems
        )
        self._tell(replace(self.progress, programs=(*self.progress.programs, program)))
