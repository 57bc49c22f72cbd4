"""Numbers and texts in the fields of blocks, which cannot hold all that a program can spell."""

import math
import sys
from typing import NamedTuple

from learnblock.language.expression_parser import MAX_DIGITS, NUMBER
from learnblock.language.nodes import Constant, Expression, Number, String, Unary
from learnblock.language.strings import quote, unquote
from learnblock.language.workspace import FieldValue
from learnblock.language.workspace_notes import NO_NOTES, Notes
from learnblock.language.workspace_types import CONSTANTS

# Above it a number of JavaScript's cannot tell one whole number from the next.
_EXACT = 2**53


class Literal(NamedTuple):
    """A literal as a block shows it.

    Args:
        type: of the block.
        field: where it stands.
        value: what is shown.
        notes: what cannot be shown.
    """

    type: str
    field: str
    value: FieldValue
    notes: Notes = NO_NOTES


def literal(node: Expression) -> Literal | None:
    """How a block shows a number, a text or a truth value; None for anything else."""
    match node:
        case Number(text=text):
            return _number(text)
        case Unary(operator="-", operand=Number(text=text)):
            return _number("-" + text)
        case String(value=value):
            return _text(value)
        case Constant(value=bool(value)):
            return Literal("logic_boolean", "BOOL", CONSTANTS[value])
    return None


def number(value: FieldValue, notes: Notes) -> Number | Unary | None:
    """The number that a block shows, spelled as noted if that is the same number."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return None
    spelled = notes.number
    if spelled is None or value_of(spelled) != value:
        spelled = _spelled(value)
    return Unary("-", Number(spelled[1:])) if spelled[0] == "-" else Number(spelled)


def text(value: str, notes: Notes) -> String:
    """The text that a block shows, or the noted one that it stands for."""
    if notes.quoted is None or notes.quoted[0] != value:
        return String(value)
    try:
        return String(unquote(notes.quoted[1]))
    except ValueError:
        return String(value)


def _number(spelled: str) -> Literal:
    if spelled.isdecimal() and len(spelled) < 16 and spelled[0] != "0":
        return Literal("math_number", "NUM", int(spelled))
    value = value_of(spelled)
    if value is None:
        value = 0.0
    notes = NO_NOTES if _spelled(value) == spelled else Notes(number=spelled)
    return Literal("math_number", "NUM", value, notes)


def _text(value: str) -> Literal:
    if value.isprintable():
        return Literal("text", "TEXT", value)
    written = quote(value)
    return Literal("text", "TEXT", written[1:-1], Notes(quoted=(written[1:-1], written)))


def value_of(spelled: str) -> float | None:
    """The value of a number; the largest there is instead of one that is larger."""
    plain = spelled.removeprefix("-")
    if len(plain) >= MAX_DIGITS or not NUMBER.fullmatch(plain):
        return None
    try:
        value = float(int(plain, 0))
    except ValueError:
        value = float(plain)
    except OverflowError:
        value = math.inf
    value = min(value, sys.float_info.max)
    return -value if spelled[0] == "-" else value


def _spelled(value: float) -> str:
    if value == int(value) and abs(value) <= _EXACT:
        return str(int(value))
    return repr(value)
