"""Lines that set three or more variables at once, and the lines that set them one by one."""

import re
from collections.abc import Callable, Sequence
from itertools import pairwise

from learnblock.language.blocktext.line_rules import NAME, Rule
from learnblock.language.tree.identifiers import IDENTIFIER

_WORD = IDENTIFIER
#: A value that uses no variable, so that the order of the lines does not matter.
_PLAIN = r"(?:-?[\d.]+|\"[^\"]*\"|'[^']*'|True\b|False\b|None\b|\[\s*\])"
_NAMES = rf"\s*({NAME}(?:\s*,\s*{_WORD}){{2,}})"


def _lines(lines: Sequence[str]) -> str:
    return ", ".join(f"'{line}'" for line in lines)


def _of_pairs(groups: Sequence[str]) -> str:
    values = re.findall(_PLAIN, groups[3])
    return _lines(
        [f"{name} = {value}" for name, value in zip(_names(groups), values, strict=False)]
    )


def _of_items(groups: Sequence[str]) -> str:
    return _lines([f"{name} = {groups[3]}[{place}]" for place, name in enumerate(_names(groups))])


def _of_chain(groups: Sequence[str]) -> str:
    """The lines for ``a = b = c = 0``: first the last variable, then each from the one behind."""
    names = _names(groups)
    copies = [f"{name} = {source}" for name, source in pairwise(names)]
    return _lines([f"{names[-1]} = {groups[3]}", *reversed(copies)])


def _names(groups: Sequence[str]) -> list[str]:
    return re.findall(_WORD, groups[1])


def _rule(pattern: str, lines: Callable[[Sequence[str]], str]) -> Rule:
    return Rule(pattern, r"\2 = 0", "blocktext-many-targets", (("lines", lines),))


SEVERAL_TARGETS: tuple[Rule, ...] = (
    _rule(rf"{_NAMES}\s*=\s*({_PLAIN}(?:\s*,\s*{_PLAIN}){{2,}})\s*$", _of_pairs),
    _rule(rf"{_NAMES}\s*=\s*({_WORD})\s*$", _of_items),
    Rule(rf"{_NAMES}\s*=[^=].*$", r"\2 = 0", "blocktext-second-assignment"),
    _rule(rf"\s*({NAME}(?:\s*=\s*{_WORD}){{2,}})\s*=\s*([^\s=<>][^=]*?)\s*$", _of_chain),
)
