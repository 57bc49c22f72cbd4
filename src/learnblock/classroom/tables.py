"""Answers requests for what the checks found, and for marks: only the teacher's."""

import asyncio
import tempfile
from collections.abc import Callable
from functools import partial
from http import HTTPStatus
from pathlib import Path

import msgspec
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response

from learnblock.classroom.badges import Visitors
from learnblock.classroom.checking import runs_folder
from learnblock.classroom.collecting import plan_of
from learnblock.classroom.marks import marks, marks_for_moodle
from learnblock.classroom.room import Room
from learnblock.errors import LearnBlockError, phrase_of
from learnblock.i18n import ENGLISH, languages, translate
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.journal import opened_journal
from learnblock.lessons.grading.output import PAGE, TABLE, write_results
from learnblock.project.files.lesson_folder import LessonName, StepNumber
from learnblock.server.http import static_files
from learnblock.storage.learned_types import learned


class WantedStep(msgspec.Struct, frozen=True):
    """The step of which a table is wanted.

    Args:
        lesson: the name of the lesson.
        step: the number of the step.
        language: of the page.
        platform: for which the marks are written; empty for a spreadsheet.
    """

    lesson: LessonName
    step: StepNumber
    language: str = ENGLISH
    platform: str = ""


class Tables:
    """The tables of a class.

    Args:
        room: the class.
        visitors: recognises who sends a request.
    """

    def __init__(self, room: Room, visitors: Visitors) -> None:
        self._room = room
        self._visitors = visitors

    async def results(self, request: Request) -> Response:
        """The table that `learnblock grade` writes, with the same bytes."""
        return await self._answer(request, partial(self._graded, TABLE), "text/csv", TABLE)

    async def page(self, request: Request) -> Response:
        """The page that `learnblock grade` writes."""
        return await self._answer(request, partial(self._graded, PAGE), "text/html")

    async def marks(self, request: Request) -> Response:
        """The teacher's marks."""
        return await self._answer(request, self._marks, "text/csv", "marks.csv")

    async def _answer(
        self,
        request: Request,
        write: Callable[[WantedStep], bytes],
        media_type: str,
        name: str = "",
    ) -> Response:
        if not self._visitors.is_teacher(request):
            return static_files.no_token()
        headers = {"cache-control": "no-store"}
        if name:
            headers["content-disposition"] = f'attachment; filename="{name}"'
        language = request.query_params.get("language", ENGLISH)
        try:
            wanted = msgspec.convert(dict(request.query_params), learned(WantedStep), strict=False)
            content = await asyncio.to_thread(write, wanted)
        except (LearnBlockError, OSError, ValueError) as error:
            sentence = translate(phrase_of(error), _known(language))
            return PlainTextResponse(f"{sentence}\n", HTTPStatus.BAD_REQUEST)
        return Response(content, media_type=media_type, headers=headers)

    def _graded(self, name: str, wanted: WantedStep) -> bytes:
        roster = self._room.roster
        plan = plan_of(roster, wanted.lesson, wanted.step)
        with (
            opened_journal(runs_folder(roster.folder, wanted.lesson, wanted.step)) as journal,
            tempfile.TemporaryDirectory() as out,
        ):
            grading = Grading(plan, journal)
            write_results(grading, Path(out), _known(wanted.language), lesson=wanted.lesson)
            return (Path(out) / name).read_bytes()

    def _marks(self, wanted: WantedStep) -> bytes:
        marking, place = self._room.marking, (wanted.lesson, wanted.step)
        if wanted.platform == "moodle":
            return marks_for_moodle(marking, *place, _known(wanted.language))
        return marks(marking, *place)


def _known(language: str) -> str:
    return language if language in languages() else ENGLISH
