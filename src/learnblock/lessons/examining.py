"""Mistakes in a lesson that its types can't express: everything that it names has to exist."""

import ast
import re
from collections.abc import Collection, Iterable, Iterator
from itertools import islice

from learnblock import language, robots
from learnblock.blocks import block_sets
from learnblock.blocks.known import all_configurations
from learnblock.errors import Diagnostic, FileError, LessonError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.lessons.check_texts import own_texts
from learnblock.lessons.checks import (
    Called,
    Check,
    Event,
    Expert,
    GoalReached,
    Happens,
    InOrder,
    Never,
    Reaches,
    StaysOnLine,
    Uses,
)
from learnblock.lessons.lesson import Lesson, Step, Teacher
from learnblock.lessons.opened import EXPERTS, OWN_ROBOT, OpenLesson, program_tree
from learnblock.lessons.puzzles import has_same_pieces, pieces
from learnblock.lessons.texts import MOST_DRAWINGS, drawn_blocks
from learnblock.robots.simulated import known_worlds
from learnblock.simulator import WorldDescription
from learnblock.storage.struct_types import KeyPath
from learnblock.storage.toml_source import FileMistake

_PICTURE = re.compile(r"!\[[^\[\]\n]{0,200}\]\(([^)\s]{1,200})\)")


def lesson_findings(opened: OpenLesson) -> Iterator[FileMistake]:
    """The mistakes in a lesson's main file.

    Raises:
        LessonError: one of its other files has mistakes.
    """
    lesson = opened.lesson
    yield from _unknown_robots(("robots",), lesson.robots)
    if lesson.picture is not None:
        yield from _missing(opened, ("picture",), f"pictures/{lesson.picture}")
    yield from _evidence(lesson)
    for number, step in enumerate(lesson.step, start=1):
        for finding in _StepExamination(opened, number, step).findings():
            yield FileMistake(("step", number - 1, *finding.path), finding.code, finding.message)
    _check_programs(opened, "programs/")
    _check_experts(opened)


def _evidence(lesson: Lesson) -> Iterator[FileMistake]:
    for index, evidence in enumerate(lesson.evidence):
        if evidence.aim > len(lesson.aims):
            aims = map(str, range(1, len(lesson.aims) + 1))
            yield _unknown(("evidence", index, "aim"), "lesson-aim", str(evidence.aim), aims)
        for place, step in enumerate(evidence.steps):
            if step > len(lesson.step):
                path: KeyPath = ("evidence", index, "steps", place)
                steps = map(str, range(1, len(lesson.step) + 1))
                yield _unknown(path, "lesson-step", str(step), steps)


def teacher_findings(opened: OpenLesson, teacher: Teacher) -> Iterator[FileMistake]:
    """The mistakes in the teacher's file.

    Raises:
        LessonError: one of the teacher's programs has mistakes.
    """
    steps = opened.lesson.step
    for number, file in teacher.solutions.items():
        path: KeyPath = ("solutions", number)
        if not 1 <= int(number) <= len(steps):
            yield _unknown(path, "lesson-step", number, map(str, range(1, len(steps) + 1)))
        yield from _missing(opened, path, f"teacher/solutions/{file}")
    for index, wrong in enumerate(teacher.wrong):
        yield from _missing(opened, ("wrong", index, "program"), f"teacher/wrong/{wrong.program}")
        if wrong.step > len(steps):
            numbers = map(str, range(1, len(steps) + 1))
            yield _unknown(("wrong", index, "step"), "lesson-step", str(wrong.step), numbers)
            continue
        step = steps[wrong.step - 1]
        if wrong.check not in check_names(step):
            yield _unknown(("wrong", index, "check"), "check", wrong.check, check_names(step))
        own = {f"teacher-{number}" for number in range(1, len(step.hint) + 1)}
        if wrong.hint.startswith("teacher") and wrong.hint not in own:
            yield _unknown(("wrong", index, "hint"), "hint", wrong.hint, sorted(own))
    _check_programs(opened, "teacher/")


def check_names(step: Step) -> Collection[str]:
    """What hints call the checks of a step: their names, and their kinds."""
    kinds = (type(check).__struct_config__.tag for check in step.check)
    names = (check.name for check in step.check if check.name is not None)
    return dict.fromkeys([*names, *map(str, kinds)])


