"""Reword a line from another language as Block-Text, so that it can be explained and read."""

import re
from typing import NamedTuple

from learnblock.i18n import Phrase
from learnblock.language.blocktext.foreign_lines import RULES, Rule

#: Longer lines are not reworded: the patterns go over a line several times.
MAX_LENGTH = 200
_TEXTS = re.compile(r"\"(?:[^\"\\]|\\.)*\"|'(?:[^'\\]|\\.)*'")


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


def reworded(line: str, rules: tuple[Rule, ...] = RULES) -> Rewording | None:
    """What a line that cannot be read should be; None if it resembles no known slip."""
    if len(line) > MAX_LENGTH:
        return None
    masked = _TEXTS.sub(_blank, line)
    for rule in rules:
        found = rule.match(masked)
        if found is None:
            continue
        rewording = _applied(rule, found, line)
        if rewording.line != line:
            return rewording
    return None


def _applied(rule: Rule, found: re.Match[str], line: str) -> Rewording:
    indent = len(line) - len(line.lstrip())
    start, end = (indent, len(line.rstrip()))
    if "wrong" in found.re.groupindex:
        start, end = found.span("wrong")
    instead = re.sub(r"\\(\d)", lambda group: _group(found, int(group[1]), line), rule.instead)
    wrong = line[start:end]
    message = Phrase(rule.code, found=wrong.strip(), instead=instead.strip())
    blanks = len(wrong) - len(wrong.lstrip())
    return Rewording(line[:start] + instead + line[end:], message, start + blanks, end)


def _group(found: re.Match[str], number: int, line: str) -> str:
    start, end = found.span(number)
    return line[start:end]


def _blank(text: re.Match[str]) -> str:
    quote = text[0][0]
    return quote + " " * (len(text[0]) - 2) + quote
