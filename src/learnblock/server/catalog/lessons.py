"""The lessons that a project can follow: ours, and the user's own."""

import re
import unicodedata
from collections.abc import Iterator
from functools import cache, partial

from learnblock.errors import Diagnostic, FileError, LearnBlockError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.lessons import editing, packing, reading
from learnblock.lessons.archive import SUFFIX
from learnblock.lessons.lesson import Step
from learnblock.lessons.own import MOST_OWN, is_name, own_files, own_folder
from learnblock.lessons.reading import OpenLesson
from learnblock.lessons.texts import plain
from learnblock.server.messages import LARGEST_LESSON, LessonChoice
from learnblock.storage.files import is_device_name, save

_NOT_IN_NAMES = re.compile(r"[^\w]+")
_LONGEST_NEW = 60


def lesson_choices() -> tuple[tuple[LessonChoice, ...], tuple[Phrase, ...]]:
    """The lessons by level, ours and the user's, and the errors in those that can't be read."""
    choices, problems = [], []
    ours = ((name, False, partial(_shipped, name)) for name in reading.shipped())
    own = ((file.name, True, partial(reading.open_lesson, file)) for file in own_files())
    for name, is_own, read in (*ours, *own):
        try:
            choices.append(_choice(read(), own=is_own))
        except (LearnBlockError, OSError) as error:
            problem = error.phrase if isinstance(error, LearnBlockError) else str(error)
            problems.append(Phrase("server-lesson-file", name=name, problem=problem))
    return tuple(sorted(choices, key=lambda choice: choice.level)), tuple(problems)


def find_lesson(name: str) -> OpenLesson:
    """A lesson without what only the teacher has.

    Raises:
        UnknownNameError: there is no such lesson.
        LearnBlockError: its file is invalid.
    """
    if name in reading.shipped():
        return _shipped(name)
    return reading.for_pupils(find_own(name))


def find_own(name: str) -> OpenLesson:
    """A lesson of the user's, with everything that belongs to it.

    Raises:
        UnknownNameError: there is no such lesson.
        LearnBlockError: its file is invalid.
    """
    files = {file.stem: file for file in own_files()}
    if name not in files:
        raise UnknownNameError("lesson", name, [*reading.shipped(), *files])
    return reading.open_lesson(files[name])


def copy_lesson(name: str) -> OpenLesson:
    """Add a copy of a lesson to the user's.

    Raises:
        UnknownNameError: there is no such lesson.
        LearnBlockError: its file is invalid, or there are too many lessons.
        OSError: it can't be saved.
    """
    opened = reading.named_lesson(name)
    free = free_lesson_name(name)
    return add_lesson(free, packing.pack(editing.copied(opened, free)))


def add_lesson(name: str, content: bytes) -> OpenLesson:
    """Save a lesson's file in the user's folder, replacing one with this name.

    Raises:
        LearnBlockError: it isn't a lesson, or can't have this name.
        OSError: it can't be saved.
    """
    if not is_name(name) or name in reading.shipped():
        message = Phrase("server-lesson-name", name=name[:100])
        raise FileError(f"{name[:100]}{SUFFIX}", [Diagnostic("wrong-name", message)])
    folder, files = own_folder(), own_files()
    if len(files) >= MOST_OWN and folder / f"{name}{SUFFIX}" not in files:
        raise LearnBlockError("server-lesson-too-many", limit=MOST_OWN)
    folder.mkdir(parents=True, exist_ok=True)
    staged = folder / f".{name}{SUFFIX}"
    save(staged, content[:LARGEST_LESSON])
    try:
        opened = reading.open_lesson(staged)
        save(folder / f"{name}{SUFFIX}", packing.pack(opened))
    finally:
        staged.unlink(missing_ok=True)
    return reading.open_lesson(folder / f"{name}{SUFFIX}")


def take_lesson(name: str, content: bytes) -> None:
    """Save a lesson that the user has got in a class, unless the user has made it.

    Raises:
        LearnBlockError: as `add_lesson`.
        OSError: it can't be saved.
    """
    given = reading.unpack(f"{name}{SUFFIX}", content)
    if not _is_made_here(name):
        add_lesson(name, packing.pack(reading.for_pupils(given)))


def _is_made_here(name: str) -> bool:
    """Whether a lesson of this name has a teacher's part, which no pupil gets."""
    try:
        return find_own(name).teacher is not None
    except (LearnBlockError, OSError):
        # It is not there yet, or damaged, and then replaced.
        return False


def free_lesson_name(title: str) -> str:
    """A name for a new lesson of the user's, made of its title; no other lesson has it."""
    stem = _NOT_IN_NAMES.sub("-", unicodedata.normalize("NFC", title).lower()).strip("-")
    stem = stem[:_LONGEST_NEW].strip("-")
    if len(stem) < 2 or is_device_name(stem):
        stem = f"lesson-{stem}".strip("-")
    taken = {name.casefold() for name in (*reading.shipped(), *(f.stem for f in own_files()))}
    names = (stem, *(f"{stem}-{number}" for number in range(2, MOST_OWN + 2)))
    return next(name for name in names if name.casefold() not in taken)


def delete_lesson(name: str) -> None:
    """Delete a lesson of the user's.

    Raises:
        UnknownNameError: there is no such lesson.
        OSError: it can't be deleted.
    """
    if name not in {file.stem for file in own_files()}:
        raise UnknownNameError("lesson", name, [file.stem for file in own_files()])
    (own_folder() / f"{name}{SUFFIX}").unlink()


def star_names(step: Step) -> Iterator[str]:
    """The stars to be earned in a step; see `learnblock.project.files.lesson_folder`."""
    if any(not check.optional for check in step.check):
        yield "goals"
        if step.variants:
            yield "everywhere"
    yield from (f"check-{index}" for index, check in enumerate(step.check) if check.optional)
    if step.quiz:
        yield "quiz"
    if step.puzzle:
        yield "puzzle"


@cache
def _shipped(name: str) -> OpenLesson:
    return reading.shipped_lesson(name)


def step_titles(name: str) -> tuple[str | dict[str, str], ...]:
    """The titles of a lesson's steps.

    Raises:
        UnknownNameError: there is no such lesson.
        LearnBlockError: its file is invalid.
    """
    return tuple(plain(step.title) for step in find_lesson(name).lesson.step)


def _choice(opened: OpenLesson, *, own: bool = False) -> LessonChoice:
    lesson = opened.lesson
    return LessonChoice(
        name=opened.name,
        title=plain(lesson.title),
        level=lesson.level,
        minutes=lesson.minutes,
        aims=tuple(map(plain, lesson.aims)),
        robots=lesson.robots,
        steps=len(lesson.step),
        stars=sum(len(list(star_names(step))) for step in lesson.step),
        picture=lesson.picture or "",
        own=own,
    )