class _StepExamination:
    """The examination of one step; the paths of its findings begin in the step."""

    def __init__(self, opened: OpenLesson, number: int, step: Step) -> None:
        self._opened, self._number, self._step = opened, number, step

    def findings(self) -> Iterator[FileMistake]:
        step = self._step
        for path, file in self._files():
            yield from _missing(self._opened, path, file)
        yield from _unknown_robots(("robots",), step.robots)
        yield from self._partners()
        yield from self._blocks()
        yield from self._texts()
        yield from self._puzzle()
        yield from self._world_and_checks()
        names = check_names(step)
        for index, rule in enumerate(step.hint):
            if rule.check is not None and rule.check not in names:
                yield _unknown(("hint", index, "check"), "check", rule.check, names)

    def _files(self) -> Iterator[tuple[KeyPath, str]]:
        if self._step.program is not None:
            yield ("program",), f"programs/{self._step.program}"
        if self._step.puzzle is not None:
            yield ("puzzle", "program"), f"programs/{self._step.puzzle.program}"
        for index, partner in enumerate(self._step.partners):
            yield ("partners", index, "program"), f"programs/{partner.program}"

    def _partners(self) -> Iterator[FileMistake]:
        names = [OWN_ROBOT]
        for index, partner in enumerate(self._step.partners):
            yield from _unknown_robots(("partners", index, "robot"), (partner.robot,))
            if partner.name in names:
                message = Phrase("lesson-partner-name", name=partner.name)
                yield FileMistake(("partners", index, "name"), "name-taken", message)
            names.append(partner.name)

    def _blocks(self) -> Iterator[FileMistake]:
        blocks = self._step.blocks
        if isinstance(blocks, str):
            names = [*block_sets.BUILT_IN, *(block_set.name for block_set in block_sets.own()[0])]
            if blocks not in names:
                yield _unknown(("blocks",), "block-set", blocks, names)
            return
        skills = all_configurations()
        for index, block in enumerate(blocks or ()):
            prefix, _, skill = block.rpartition("function.")
            # Other blocks are those of the language, or categories.
            if not prefix and block.startswith("function.") and skill not in skills:
                yield _unknown(("blocks", index), "skill", skill, skills)

    def _texts(self) -> Iterator[FileMistake]:
        text = self._step.text
        for translation in [text] if isinstance(text, str) else text.values():
            for picture in _PICTURE.findall(translation):
                yield from _missing(self._opened, ("text",), f"pictures/{picture}")
        texts = [text] if isinstance(text, str) else text.values()
        drawings = dict.fromkeys(
            blocks for translation in texts for blocks in drawn_blocks(translation)
        )
        # The page draws no more of a step.
        for blocks in islice(drawings, MOST_DRAWINGS):
            yield from _unreadable(blocks)

    def _puzzle(self) -> Iterator[FileMistake]:
        puzzle = self._step.puzzle
        if puzzle is None or f"programs/{puzzle.program}" not in self._opened.files:
            return
        right = pieces(self._opened.program(puzzle.program))
        for index, source in enumerate(puzzle.also):
            path: KeyPath = ("puzzle", "also", index)
            try:
                language.parse(source, "also")
            except FileError as error:
                problem = Phrase("lesson-puzzle-program", problem=error.phrase)
                yield FileMistake(path, "wrong-program", problem)
                continue
            if not has_same_pieces(pieces(source), right):
                message = Phrase("lesson-puzzle-pieces", file=puzzle.program)
                yield FileMistake(path, "other-pieces", message)

    def _world_and_checks(self) -> Iterator[FileMistake]:
        name = self._opened.world(self._number)
        worlds = {*self._opened.own_worlds, *known_worlds()}
        if name is not None and name not in worlds:
            if self._step.world is not None:
                yield _unknown(("world",), "world", name, sorted(worlds))
            return
        world = self._opened.described_world(self._number)
        for index, check in enumerate(self._step.check):
            yield from self._check(("check", index), check, world)

    def _check(
        self, path: KeyPath, check: Check, world: WorldDescription | None
    ) -> Iterator[FileMistake]:
        robots_here = [OWN_ROBOT, *(partner.name for partner in self._step.partners)]
        if check.robot is not None and check.robot not in robots_here:
            yield _unknown((*path, "robot"), "robot", check.robot, robots_here)
        for place, event in _events(check):
            yield from _event((*path, *place), event, world)
        match check:
            case Reaches(goals=names) if world is not None:
                for index, name in enumerate(names):
                    yield from _goal((*path, "goals", index), name, world)
            case StaysOnLine(line=name):
                lines = [line.name for line in world.line] if world else []
                if name not in lines:
                    yield _unknown((*path, "line"), "line", name, lines)
            case Uses(skill=str(name)):
                yield from _skill((*path, "skill"), name)
            case Expert(function=name):
                functions = _functions(self._opened)
                if name not in functions:
                    yield _unknown((*path, "function"), "function", name, functions)


