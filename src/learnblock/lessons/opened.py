"""A lesson that has been read."""

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import PurePosixPath
from typing import NoReturn

from learnblock import language
from learnblock.errors import Diagnostic, FileError, LessonError, UnknownNameError, WorldError
from learnblock.extensions.worlds.packed_world import PackedWorld, picture_name, staged
from learnblock.i18n import Phrase
from learnblock.language.tree.nodes import Program
from learnblock.lessons.lesson import Lesson, Step, Teacher
from learnblock.robots.simulated import find_world
from learnblock.simulator import WorldDescription, make_variant

#: Its main file, and the teacher's.
MAIN, TEACHER = "lesson.toml", "teacher/teacher.toml"
#: What pupils never get begins with it.
TEACHERS_FOLDER = "teacher/"
EXPERTS = "checks.py"
#: The files with the texts of its checks in Python, by language.
TEXTS_OF_CHECKS = re.compile(r"checks\.([a-z]{2,3})\.toml")
#: The name of the pupil's robot among several.
OWN_ROBOT = "robot"


@dataclass(frozen=True)
class OpenLesson:
    """A lesson that has been read.

    Args:
        name: the name of its folder or file.
        lesson: the content of its main file.
        teacher: what only the teacher has; None in a pupil's copy.
        files: its files, by their paths inside.
    """

    name: str
    lesson: Lesson
    teacher: Teacher | None
    files: Mapping[str, bytes] = field(repr=False)

    def step(self, number: int) -> Step:
        """A step by its number, from 1.

        Raises:
            UnknownNameError: there is no such step.
        """
        if not 1 <= number <= len(self.lesson.step):
            numbers = map(str, range(1, len(self.lesson.step) + 1))
            raise UnknownNameError("lesson-step", str(number), numbers)
        return self.lesson.step[number - 1]

    def text(self, path: str) -> str:
        """The text of a file.

        Raises:
            LessonError: it is missing or not UTF-8.
        """
        return text_of(self.name, self.files, path)

    def program(self, file: str) -> str:
        """The text of one of its programs.

        Raises:
            LessonError: it is missing or not UTF-8.
        """
        return self.text(f"programs/{file}")

    def solution(self, step: int) -> str | None:
        """The teacher's solution of a step; None if there is none."""
        file = self.teacher.solutions.get(str(step)) if self.teacher else None
        return None if file is None else self.text(f"teacher/solutions/{file}")

    def start(self, step: int) -> str | None:
        """The file of the program that a step starts with; None to go on with that of the pupil."""
        return self.step(step).program

    def group(self, step: int) -> int:
        """The step whose program a step continues: itself if it starts with one; 1 if none does."""
        return next((number for number in range(step, 0, -1) if self.start(number)), 1)

    def world(self, step: int) -> str | None:
        """The name of a step's world; without one of its own that of the step before."""
        worlds = (
            earlier.world
            for earlier in reversed(self.lesson.step[:step])
            if earlier.world is not None
        )
        return next(worlds, None)

    def robots(self, step: int) -> tuple[str, ...]:
        """The robots that a step is meant for, the usual one first."""
        return self.step(step).robots or self.lesson.robots

    def blocks(self, step: int) -> str | tuple[str, ...] | None:
        """The blocks shown in a step: a block set, or blocks; None for all blocks."""
        choices = (
            earlier.blocks
            for earlier in reversed(self.lesson.step[:step])
            if earlier.blocks is not None
        )
        return next(choices, None)

    @cached_property
    def own_worlds(self) -> frozenset[str]:
        """The names of its own worlds."""
        paths = map(PurePosixPath, self.files)
        return frozenset(p.stem for p in paths if p.match("worlds/*.toml"))

    def described_world(self, step: int) -> WorldDescription | None:
        """The world of a step; None if the robot's own is used.

        Raises:
            LessonError: it is one of the lesson's own, and invalid.
            UnknownNameError: there is no such world.
            WorldError: it is invalid.
        """
        name = self.world(step)
        if name is None:
            return None
        try:
            with self.world_file(step) as file:
                return find_world(file or name)
        except WorldError as error:
            if name not in self.own_worlds:
                raise
            where = f"{self.name}/worlds/{name}.toml"
            raise LessonError(where, error.diagnostics, error.source) from None

    def described_variant(self, step: int, variant: int) -> WorldDescription | None:
        """A variant of the world of a step; 0 is the world as it is drawn.

        Raises:
            LearnBlockError: as above, or there are no variants.
        """
        world = self.described_world(step)
        return make_variant(world, variant) if world and variant else world

    @contextmanager
    def world_file(self, step: int) -> Iterator[str | None]:
        """The world of a step as runs take it: the path of a temporary file, or a name."""
        name = self.world(step)
        if name not in self.own_worlds:
            yield name
            return
        assert name is not None  # noqa: S101 - it is among the names
        with staged(_packed_world(self, name)) as file:
            yield str(file)


def is_of_checks(path: str) -> bool:
    """Whether one of a lesson's files belongs to its checks in Python."""
    return path == EXPERTS or TEXTS_OF_CHECKS.fullmatch(path) is not None


def program_tree(opened: OpenLesson, path: str) -> Program:
    """A program of a lesson as a tree.

    Raises:
        LessonError: it is missing or cannot be parsed.
    """
    text = opened.text(path)
    notation = language.from_python if path.endswith(".py") else language.parse
    try:
        return notation(text, path)
    except FileError as error:
        raise LessonError(f"{opened.name}/{path}", error.diagnostics, text) from None


def _packed_world(opened: OpenLesson, name: str) -> PackedWorld:
    world = PackedWorld(name, opened.text(f"worlds/{name}.toml"))
    picture = picture_name(world)
    return replace(world, picture=opened.files.get(f"worlds/{picture}"))


def text_of(name: str, files: Mapping[str, bytes], path: str) -> str:
    """The text of one of a lesson's files.

    Raises:
        LessonError: it is missing or not UTF-8.
    """
    if path not in files:
        refuse(f"{name}/{path}", "missing-file", Phrase("lesson-missing-file", file=path))
    try:
        return files[path].decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        position = Phrase("file-not-utf-8", position=str(error.start))
        refuse(f"{name}/{path}", "not-utf-8", position)


def refuse(filename: str, code: str, message: Phrase) -> NoReturn:
    """Raise an error about a whole file."""
    raise LessonError(filename, [Diagnostic(code, message)])
