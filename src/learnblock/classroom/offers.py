"""The lessons that a class can be handed, and how pupils get one of the teacher's own."""

from collections.abc import Iterable
from pathlib import Path

from learnblock.classroom.messages import LessonOffer
from learnblock.classroom.pupil_folder import HOME
from learnblock.i18n import Phrase
from learnblock.lessons import packing, reading
from learnblock.lessons.archive import SUFFIX
from learnblock.lessons.own import FOLDER
from learnblock.server.catalog.lessons import find_own, lesson_choices, step_titles
from learnblock.server.messages import LessonChoice
from learnblock.storage.files import save


def lesson_offers() -> tuple[tuple[LessonOffer, ...], tuple[Phrase, ...]]:
    """All lessons by level, and the errors in those that can't be read."""
    choices, problems = lesson_choices()
    return tuple(map(_offer, choices)), problems


def give_lesson(name: str, folders: Iterable[Path]) -> None:
    """Put one of the teacher's own lessons into pupils' folders, without the teacher's part.

    Raises:
        LearnBlockError: it can't be read.
        OSError: it can't be saved.
    """
    content = packing.pack(reading.for_pupils(find_own(name)))
    for folder in folders:
        lessons = folder / HOME / FOLDER
        lessons.mkdir(parents=True, exist_ok=True)
        save(lessons / f"{name}{SUFFIX}", content)


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
