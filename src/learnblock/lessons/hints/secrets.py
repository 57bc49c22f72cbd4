"""Whether a hint gives the solution away."""

import re
from collections.abc import Iterator

from learnblock.i18n import Phrase, Value, languages, translate
from learnblock.language.blocktext.format import format as format_program
from learnblock.language.tree.nodes import (
    Blank,
    Break,
    Comment,
    Continue,
    Pass,
    Program,
    Return,
)
from learnblock.lessons.hints.guess import Hint
from learnblock.lessons.structure import every_statement
from learnblock.lessons.texts import in_language

#: Statements of one word say nothing about a solution, and are words of every language.
_WORDS = (Blank, Break, Comment, Continue, Pass)
_END_OF_HEAD = re.compile(r":\s*(#.*)?$")


def gives_away(hint: Hint, solution: Program) -> str | None:
    """The statement of a solution that a hint contains, in any language; None if there is none.

    Everything that a pupil's page receives counts: all levels, and all values of their phrases,
    whether the words use them or not. Upper and lower case, spaces, and ``function.`` before a
    skill don't matter.

    Args:
        hint: the hint.
        solution: a program that solves the step.
    """
    texts = [_plain(text) for text in _texts(hint)]
    for statement in _statements(solution):
        plain = _plain(statement)
        if any(plain in text for text in texts):
            return statement
    return None


def _texts(hint: Hint) -> Iterator[str]:
    for level in hint.levels:
        for language in languages():
            if isinstance(level, Phrase):
                yield from _texts_of(level, language)
            else:
                yield in_language(level, language)


def _texts_of(value: Value, language: str) -> Iterator[str]:
    """A value as a text; of a phrase also its values."""
    if isinstance(value, Phrase):
        yield translate(value, language)
        for part in value.values.values():
            yield from _texts_of(part, language)
    elif isinstance(value, tuple):
        for part in value:
            yield from _texts_of(part, language)
    else:
        yield str(value)


def _statements(solution: Program) -> Iterator[str]:
    """The first line of each statement, without its comment."""
    for statement in every_statement(solution):
        if isinstance(statement, _WORDS) or (
            isinstance(statement, Return) and statement.value is None
        ):
            continue
        lines = format_program(Program((statement,))).split("\n")  # type: ignore[arg-type]
        text = _END_OF_HEAD.sub("", lines[0])
        if len(text.split()) > 1 or "(" in text:
            yield text


def _plain(text: str) -> str:
    return "".join(text.casefold().replace("function.", "").split())
