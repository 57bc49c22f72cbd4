"""A lesson on paper: tasks, blocks to cut out, lines to write on, and solutions apart."""

import random
from collections.abc import Iterator
from typing import Any

from learnblock import language
from learnblock.blocks.known import all_configurations
from learnblock.blocks.palette import palette
from learnblock.language.workspace.blocks import Block, Workspace
from learnblock.lessons.describing import title_of
from learnblock.lessons.drawing import drawn_part, drawn_program
from learnblock.lessons.lesson import Quiz
from learnblock.lessons.lesson_pictures import pictures_in
from learnblock.lessons.opened import OpenLesson, program_tree
from learnblock.lessons.teachers_part import SolvedStep, teachers_part
from learnblock.lessons.texts import in_language, parts_of
from learnblock.standalone.page import filled


def worksheet(opened: OpenLesson, words: str) -> str:
    """A page to print, in one file.

    Args:
        opened: the lesson, with what it has for the teacher.
        words: the language, such as ``es``.

    Raises:
        LessonError: one of its files is missing or not UTF-8.
    """
    steps = teachers_part(opened).steps
    texts = [in_language(solved.step.text, words) for solved in steps]
    content = {
        "kind": "worksheet",
        "language": words,
        "palette": palette(all_configurations(), words),
        "title": in_language(opened.lesson.title, words),
        "pictures": pictures_in(opened, texts),
        "steps": [_step(opened, solved, words) for solved in steps],
    }
    return filled(content)


def _step(opened: OpenLesson, solved: SolvedStep, words: str) -> dict[str, Any]:
    step = solved.step
    solution = _solution(opened, solved)
    drawn = drawn_program(solution) if solution else None
    return {
        "title": in_language(step.title, words),
        "text": [*_parts(in_language(step.text, words))],
        "goals": [title_of(check, words) for check in step.check],
        "quiz": _quiz(step.quiz, words) if step.quiz else None,
        "pieces": _shuffled(drawn, solved) if drawn else [],
        "solution": {"text": solution, "workspace": drawn} if drawn else None,
    }


def _solution(opened: OpenLesson, solved: SolvedStep) -> str:
    """The program that a step asks for; empty if it is done with what it begins with."""
    if puzzle := solved.step.puzzle:
        return language.format(program_tree(opened, f"programs/{puzzle.program}"))
    start = opened.start(opened.group(solved.number))
    given = opened.program(start) if start else ""
    return "" if solved.solution.strip() == given.strip() else solved.solution


def _quiz(quiz: Quiz, words: str) -> dict[str, Any]:
    choices = [
        {"text": in_language(choice.text, words), "right": choice.right} for choice in quiz.choices
    ]
    return {"question": in_language(quiz.question, words), "choices": choices}


def _parts(text: str) -> Iterator[dict[str, Any]]:
    """Markdown and programs in turn: the page draws the programs."""
    for part, is_drawn in parts_of(text):
        if is_drawn:
            yield {"text": part, "workspace": drawn_part(part)}
        elif part.strip():
            yield {"text": part, "workspace": None}


def _shuffled(program: Workspace, solved: SolvedStep) -> list[Workspace]:
    """The blocks to cut out, each alone, in the same order each time."""
    puzzle = solved.step.puzzle
    others = map(drawn_part, puzzle.distractors if puzzle else ())
    programs = [program, *(other for other in others if other)]
    pieces = [
        Workspace([[block]], program.variables)
        for program in programs
        for block in pieces_of(program)
    ]
    return random.Random(solved.number).sample(pieces, len(pieces))  # noqa: S311 - no secret


def pieces_of(program: Workspace) -> Iterator[Block]:
    """The blocks of statements of a program in order, each with its values but nothing inside."""
    for stack in program.stacks:
        yield from _pieces(stack)


def _pieces(stack: list[Block]) -> Iterator[Block]:
    for block in stack:
        values = {name: value for name, value in block.inputs.items() if not value.stack}
        yield Block(
            block.type, block.id, fields=block.fields, inputs=values, extraState=block.extraState
        )
        for inside in block.inputs.values():
            yield from _pieces(inside.stack)
