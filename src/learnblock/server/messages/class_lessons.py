"""What the class and a pupil's server at a hub tell each other about lessons.

At a hub neither reaches the files of the other.
"""

from typing import Annotated

from msgspec import Meta

from learnblock.project.files.lesson_folder import LessonName
from learnblock.project.files.lesson_work import MOST_LESSONS, LessonWork
from learnblock.server.messages.base import ForClass, FromReader, ToClass
from learnblock.server.messages.lessons import LARGEST_LESSON


class GiveLesson(ForClass, frozen=True):
    """Put a lesson of the teacher's own into the pupil's folder.

    Args:
        lesson: its name.
        content: its file in base64, without the teacher's part.
    """

    lesson: LessonName
    content: Annotated[bytes, Meta(max_length=LARGEST_LESSON)]


class ReadLessonWork(ForClass, FromReader, frozen=True):
    """Ask for `LessonWorkRead`."""


class LessonWorkRead(ToClass, frozen=True):
    """What the pupil has done in each lesson; the class keeps it."""

    works: Annotated[tuple[LessonWork, ...], Meta(max_length=MOST_LESSONS)] = ()
