"""Texts of a lesson, in one language or in several."""

import re
from collections.abc import Iterator, Mapping
from typing import Annotated

from msgspec import Meta

from learnblock.i18n import ENGLISH

Language = Annotated[
    str, Meta(pattern="^[a-z]{2,3}(-[A-Za-z0-9]{2,8})?$", description="a language, such as es")
]
Line = Annotated[str, Meta(min_length=1, max_length=200)]
#: The limit of a text in characters.
LONGEST = 8000
Paragraphs = Annotated[str, Meta(min_length=1, max_length=LONGEST)]

#: One line in every language alike, or by language.
Title = Line | Annotated[dict[Language, Line], Meta(min_length=1, max_length=20)]
#: Markdown in every language alike, or by language.
Markdown = Paragraphs | Annotated[dict[Language, Paragraphs], Meta(min_length=1, max_length=20)]


def in_language(text: str | Mapping[str, str], language: str) -> str:
    """A text in a language; where it is missing in English, else in the first that it has.

    Args:
        text: the text.
        language: such as ``es``.
    """
    if isinstance(text, str):
        return text
    for candidate in (language, language.partition("-")[0], ENGLISH):
        if candidate in text:
            return text[candidate]
    return next(iter(text.values()))


def plain(text: str | Mapping[str, str]) -> str | dict[str, str]:
    """A text of a lesson in the form of messages."""
    return text if isinstance(text, str) else dict(text)


#: The most drawings of a step.
MOST_DRAWINGS = 40
_OPENING, _CLOSING = re.compile(r"```[ \t]*blocks[ \t]*"), re.compile(r"```[ \t]*")


def drawn_blocks(text: str) -> Iterator[str]:
    """The Block-Text in the code blocks ``blocks`` of a text in Markdown."""
    return (part for part, is_drawn in parts_of(text) if is_drawn)


def parts_of(text: str) -> Iterator[tuple[str, bool]]:
    """The parts of a text in Markdown; True if one is the Block-Text of a code block ``blocks``."""
    lines: list[str] = []
    opening: int | None = None
    # Line by line: a search for the end of each beginning would take long in a hostile text.
    for line in text.split("\n"):
        if opening is not None and _CLOSING.fullmatch(line):
            yield "\n".join(lines[:opening]), False
            yield "".join(f"{inside}\n" for inside in lines[opening + 1 :]), True
            lines, opening = [], None
            continue
        if opening is None and _OPENING.fullmatch(line):
            opening = len(lines)
        lines.append(line)
    yield "\n".join(lines), False
