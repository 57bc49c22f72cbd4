"""Rules that recognise a wrong line, and say what to write instead."""

import re
from collections.abc import Callable, Sequence
from functools import cache
from typing import NamedTuple

WRITE_INSTEAD = "blocktext-write-instead"


class Rule(NamedTuple):
    r"""A wrong line.

    Args:
        pattern: matches the whole line, or its beginning.
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
    return re.compile(pattern, re.IGNORECASE)


def at_start(words: str, instead: str, code: str = WRITE_INSTEAD) -> Rule:
    """A rule for words that begin a line, unless the line sets a variable of that name."""
    return Rule(rf"\s*(?P<wrong>{words})\b(?!\s*(?:=[^=]|[.\[]))", instead, code)


#: A condition or a value: everything up to the colon.
REST = r"(\S.*?)\s*:?\s*$"
NAME = r"([^\W\d]\w*)"
