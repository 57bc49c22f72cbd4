"""Rules that recognise a wrong line, name the mistake and say what to write instead."""

import re
from collections.abc import Callable, Sequence
from functools import cache
from typing import NamedTuple

from learnblock.i18n import Phrase
from learnblock.language.blocktext.foreign_words import foreign
from learnblock.language.tree.identifiers import IDENTIFIER

WRITE_INSTEAD = "blocktext-write-instead"
#: Longer lines are not reworded: the patterns go over a line several times.
MAX_LENGTH = 200
#: A condition or a value: everything up to the colon.
REST = r"(\S.*?)\s*:?\s*$"
NAME = rf"({IDENTIFIER})"
#: Where a pattern has words in another language.
_PLACE = re.compile(r"%(\w+)%")
_TEXTS = re.compile(r"\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)*'")


class Rule(NamedTuple):
    r"""A wrong line.

    Args:
        pattern: matches the whole line, or its beginning; ``%repeat%`` matches the words for that
            place in a language other than English.
        instead: what to write; ``\1`` is the first group. Or a function of the groups, of which
            the first is what was found.
        code: the code of the message, which has the values ``found`` and ``instead``.
        values: the other values of the message, written like `instead`.
    """

    pattern: str
    instead: str | Callable[[Sequence[str]], str]
    code: str = WRITE_INSTEAD
    values: tuple[tuple[str, str | Callable[[Sequence[str]], str]], ...] = ()

    def match(self, line: str) -> re.Match[str] | None:
        return _compiled(self.pattern).match(line)


@cache
def _compiled(pattern: str) -> re.Pattern[str]:
    # On first use: most programs have no such line, and all the patterns take 20 ms.
    with_words = _PLACE.sub(lambda place: f"(?:{foreign(place[1])})", pattern)
    return re.compile(with_words, re.IGNORECASE)


def at_start(words: str, instead: str, code: str = WRITE_INSTEAD) -> Rule:
    """A rule for words that begin a line, unless the line sets a variable of that name."""
    return Rule(rf"\s*(?P<wrong>{words})\b(?!\s*(?:=[^=]|[.\[]))", instead, code)


class Rewording(NamedTuple):
    """A wrong line and the right one.

    Args:
        line: the line as it should be.
        message: what was wrong.
        start: where the wrong part begins, counted from 0.
        end: where it ends.
    """

    line: str
    message: Phrase
    start: int
    end: int


def reworded(line: str, rules: tuple[Rule, ...]) -> Rewording | None:
    """What a line that cannot be read should be; None if it resembles no known slip."""
    if len(line) > MAX_LENGTH:
        return None
    masked = _TEXTS.sub(_blank, line)
    for rule in rules:
        match = rule.match(masked)
        if match is None:
            continue
        rewording = _applied(rule, match, line)
        if rewording.line != line:
            return rewording
    return None


def _applied(rule: Rule, match: re.Match[str], line: str) -> Rewording:
    indent = len(line) - len(line.lstrip())
    start, end = (indent, len(line.rstrip()))
    if "wrong" in match.re.groupindex:
        start, end = match.span("wrong")
    wrong = line[start:end]
    groups = [wrong, *(line[slice(*span)] for span in match.regs[1:])]
    instead = _filled(rule.instead, groups)
    values = {name: _filled(value, groups) for name, value in rule.values}
    message = Phrase(rule.code, found=wrong.strip(), instead=instead.strip(), **values)
    blanks = len(wrong) - len(wrong.lstrip())
    return Rewording(line[:start] + instead + line[end:], message, start + blanks, end)


def _filled(template: str | Callable[[Sequence[str]], str], groups: Sequence[str]) -> str:
    """A template with the groups of a match in place of their numbers."""
    if callable(template):
        return template(groups)
    return re.sub(r"\\(\d)", lambda number: groups[int(number[1])], template)


def _blank(text: re.Match[str]) -> str:
    quote = text[0][0]
    return quote + " " * (len(text[0]) - 2) + quote
