"""Takes in the lessons that the teacher adds at the wall, and deletes them."""

import asyncio
from pathlib import PurePath

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from learnblock.classroom.answers import forbidden
from learnblock.classroom.badges import Visitors
from learnblock.classroom.offers import add_offer, remove_offer
from learnblock.classroom.room import Room
from learnblock.errors import LearnBlockError, phrase_of
from learnblock.i18n import Phrase
from learnblock.server.http.bodies import LongBodyError, body
from learnblock.server.http.refusal import refusal
from learnblock.server.messages import LARGEST_LESSON


class LessonUploads:
    """The endpoint of the teacher's lessons.

    Args:
        room: the class, whose walls then offer the lesson.
        visitors: recognises who sends a request.
    """

    def __init__(self, room: Room, visitors: Visitors) -> None:
        self._room = room
        self._visitors = visitors
        # Two files of one name would be written at the same time.
        self._turn = asyncio.Lock()

    async def add(self, request: Request) -> Response:
        """``lessons?filename=patrol.lblesson``, with the file as the body.

        The reply is the name of the lesson, or the phrase of what is wrong with the file.
        """
        if not self._visitors.is_teacher(request):
            return forbidden()
        filename = request.query_params.get("filename", "").replace("\\", "/")
        try:
            content = await body(request, LARGEST_LESSON)
            async with self._turn:
                name, self._room.offers = await asyncio.to_thread(
                    add_offer, PurePath(filename).stem, content
                )
        except LongBodyError:
            return refusal(Phrase("class-lesson-too-large", limit=LARGEST_LESSON // 1000))
        except (LearnBlockError, OSError) as error:
            return refusal(phrase_of(error))
        self._room.changed()
        return Response(msgspec.json.encode(name), media_type="application/json")

    async def delete(self, request: Request) -> Response:
        """``lessons?name=patrol``, for a lesson of the teacher's own.

        Pupils who have begun it keep what they have. The reply is the name, or why it is still
        there.
        """
        if not self._visitors.is_teacher(request):
            return forbidden()
        name = request.query_params.get("name", "")
        if name == self._room.roster.lesson:
            return refusal(Phrase("class-lesson-first"))
        try:
            async with self._turn:
                self._room.offers = await asyncio.to_thread(remove_offer, name)
        except (LearnBlockError, OSError) as error:
            return refusal(phrase_of(error))
        self._room.changed()
        return Response(msgspec.json.encode(name), media_type="application/json")