def _events(check: Check) -> Iterator[tuple[KeyPath, Event]]:
    """The events that a check asks about, and where they are in it."""
    match check:
        case Happens(what=event) | Never(what=event):
            yield ("what",), event
        case InOrder(events=events):
            for index, event in enumerate(events):
                yield ("events", index), event


def _goal(path: KeyPath, name: str, world: WorldDescription) -> Iterator[FileMistake]:
    goals = [goal.name for _, _, goal in world.goal.all()]
    if name not in goals:
        yield _unknown(path, "goal", name, goals)


def _event(path: KeyPath, event: Event, world: WorldDescription | None) -> Iterator[FileMistake]:
    if isinstance(event, GoalReached) and world is not None:
        yield from _goal((*path, "name"), event.name, world)
    if isinstance(event, Called):
        yield from _skill((*path, "skill"), event.skill)


def _skill(path: KeyPath, name: str) -> Iterator[FileMistake]:
    skills = all_configurations()
    if name not in skills:
        yield _unknown(path, "skill", name, skills)


def _unknown_robots(path: KeyPath, names: Iterable[str]) -> Iterator[FileMistake]:
    for index, name in enumerate(names):
        try:
            robots.find(name)
        except UnknownNameError as error:
            at = (*path, index) if path[-1] == "robots" else path
            yield FileMistake(at, "unknown-name", error.phrase)


def _missing(opened: OpenLesson, path: KeyPath, file: str) -> Iterator[FileMistake]:
    if file not in opened.files:
        yield FileMistake(path, "missing-file", Phrase("lesson-missing-file", file=file))


def _unreadable(blocks: str) -> Iterator[FileMistake]:
    try:
        language.parse(blocks, "blocks")
    except FileError as error:
        problem = Phrase("lesson-text-blocks", problem=error.phrase)
        yield FileMistake(("text",), "wrong-blocks", problem)


def _unknown(path: KeyPath, kind: str, name: str, names: Iterable[str]) -> FileMistake:
    return FileMistake(path, "unknown-name", UnknownNameError(kind, name, names).phrase)


def _check_programs(opened: OpenLesson, folder: str) -> None:
    """Check that programs can be parsed; what pupils start with may have empty blocks.

    Raises:
        LessonError: one can't.
    """
    for path in sorted(opened.files):
        if not path.startswith(folder) or not path.endswith((".bt", ".py")):
            continue
        try:
            program_tree(opened, path)
        except LessonError as error:
            if {diagnostic.code for diagnostic in error.diagnostics} != {"empty-block"}:
                raise


def _check_experts(opened: OpenLesson) -> None:
    """Check that the lesson's Python is Python, and read its texts.

    Raises:
        LessonError: it is not, or the texts have mistakes.
    """
    own_texts(opened)
    if EXPERTS not in opened.files:
        return
    text = opened.text(EXPERTS)
    try:
        ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        line = error.lineno or 0 if isinstance(error, SyntaxError) else 0
        message = Phrase("file-not-python", reason=str(error))
        diagnostics = [Diagnostic("not-python", message, line)]
        raise LessonError(f"{opened.name}/{EXPERTS}", diagnostics, text) from None


def _functions(opened: OpenLesson) -> tuple[str, ...]:
    """The functions of the lesson's Python."""
    if EXPERTS not in opened.files:
        return ()
    _check_experts(opened)
    tree = ast.parse(opened.text(EXPERTS))
    return tuple(node.name for node in tree.body if isinstance(node, ast.FunctionDef))
