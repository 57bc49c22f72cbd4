"""TOML that may come from anyone, as values by key."""

import re
import tomllib
from typing import Any

#: A part of a dotted key, with its dot.
_PART = r"""(?:[\w-]++|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+"""
#: More parts than any of our keys has: tomllib takes time quadratic in their number.
_DEEP_KEY = re.compile(rf"""(?<![\w"'-])(?:{_PART}){{32}}""", re.ASCII)


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
