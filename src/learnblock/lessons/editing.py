"""A lesson as its author edits it: the values of its files, and the mistakes by their places.

The values come from a page, so they are checked like the files of a lesson that comes from anyone.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import count
from pathlib import PurePosixPath
from types import MappingProxyType
from typing import Annotated, Any, Literal

import tomli_w
from msgspec import Meta, Struct, field, json, to_builtins
from msgspec.structs import replace

from learnblock import language
from learnblock.errors import FileError, LessonError
from learnblock.extensions import worlds
from learnblock.extensions.worlds import picture_name
from learnblock.i18n import ENGLISH, Phrase, languages, translate
from learnblock.lessons.examining import lesson_findings
from learnblock.lessons.lesson import VERSION, Lesson
from learnblock.lessons.opened import MAIN, TEACHER, OpenLesson, is_of_checks
from learnblock.lessons.reading import read_files
from learnblock.lessons.texts import Title, in_language
from learnblock.storage import toml_source
from learnblock.storage.struct_types import KeyPath

#: The limits of a program and of notes, in characters.
LONGEST_PROGRAM, LONGEST_NOTES = 60_000, 20_000
#: The limit of all programs together, in characters: reading them must not keep others waiting.
LONGEST_PROGRAMS = 120_000
MOST_STEPS = 30
#: The limit of the title of a copy, in characters, without the word "copy".
_LONGEST_COPIED = 180
#: The keys whose texts an author has to write, and the lists of such texts.
_TEXTS, _LISTS = frozenset({"title", "text", "question"}), frozenset({"aims"})

ProgramText = Annotated[str, Meta(max_length=LONGEST_PROGRAM)]


class WrittenProgram(Struct, frozen=True, omit_defaults=True):
    """A program.

    Args:
        text: its text.
        notation: what it is written in.
    """

    text: ProgramText
    notation: Literal["blocktext", "python"] = "blocktext"

    @property
    def ending(self) -> str:
        """What the name of its file ends in."""
        return "py" if self.notation == "python" else "bt"


class EditedStep(Struct, frozen=True, omit_defaults=True):
    """The programs of a step.

    Args:
        before: the number of the step in the saved lesson; 0 for a new step.
        program: what pupils begin with; None to go on with that of the step before.
        solution: the teacher's solution.
    """

    before: Annotated[int, Meta(ge=0, le=MOST_STEPS)] = 0
    program: WrittenProgram | None = None
    solution: WrittenProgram | None = None


class EditedLesson(Struct, frozen=True, omit_defaults=True):
    """A lesson that is being made or changed.

    Args:
        content: the values of ``lesson.toml``, without the files of the steps' programs.
        steps: the programs of the steps.
        lesson: the name of the saved lesson; empty for a new one.
        programs: other programs by the names of their files: those of puzzles and of partners.
        notes: the notes for the teacher, by language.
    """

    content: dict[str, Any]
    steps: Annotated[tuple[EditedStep, ...], Meta(max_length=MOST_STEPS)] = ()
    lesson: Annotated[str, Meta(pattern=r"^(?:\w[\w .-]{0,78}\w)?$")] = ""
    programs: Annotated[
        dict[Annotated[str, Meta(pattern=r"^[\w-]{1,60}\.(?:bt|py)$")], ProgramText],
        Meta(max_length=60),
    ] = field(default_factory=dict)
    notes: Annotated[
        dict[
            Annotated[str, Meta(pattern="^[a-z]{2,3}$")],
            Annotated[str, Meta(max_length=LONGEST_NOTES)],
        ],
        Meta(max_length=20),
    ] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Problem:
    """A mistake, and where it is: ``("step", 0, "solution")``."""

    path: KeyPath
    message: Phrase


@dataclass(frozen=True, slots=True)
class Examined:
    """What an edited lesson amounts to.

    Args:
        files: its files, without the main one.
        content: the values of the main one.
        problems: the mistakes; without any it can be packed.
        lesson: the lesson, unless the types of its values refuse them.
    """

    files: Mapping[str, bytes]
    content: Mapping[str, Any]
    problems: tuple[Problem, ...]
    lesson: Lesson | None = None


def edited_lesson(opened: OpenLesson) -> EditedLesson:
    """A lesson as its author edits it."""
    content = _plain(to_builtins(opened.lesson))
    for step in content["step"]:
        step.pop("program", None)
    programs = {path.name: opened.program(path.name) for path in _programs(opened)}
    named_files = {file for file, _ in _named_programs(content)}
    return EditedLesson(
        content=content,
        steps=tuple(
            EditedStep(
                number,
                _written(step.program, programs[step.program]) if step.program else None,
                _solution(opened, number),
            )
            for number, step in enumerate(opened.lesson.step, start=1)
        ),
        lesson=opened.name,
        programs={file: text for file, text in programs.items() if file in named_files},
        notes=notes_of(opened),
    )


def notes_of(opened: OpenLesson) -> dict[str, str]:
    """The notes for the teacher, in Markdown, by language.

    Raises:
        LessonError: they are not UTF-8.
    """
    paths = [path for path in opened.files if PurePosixPath(path).match("teacher/notes*.md")]
    return {(path.split(".")[1:-1] or [ENGLISH])[0]: opened.text(path) for path in paths}


def examine(edited: EditedLesson, name: str, saved: OpenLesson | None = None) -> Examined:
    """Find the mistakes of an edited lesson.

    Args:
        edited: the lesson.
        name: its name.
        saved: the saved one, whose pictures, worlds, checks in Python and wrong programs it keeps.
    """
    if message := _too_long(edited):
        return Examined({}, {}, (Problem((), message),))
    content, files = _content_and_files(edited, saved)
    blank = tuple(_blank_texts(content, ()))
    if blank:
        return Examined(files, content, blank)

    def check(lesson: Lesson) -> Iterator[toml_source.FileMistake]:
        yield from lesson_findings(OpenLesson(name, lesson, None, MappingProxyType(files)))

    try:
        lesson, findings = toml_source.examine(content, Lesson, check)
    except LessonError as error:
        # A program has mistakes; the error names its file.
        place = _place(error.filename, content)
        return Examined(files, content, (Problem(place, _located(error)),))
    problems = tuple(Problem(finding.path, finding.message) for finding in findings)
    return Examined(files, content, problems or tuple(_wrong_solutions(edited)), lesson)


def assemble(edited: EditedLesson, name: str, saved: OpenLesson | None = None) -> OpenLesson:
    """Make the files of an edited lesson, and read them as those of any other lesson.

    Args:
        edited: the lesson.
        name: its name.
        saved: the saved one, whose pictures, worlds, checks in Python and wrong programs it keeps.

    Raises:
        LessonError: it has mistakes.
    """
    content, files = _content_and_files(edited, saved)
    main = tomli_w.dumps(content, multiline_strings=True).encode()
    return read_files(name, {**files, MAIN: main})


def copied(opened: OpenLesson, name: str) -> OpenLesson:
    """A copy of a lesson with all its files, under a title that marks it as a copy.

    Args:
        opened: the lesson.
        name: the name of the copy.

    Raises:
        LessonError: it has mistakes.
    """
    edited = edited_lesson(opened)
    content = {**edited.content, "title": _copy_title(opened.lesson.title)}
    return assemble(replace(edited, content=content), name, opened)


def _copy_title(title: Title) -> dict[str, str]:
    codes = languages() if isinstance(title, str) else title
    texts = {code: in_language(title, code)[:_LONGEST_COPIED] for code in codes}
    return {
        code: translate(Phrase("lesson-copy-title", title=text), code)
        for code, text in texts.items()
    }


# From a lesson to what is edited.


def _plain(value: Any) -> Any:
    """Values without those that say nothing, such as None and empty lists."""
    if isinstance(value, dict):
        items = {key: _plain(item) for key, item in value.items()}
        return {key: item for key, item in items.items() if item is not None and item != []}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    return value


def _programs(opened: OpenLesson) -> list[PurePosixPath]:
    return [path for path in map(PurePosixPath, opened.files) if path.match("programs/*")]


def _named_programs(content: Mapping[str, Any]) -> Iterator[tuple[str, KeyPath]]:
    """The programs of puzzles and of partners, and where they are named."""
    for index, step in enumerate(_tables(content.get("step"))):
        for partner, table in enumerate(_tables(step.get("partners"))):
            yield str(table.get("program")), ("step", index, "partners", partner, "program")
        for puzzle in _tables([step.get("puzzle")]):
            yield str(puzzle.get("program")), ("step", index, "puzzle", "program")


def _tables(value: object) -> list[dict[str, Any]]:
    """The tables in a list; none if a page sent something else."""
    return [item for item in value if isinstance(item, dict)] if isinstance(value, list) else []


def _written(file: str, text: str) -> WrittenProgram:
    return WrittenProgram(text, "python" if file.endswith(".py") else "blocktext")


def _solution(opened: OpenLesson, number: int) -> WrittenProgram | None:
    text = opened.solution(number)
    if text is None or opened.teacher is None:
        return None
    return _written(opened.teacher.solutions[str(number)], text)


# From what is edited to the files of a lesson.


def _content_and_files(
    edited: EditedLesson, saved: OpenLesson | None
) -> tuple[dict[str, Any], dict[str, bytes]]:
    content = {**_plain(edited.content), "lesson": VERSION}
    named_files = {file for file, _ in _named_programs(content)}
    programs = {file: text for file, text in edited.programs.items() if file in named_files}
    files = {f"programs/{file}": text.encode() for file, text in programs.items()}
    files |= _kept(saved) if saved else {}
    files |= dict(_own_worlds(content))
    for index, step in enumerate(_tables(content.get("step"))):
        step.pop("program", None)
        program = edited.steps[index].program if index < len(edited.steps) else None
        if program is not None:
            step["program"] = _free_name(index + 1, program.ending, programs)
            files[f"programs/{step['program']}"] = program.text.encode()
    files |= _teachers_files(edited, saved)
    if saved and saved.lesson.evidence:
        content["evidence"] = _evidence(edited, saved)
    return content, files


def _kept(saved: OpenLesson) -> dict[str, bytes]:
    """The files of a saved lesson that are not edited."""
    folders = ("pictures/", "worlds/", "teacher/wrong/")
    return {
        path: data
        for path, data in saved.files.items()
        if path.startswith(folders) or is_of_checks(path)
    }


def _own_worlds(content: Mapping[str, Any]) -> Iterator[tuple[str, bytes]]:
    """The files of the user's own worlds that steps name: pupils don't have them."""
    names = {str(step.get("world")) for step in _tables(content.get("step"))}
    for name in sorted(names.intersection(worlds.own_names())):
        packed = worlds.find(name)
        yield f"worlds/{name}.toml", packed.text.encode()
        if packed.picture is not None:
            yield f"worlds/{picture_name(packed)}", packed.picture


def _free_name(number: int, ending: str, programs: Mapping[str, str]) -> str:
    names = (f"step-{number}{'-' * more}.{ending}" for more in count())
    return next(name for name in names if name not in programs)


def _teachers_files(edited: EditedLesson, saved: OpenLesson | None) -> dict[str, bytes]:
    files, solutions = {}, {}
    for number, step in enumerate(edited.steps, start=1):
        if step.solution is not None and step.solution.text.strip():
            solutions[str(number)] = file = f"step-{number}.{step.solution.ending}"
            files[f"teacher/solutions/{file}"] = step.solution.text.encode()
    for code, text in edited.notes.items():
        if text.strip():
            middle = "" if code == ENGLISH else f".{code}"
            files[f"teacher/notes{middle}.md"] = text.encode()
    teacher = {"solutions": solutions, "wrong": _wrong_programs(edited, saved)}
    files[TEACHER] = tomli_w.dumps({key: value for key, value in teacher.items() if value}).encode()
    return files


def _wrong_programs(edited: EditedLesson, saved: OpenLesson | None) -> list[dict[str, Any]]:
    """The wrong programs of a saved lesson, at the places to which its steps have moved."""
    if saved is None or saved.teacher is None:
        return []
    moved = _moved_steps(edited)
    wrong = [to_builtins(program) for program in saved.teacher.wrong]
    return [
        {**program, "step": moved[program["step"]]} for program in wrong if program["step"] in moved
    ]


def _evidence(edited: EditedLesson, saved: OpenLesson) -> list[dict[str, Any]]:
    """What shows the aims of a saved lesson, in the steps where it is now."""
    moved, aims = _moved_steps(edited), edited.content.get("aims")
    count = len(aims) if isinstance(aims, list) else 0
    moved_evidence = (
        (evidence, [moved[step] for step in evidence.steps if step in moved])
        for evidence in saved.lesson.evidence
        if evidence.aim <= count
    )
    return [
        _plain({**to_builtins(evidence), "steps": steps})
        for evidence, steps in moved_evidence
        if steps
    ]


def _moved_steps(edited: EditedLesson) -> dict[int, int]:
    """The numbers of the steps, by those that they had when the lesson was saved."""
    return {step.before: number for number, step in enumerate(edited.steps, 1) if step.before}


# Mistakes.


def _too_long(edited: EditedLesson) -> Phrase | None:
    """Parts that are too long to be examined."""
    size, limit = len(json.encode(edited.content)), toml_source.MAXIMUM_FILE_SIZE
    if size > limit:
        return Phrase("file-too-many-bytes", size=size, limit=limit)
    programs = [program for step in edited.steps for program in (step.program, step.solution)]
    length = sum(len(program.text) for program in programs if program) + sum(
        map(len, edited.programs.values())
    )
    if length > LONGEST_PROGRAMS:
        return Phrase("lesson-edit-too-long", length=length, limit=LONGEST_PROGRAMS)
    return None


def _blank_texts(value: object, path: KeyPath) -> Iterator[Problem]:
    """The places where a text is missing in all languages."""
    if isinstance(value, dict):
        for key, item in value.items():
            if (key in _TEXTS and _is_blank(item)) or (key in _LISTS and _has_blanks(item)):
                yield Problem((*path, key), Phrase("lesson-edit-no-text"))
            else:
                yield from _blank_texts(item, (*path, key))
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from _blank_texts(item, (*path, index))


def _is_blank(text: object) -> bool:
    return text in ({}, "")


def _has_blanks(texts: object) -> bool:
    return isinstance(texts, list) and any(map(_is_blank, texts))


def _place(filename: str, content: Mapping[str, Any]) -> KeyPath:
    """Where the author edits a file."""
    file = PurePosixPath(filename)
    for index, step in enumerate(_tables(content.get("step"))):
        if filename.endswith(f"/programs/{step.get('program')}"):
            return ("step", index, "program")
    for name, path in _named_programs(content):
        if filename.endswith(f"/programs/{name}"):
            return path
    for index, step in enumerate(_tables(content.get("step"))):
        if filename.endswith(f"/worlds/{step.get('world')}.toml"):
            return ("step", index, "world")
    return ("checks", file.name) if is_of_checks(file.name) else ()


def _located(error: FileError) -> Phrase:
    """The first mistake in a file, with its line."""
    first = error.diagnostics[0]
    if not first.line:
        return first.message
    return Phrase("lesson-edit-line", line=str(first.line), problem=first.message)


def _wrong_solutions(edited: EditedLesson) -> Iterator[Problem]:
    """The mistakes in solutions."""
    for index, step in enumerate(edited.steps):
        if step.solution is None or not step.solution.text.strip():
            continue
        notation = language.from_python if step.solution.ending == "py" else language.parse
        try:
            notation(step.solution.text, f"step-{index + 1}.{step.solution.ending}")
        except FileError as error:
            yield Problem(("step", index, "solution"), _located(error))
