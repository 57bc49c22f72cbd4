"""Lessons read from folders and files; nothing in them is run.

They may come from anyone, so their size, names and contents are limited.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

from learnblock.errors import LessonError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.lessons.archive import SUFFIX, folder_files, unzipped
from learnblock.lessons.examining import lesson_findings, teacher_findings
from learnblock.lessons.lesson import VERSION, Lesson, Teacher
from learnblock.lessons.opened import (
    MAIN,
    TEACHER,
    TEACHERS_FOLDER,
    OpenLesson,
    refuse,
    text_of,
)
from learnblock.lessons.own import own_files
from learnblock.storage import toml_source

__all__ = [
    "OpenLesson",
    "find_lesson",
    "for_pupils",
    "named_lesson",
    "open_lesson",
    "read_files",
    "shipped",
    "shipped_lesson",
    "unpack",
]


def open_lesson(path: Path) -> OpenLesson:
    """Read a lesson: a folder, or a file that ends in ``.lblesson``.

    Raises:
        LessonError: it is invalid; the error names the file in it, and every mistake found there.
        OSError: it cannot be read.
    """
    if path.is_dir():
        return read_files(path.resolve().name, folder_files(path))
    if path.suffix != SUFFIX:
        refuse(path.name, "unknown-file", Phrase("lesson-file-type", ending=SUFFIX))
    return unpack(path.name, path.read_bytes())


def unpack(filename: str, content: bytes) -> OpenLesson:
    """Read a lesson from the content of a file, such as an uploaded one.

    Raises:
        LessonError: as `open_lesson`.
    """
    return read_files(Path(filename).stem, unzipped(filename, content))


def read_files(name: str, files: Mapping[str, bytes]) -> OpenLesson:
    """Read a lesson from its files, by their paths inside.

    Raises:
        LessonError: as `open_lesson`.
    """
    if MAIN not in files:
        refuse(name, "no-lesson", Phrase("lesson-no-main-file", file=MAIN))
    contents = MappingProxyType(dict(files))

    def examine_lesson(lesson: Lesson) -> Iterable[toml_source.FileMistake]:
        return lesson_findings(OpenLesson(name, lesson, None, contents))

    def examine_teacher(teacher: Teacher) -> Iterable[toml_source.FileMistake]:
        return teacher_findings(opened, teacher)

    opened = OpenLesson(name, _parsed(name, contents, MAIN, Lesson, examine_lesson), None, contents)
    if TEACHER not in files:
        return opened
    return replace(opened, teacher=_parsed(name, contents, TEACHER, Teacher, examine_teacher))


def for_pupils(opened: OpenLesson) -> OpenLesson:
    """A lesson without what only the teacher has."""
    files = {
        path: content
        for path, content in opened.files.items()
        if not path.startswith(TEACHERS_FOLDER)
    }
    return replace(opened, teacher=None, files=MappingProxyType(files))


def shipped() -> tuple[str, ...]:
    """The names of the lessons that come with LearnBlock, by level and name."""
    return tuple(sorted(path.parent.name for path in shipped_folder().glob(f"*/{MAIN}")))


def shipped_lesson(name: str) -> OpenLesson:
    """Open a lesson that comes with LearnBlock, without the teacher's part.

    Our tests examine all that it names, so that is not done again: it takes ten times as long.

    Args:
        name: one of `shipped`.

    Raises:
        LessonError: it is invalid.
        OSError: it cannot be read.
    """
    files = MappingProxyType(dict(folder_files(shipped_folder() / name)))
    lesson = _parsed(name, files, MAIN, Lesson, lambda _: ())
    return for_pupils(OpenLesson(name, lesson, None, files))


def named_lesson(name: str) -> OpenLesson:
    """Open a lesson that comes with LearnBlock, or one of the user's own.

    Raises:
        UnknownNameError: there is no such lesson.
        LessonError: it is invalid.
        OSError: it cannot be read.
    """
    files = _named_files()
    if name not in files:
        raise UnknownNameError("lesson", name, files)
    return open_lesson(files[name])


def find_lesson(name_or_path: str) -> OpenLesson:
    """Open a lesson by its name, as `named_lesson`, or another one by its path.

    Raises:
        UnknownNameError: there is no such lesson.
        LessonError: it is invalid.
        OSError: it cannot be read.
    """
    path = Path(name_or_path)
    if name_or_path not in _named_files() and (path.is_dir() or path.is_file()):
        return open_lesson(path)
    return named_lesson(name_or_path)


def _named_files() -> dict[str, Path]:
    """By its name each lesson's folder or file: ours, then the user's."""
    ours = {name: shipped_folder() / name for name in shipped()}
    return ours | {file.stem: file for file in own_files() if file.stem not in ours}


def shipped_folder() -> Path:
    """Where the lessons that come with LearnBlock are."""
    # In the package in an installation, next to `src` in a checkout.
    folder = Path(__file__).parent / "shipped"
    return folder if folder.is_dir() else Path(__file__).parents[3] / "lessons"


def _parsed(
    name: str,
    files: Mapping[str, bytes],
    path: str,
    struct: type[toml_source.StructT],
    check: Callable[[toml_source.StructT], Iterable[toml_source.FileMistake]],
) -> toml_source.StructT:
    filename, source = f"{name}/{path}", text_of(name, files, path)
    if len(source) > toml_source.MAXIMUM_FILE_SIZE:
        limit = toml_source.MAXIMUM_FILE_SIZE
        refuse(filename, "too-large", Phrase("file-too-many-bytes", size=len(source), limit=limit))
    document = toml_source.parse(source, filename, LessonError)
    version = document.get("lesson")
    if path == MAIN and isinstance(version, int) and version > VERSION:
        refuse(filename, "newer", Phrase("lesson-newer", version=str(version)))
    return toml_source.convert(document, struct, LessonError, check, name=filename, source=source)
