"""Python's own statements and values in the palette; each is a small example that is valid."""

from collections.abc import Sequence
from typing import Any

from learnblock.blocks.python_sentences import BLOCK, LINE, VALUE

#: The stage of the page from which the palette shows them.
STAGE = "coder"

Entry = tuple[str, dict[str, Any]]
State = dict[str, Any]


def _shadow(kind: str, field: str, value: float | str) -> State:
    return {"shadow": {"type": kind, "fields": {field: value}}}


def _number(value: float) -> State:
    return _shadow("math_number", "NUM", value)


def _text(value: str) -> State:
    return _shadow("text", "TEXT", value)


def _variable(name: str) -> State:
    return {"block": {"type": "variables_get", "fields": {"VAR": {"name": name}}}}


def _value(words: Sequence[str], *values: State) -> State:
    return {"block": {"type": VALUE, "extraState": {"words": list(words)}, **_plugged(values)}}


def _plugged(values: Sequence[State]) -> State:
    return {"inputs": {f"A{place}": value for place, value in enumerate(values)}} if values else {}


def _words(kind: str, variant: str, words: Sequence[str], *values: State) -> Entry:
    """A line or a value: its words, and the values between them."""
    return kind, {"extraState": {"words": list(words)}, "variant": variant, **_plugged(values)}


def _parts(variant: str, parts: Sequence[Sequence[str]], *values: State) -> Entry:
    """A block with statements inside: the words of each part, and the values between them."""
    state = {"extraState": {"parts": list(map(list, parts))}, "variant": variant}
    return BLOCK, {**state, **_plugged(values)}


_TRUE = _shadow("logic_boolean", "BOOL", "TRUE")
_ONE, _TWO, _TEN = _number(1), _number(2), _number(10)
_RANGE = _value(("range(", ")"), _TEN)

#: The blocks as in `toolbox`; the variants are their names in block sets.
PYTHON_BLOCKS: tuple[Entry, ...] = (
    _words(LINE, "import", ("import datetime",)),
    _words(LINE, "from", ("from time import sleep",)),
    _words(LINE, "set", ("a, b = ", ""), _value(("(", ", ", ")"), _ONE, _TWO)),
    _parts("try", (("try",), ("except ValueError as error",))),
    _words(LINE, "raise", ("raise ", ""), _value(("ValueError(", ")"), _text("abc"))),
    _words(LINE, "assert", ("assert ", ", ", ""), _TRUE, _text("abc")),
    _parts("with", (("with ", " as file"),), _value(("open(", ")"), _text("a.txt"))),
    _parts("match", (("match ", ""), ("case 1",), ("case _",)), _ONE),
    _parts("class", (("class Dog",),)),
    _parts("def", (("def bark(times=", ")"),), _ONE),
    _parts("for", (("for x in ", ""), ("else",)), _RANGE),
    _words(LINE, "del", ("del x",)),
    _words(LINE, "global", ("global x",)),
    _words(VALUE, "list", ("[", " for x in ", "]"), _variable("x"), _RANGE),
    _words(VALUE, "lambda", ("lambda x: ", ""), _variable("x")),
    _words(VALUE, "attribute", ("self.x",)),
    _words(VALUE, "method", ("", ".format(", ")"), _text("{}"), _ONE),
    _words(VALUE, "slice", ("", "[", ":", ":", "]"), _text("abcdef"), _number(0), _TEN, _TWO),
    _words(VALUE, "tuple", ("(", ", ", ")"), _ONE, _TWO),
    _words(VALUE, "set", ("{", ", ", "}"), _ONE, _TWO),
)
