"""Values of TOML: read from what may come from anyone, and written for a reader."""

import re
import tomllib
from collections.abc import Callable
from typing import Any

#: A part of a dotted key, with its dot.
_PART = r"""(?:[\w-]++|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+"""
#: More parts than any of our keys has: tomllib takes time quadratic in their number.
_DEEP_KEY = re.compile(rf"""(?<![\w"'-])(?:{_PART}){{32}}""", re.ASCII)

#: The most items of a list that are written.
_LONGEST_LIST = 8


def loads(source: str) -> dict[str, Any]:
    """Read TOML, in time linear in its size.

    Raises:
        tomllib.TOMLDecodeError: it is not TOML.
        RecursionError: it is nested too deeply.
        ValueError: a number has too many digits, or a day does not exist.
    """
    if _DEEP_KEY.search(source):
        raise RecursionError("a key has more than 32 parts")
    return tomllib.loads(source)


def written(value: object, number: Callable[[Any], str] = str) -> str:
    """A value as TOML writes it; a table, and the end of a long list, are left out.

    Args:
        value: the value.
        number: writes a number, or anything else that TOML writes without quotes.
    """
    match value:
        case bool():
            return str(value).lower()
        case str():
            return f'"{value}"'
        case dict():
            return "{...}"
        case list() | tuple():
            items = (written(item, number) for item in value[:_LONGEST_LIST])
            return "[" + ", ".join(items) + "]"
    return number(value)
