"""Numbers and strings in fields of blocks, which cannot show every spelling."""

import math
import sys
from typing import NamedTuple

from learnblock.errors import EscapeError
from learnblock.language.blocktext.expression_parser import MAX_DIGITS, NUMBER
from learnblock.language.tree.nodes import Constant, Expression, Number, String, Unary
from learnblock.language.tree.strings import quote, unquote
from learnblock.language.workspace.blocks import FieldValue
from learnblock.language.workspace.notes import NO_NOTES, Notes
from learnblock.language.workspace.types import CONSTANTS

# Above it, JavaScript cannot represent every whole number.
_EXACT = 2**53


class Literal(NamedTuple):
    """A literal in a block.

    Args:
        type: the type of the block.
        field: the field that shows it.
        value: the value of that field.
        notes: details that the field cannot show.
    """

    type: str
    field: str
    value: FieldValue
    notes: Notes = NO_NOTES


def literal(node: Expression) -> Literal | None:
    """The block for a number, a string or a truth value; None for anything else."""
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
    """The number in a block, with the stored spelling if it is the same number."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return None
    spelled = notes.number
    if spelled is None or value_of(spelled) != value:
        spelled = _spelled(value)
    return Unary("-", Number(spelled[1:])) if spelled[0] == "-" else Number(spelled)


def text(value: str, notes: Notes) -> String:
    """The string in a block, or the stored one that it represents."""
    if notes.quoted is None or notes.quoted[0] != value:
        return String(value)
    try:
        return String(unquote(notes.quoted[1]))
    except EscapeError:
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
    """The value of a number, at most the largest float."""
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
