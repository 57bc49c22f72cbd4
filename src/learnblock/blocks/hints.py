"""Type hints as what a block's field accepts, read from the source without running it."""

import ast
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeGuard

from learnblock.blocks.configuration import NUMBERS, ParameterType
from learnblock.errors import LearnBlockError
from learnblock.fields import Range

MOST_CHOICES = 100
LONGEST_CHOICE = 100

_TYPES: dict[str, ParameterType] = {
    "float": "float",
    "int": "int",
    "str": "string",
    "bool": "boolean",
    "list": "list",
    "List": "list",
    "Colour": "colour",
    "Angle": "angle",
    "TagName": "apriltext",
}
_KNOWN = (
    "float, int, str, bool, list, Colour, Angle, TagName, Annotated[float, Range(0, 100)] or"
    ' Literal["a", "b"]'
)


class HintError(LearnBlockError, ValueError):
    """A hint names no field."""


@dataclass(frozen=True, slots=True)
class FieldType:
    """What a field accepts: see `learnblock.blocks.Parameter`."""

    type: ParameterType
    range: Range | None = None
    choices: tuple[str, ...] = ()


def field_type(hint: ast.expr) -> FieldType:
    """The field that a hint names.

    Raises:
        HintError: it names none; the sentence says what would.
    """
    match hint:
        case ast.Constant(value=str(text)):
            return field_type(_parsed(text))
        case ast.BinOp(op=ast.BitOr()):
            return _either([*_alternatives(hint)])
        case ast.Subscript(value=named, slice=inside):
            return _subscribed(_name(named), inside, hint)
    name = _name(hint)
    if name not in _TYPES:
        raise HintError(f"`{_written(hint)}` names no field of a block; write {_KNOWN}")
    return FieldType(_TYPES[name])


def _parsed(text: str) -> ast.expr:
    try:
        expression = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        expression = None
    if expression is None or isinstance(expression, ast.Constant):
        raise HintError(f"`{text:.40}` names no field of a block; write {_KNOWN}")
    return expression


def _alternatives(hint: ast.expr) -> Iterator[ast.expr]:
    """What stands between the bars of ``a | b``, without None."""
    ahead = [hint]
    while ahead:
        match ahead.pop():
            case ast.BinOp(op=ast.BitOr(), left=left, right=right):
                ahead += [right, left]
            case ast.Constant(value=None):
                continue
            case other:
                yield other


def _either(alternatives: list[ast.expr]) -> FieldType:
    if len(alternatives) == 1:
        return field_type(alternatives[0])
    names = {_name(one) for one in alternatives}
    # Tags go by their number or by their name, and nothing else goes by both.
    if names == {"int", "str"}:
        return FieldType("apriltext")
    written = " | ".join(map(_written, alternatives))
    raise HintError(f"`{written}` names no field of a block; write {_KNOWN}")


def _subscribed(name: str, inside: ast.expr, hint: ast.expr) -> FieldType:
    match name:
        case "Annotated":
            return _annotated(inside, hint)
        case "Literal":
            return FieldType("choice", choices=_choices(inside))
        case "Optional":
            return field_type(inside)
        case "list" | "List":
            return FieldType("list")
    raise HintError(f"`{_written(hint)}` names no field of a block; write {_KNOWN}")


def _annotated(inside: ast.expr, hint: ast.expr) -> FieldType:
    parts = inside.elts if isinstance(inside, ast.Tuple) else [inside]
    found = field_type(parts[0])
    for note in parts[1:]:
        if isinstance(note, ast.Call) and _name(note.func) == "Range":
            if found.type not in NUMBERS:
                raise HintError(f"`{_written(hint)}`: only a number has a range")
            return FieldType(found.type, range=_range(note))
    return found


def _range(call: ast.Call) -> Range:
    names = ("least", "most", "step")
    given = dict(zip(names, call.args, strict=False))
    given |= {keyword.arg or "": keyword.value for keyword in call.keywords}
    numbers = {name: _number(value) for name, value in given.items()}
    if len(call.args) > len(names) or not {"least", "most"} <= numbers.keys() <= {*names}:
        raise HintError(f"`{_written(call)}`: write Range(0, 100) or Range(0, 10, step=1)")
    found = Range(numbers["least"] or 0, numbers["most"] or 0, numbers.get("step"))
    if wrong := objection(found):
        raise HintError(f"`{_written(call)}`: {wrong}")
    return found


def objection(found: Range) -> str:
    """What is wrong with a range; empty if nothing is."""
    numbers = [found.least, found.most, 1 if found.step is None else found.step]
    if not all(math.isfinite(one) and abs(one) <= 1e15 for one in numbers):
        return "its ends must be numbers"
    if not found.least < found.most:
        return "the first number must be smaller than the second"
    if found.step is not None and not 0 < found.step <= found.most - found.least:
        return "the step must be above zero and fit between the ends"
    return ""


def _number(expression: ast.expr) -> float | None:
    try:
        value = ast.literal_eval(expression)
    except (ValueError, TypeError, RecursionError, MemoryError):
        value = expression
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise HintError(f"`{_written(expression)}` in a Range must be a number, written out")
    return value


def _choices(inside: ast.expr) -> tuple[str, ...]:
    items = inside.elts if isinstance(inside, ast.Tuple) else [inside]
    texts = [one.value for one in items if isinstance(one, ast.Constant)]
    found = tuple(dict.fromkeys(one for one in texts if is_choice(one)))
    if len(found) != len(items) or not 0 < len(found) <= MOST_CHOICES:
        raise HintError(
            f"`Literal[{_written(inside)}]`: choices are different texts of one line in quotes, at"
            f' most {MOST_CHOICES}, such as Literal["slow", "fast"]'
        )
    return found


def is_choice(value: object) -> TypeGuard[str]:
    """Whether a value can be one of the texts to choose from."""
    return isinstance(value, str) and value.isprintable() and 0 < len(value) <= LONGEST_CHOICE


def _name(hint: ast.expr) -> str:
    match hint:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""


def _written(hint: ast.expr) -> str:
    try:
        text = ast.unparse(hint)
    except RecursionError:
        return "..."
    return text if len(text) <= 60 else f"{text[:57]}..."
