"""Tries the solutions of a lesson that a teacher edits, in the background."""

import asyncio
from collections.abc import Callable

from anyio import to_thread
from msgspec.structs import replace

from learnblock.errors import LearnBlockError
from learnblock.lessons.checking import Follow, Result, check_lesson, count_attempts
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.trying import StopSwitch, Tried
from learnblock.server import messages
from learnblock.server.messages.problems import phrase_of


class LessonTrial:
    """The trial of a lesson's solutions, for one page.

    Args:
        send: sends a message to the page.
    """

    def __init__(self, send: Callable[[messages.ToPage], object]) -> None:
        self._send = send
        self._task: asyncio.Task[None] | None = None
        self._switch = StopSwitch()
        self._told = messages.LessonTried()

    def start(self, opened: OpenLesson) -> None:
        """Begin to try a lesson.

        Raises:
            LearnBlockError: a trial goes on.
        """
        if self._told.running:
            raise LearnBlockError("server-lesson-checking")
        self._switch = StopSwitch()
        self._tell(messages.LessonTried(count=count_attempts(opened), running=True))
        self._task = asyncio.create_task(self._run(opened))

    def stop(self) -> None:
        """Stop; the runs that go on are ended."""
        self._switch.stop()

    async def _run(self, opened: OpenLesson) -> None:
        switch, loop = self._switch, asyncio.get_running_loop()

        def watch(_: Tried) -> None:
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
        self._tell(replace(self._told, running=False, problem=problem))

    def _attempted(self) -> None:
        self._tell(replace(self._told, done=self._told.done + 1))

    def _finished(self, result: Result) -> None:
        program = messages.TriedProgram(
            result.kind, result.step, result.right, result.attempts, result.problems
        )
        self._tell(replace(self._told, programs=(*self._told.programs, program)))

    def _tell(self, told: messages.LessonTried) -> None:
        self._told = told
        self._send(told)
