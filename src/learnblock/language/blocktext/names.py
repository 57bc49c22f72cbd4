"""Translate names between Block-Text and Python, both ways without loss.

Some names of Block-Text are keywords of Python or names that the generated Python uses itself.
They get a ``_`` at the end in Python: ``class`` becomes ``class_``, and ``class_`` becomes
``class__``.
"""

import keyword
from collections.abc import Iterable, Mapping
from collections.abc import Set as AbstractSet

from learnblock.language.blocktext.lexer import KEYWORDS

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
_WHEN = "_when"
_PYTHON = frozenset(keyword.kwlist)
# The empty name is for ``_``, the loop variable in a `repeat` loop.
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
    """The name in Block-Text, or None if no variable of Block-Text has this name in Python."""
    if name.rstrip("_") in RESERVED:
        if not name.endswith("_") or len(name) < 2:
            return None
        name = name[:-1]
    return None if name in KEYWORDS else name


def keyword_from_python(name: str) -> str:
    """The name in Block-Text of a keyword argument of a user's function."""
    is_marked = len(name) > 1 and name.endswith("_") and name.rstrip("_") in RESERVED
    return name[:-1] if is_marked else name


def attribute_to_python(name: str) -> str:
    """The name in Python of a skill, or of one of its arguments."""
    return name + "_" if name.rstrip("_") in _PYTHON else name


def attribute_from_python(name: str) -> str:
    """The name in Block-Text of a skill, or of one of its arguments."""
    return name[:-1] if name.endswith("_") and name.rstrip("_") in _PYTHON else name


def stem(name: str) -> str:
    """A name without trailing ``_when``s."""
    while name.endswith(_WHEN) and name != _WHEN:
        name = name.removesuffix(_WHEN)
    return name


def clashes(variables: Iterable[str]) -> dict[str, int]:
    """The number of ``_when`` in the longest variable of each stem."""
    counts: dict[str, int] = {}
    for variable in variables:
        key = stem(variable)
        count = (len(variable) - len(key)) // len(_WHEN)
        counts[key] = max(count, counts.get(key, 0))
    return counts


def when_to_python(name: str, clashing: Mapping[str, int]) -> str:
    """The name in Python of a ``when``, which in Block-Text may share the name of a variable.

    Args:
        name: the name in Block-Text.
        clashing: the `clashes` of all other names of the program.
    """
    count = clashing.get(stem(name))
    return to_python(name if count is None else name + _WHEN * (count + 1))


def when_from_python(name: str, clashing: Mapping[str, int]) -> str | None:
    """The name in Block-Text of a ``when``; None if the function's name is that of a variable."""
    plain = from_python(name)
    if plain is None:
        return None
    count = clashing.get(stem(plain))
    if count is None:
        return plain
    added = _WHEN * (count + 1)
    return plain.removesuffix(added) if len(plain) - len(stem(plain)) >= len(added) else None


def state_of(name: str, whens: AbstractSet[str]) -> tuple[str, str] | None:
    """The ``when`` and its attribute in Python that ``state_X`` or ``time_X`` means."""
    if name[:6] == "state_" and name[6:] in whens:
        return name[6:], "active"
    if name[:5] == "time_" and name[5:] in whens:
        return name[5:], "time"
    return None
