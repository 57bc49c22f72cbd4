"""The lessons that a class can be handed, and how pupils get one of the teacher's own."""

from collections.abc import Iterable
from pathlib import Path

from learnblock.classroom.messages import LessonOffer
from learnblock.classroom.pupil_folder import HOME
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons import packing, reading
from learnblock.lessons.archive import SUFFIX
from learnblock.lessons.own import FOLDER
from learnblock.server.catalog.lessons import (
    add_lesson,
    delete_lesson,
    find_own,
    lesson_choices,
    step_titles,
)
from learnblock.server.messages import LARGEST_LESSON, GiveLesson, LessonChoice
from learnblock.storage.files import save


def lesson_offers() -> tuple[tuple[LessonOffer, ...], tuple[Phrase, ...]]:
    """All lessons by level, and the errors in those that can't be read."""
    choices, problems = lesson_choices()
    return tuple(map(_offer, choices)), problems


def add_offer(name: str, content: bytes) -> tuple[str, tuple[LessonOffer, ...]]:
    """Add a lesson's file to the teacher's own; return its name, and all lessons.

    Raises:
        LearnBlockError: it isn't a lesson, or can't have this name.
        OSError: it can't be saved.
    """
    added = add_lesson(name, content)
    offers, _ = lesson_offers()
    return added.name, offers


def remove_offer(name: str) -> tuple[LessonOffer, ...]:
    """Delete one of the teacher's own lessons; return those that are left.

    Raises:
        UnknownNameError: there is no such lesson.
        OSError: it can't be deleted.
    """
    delete_lesson(name)
    offers, _ = lesson_offers()
    return offers


def give_lesson(name: str, folders: Iterable[Path]) -> None:
    """Put one of the teacher's own lessons into pupils' folders, without the teacher's part.

    Raises:
        LearnBlockError: it can't be read.
        OSError: it can't be saved.
    """
    content = _packed(name)
    for folder in folders:
        lessons = folder / HOME / FOLDER
        lessons.mkdir(parents=True, exist_ok=True)
        save(lessons / f"{name}{SUFFIX}", content)


def lesson_gift(name: str) -> GiveLesson:
    """The message that puts one of the teacher's own lessons into a pupil's folder at a hub.

    Raises:
        LearnBlockError: it can't be read, or is too large for a message.
    """
    content = _packed(name)
    if len(content) > LARGEST_LESSON:
        raise LearnBlockError("class-lesson-too-large", limit=LARGEST_LESSON // 1000)
    return GiveLesson(name, content)


def _packed(name: str) -> bytes:
    """One of the teacher's own lessons as a file, without the teacher's part."""
    return packing.pack(reading.for_pupils(find_own(name)))


def _offer(choice: LessonChoice) -> LessonOffer:
    return LessonOffer(
        choice.name,
        choice.title,
        choice.level,
        choice.minutes,
        choice.robots,
        step_titles(choice.name),
        choice.picture,
        choice.own,
    )
