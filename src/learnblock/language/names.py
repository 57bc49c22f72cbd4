"""Names on their way between Block-Text and Python, both ways without loss.

Python has words that Block-Text allows as names, and a program in Python uses names of the
language's library. Such a name gets a ``_`` behind it in Python: ``class`` is ``class_``, and
``class_`` is ``class__``.
"""

import keyword
from collections.abc import Set as AbstractSet

from learnblock.language.lexer import KEYWORDS

_BUILTINS = [
    "abs",
    "aiter",
    "all",
    "anext",
    "any",
    "ascii",
    "bin",
    "bool",
    "breakpoint",
    "bytearray",
    "bytes",
    "callable",
    "chr",
    "classmethod",
    "compile",
    "complex",
    "delattr",
    "dict",
    "dir",
    "divmod",
    "enumerate",
    "eval",
    "exec",
    "exit",
    "filter",
    "float",
    "format",
    "frozenset",
    "getattr",
    "globals",
    "hasattr",
    "hash",
    "help",
    "hex",
    "id",
    "input",
    "int",
    "isinstance",
    "issubclass",
    "iter",
    "len",
    "list",
    "locals",
    "map",
    "max",
    "memoryview",
    "min",
    "next",
    "object",
    "oct",
    "open",
    "ord",
    "pow",
    "print",
    "property",
    "quit",
    "range",
    "repr",
    "reversed",
    "round",
    "set",
    "setattr",
    "slice",
    "sorted",
    "staticmethod",
    "str",
    "sum",
    "super",
    "tuple",
    "type",
    "vars",
    "zip",
]
_PYTHON = frozenset(keyword.kwlist)
# The empty name stands for ``_``, which counts the rounds of `repeat`.
RESERVED = (
    _PYTHON
    | {*_BUILTINS, "math", "random", "statistics", "time"}
    | {
        "robot",
        "Robot",
        "elapsedTime",
        "",
    }
)


def to_python(name: str) -> str:
    """The name in Python of a variable, function or parameter."""
    return name + "_" if name.rstrip("_") in RESERVED else name


def from_python(name: str) -> str | None:
    """The name in Block-Text, or None if Block-Text cannot have a variable that Python calls so."""
    if name.rstrip("_") in RESERVED:
        if not name.endswith("_") or len(name) < 2:
            return None
        name = name[:-1]
    return None if name in KEYWORDS else name


def attribute_to_python(name: str) -> str:
    """The name in Python of a skill, or of one of its arguments."""
    return name + "_" if name.rstrip("_") in _PYTHON else name


def attribute_from_python(name: str) -> str:
    """The name in Block-Text of a skill, or of one of its arguments."""
    return name[:-1] if name.endswith("_") and name.rstrip("_") in _PYTHON else name


def when_to_python(name: str, variables: AbstractSet[str]) -> str:
    """The name in Python of a ``when``, which may be called like a variable in Block-Text only.

    Args:
        name: in Block-Text.
        variables: all other names of the program, in Block-Text.
    """
    return to_python(name + "_when" if _clashes(name, variables) else name)


def when_from_python(name: str, variables: AbstractSet[str]) -> str | None:
    """The name in Block-Text of a ``when``; None if the function is called like a variable."""
    plain = from_python(name)
    if plain is None:
        return None
    shorter = plain.removesuffix("_when")
    if shorter != plain and _clashes(shorter, variables):
        return shorter
    return None if _clashes(plain, variables) else plain


def _clashes(name: str, variables: AbstractSet[str]) -> bool:
    """Whether a variable is called so, or would be if both had fewer ``_when`` behind them."""
    while name not in variables:
        shorter = name.removesuffix("_when")
        if shorter == name:
            return False
        name = shorter
    return True
