"""Fields of blocks from type hints, which are read from the source without running it."""

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from learnblock.blocks.schema.configuration import NUMBERS, ParameterType
from learnblock.blocks.schema.limits import MOST_CHOICES, is_choice, range_problem
from learnblock.errors import HintError
from learnblock.fields import Range

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


@dataclass(frozen=True, slots=True)
class FieldType:
    """The values that a field accepts: see `learnblock.blocks.Parameter`."""

    type: ParameterType
    range: Range | None = None
    choices: tuple[str, ...] = ()


def field_type(hint: ast.expr) -> FieldType:
    """The field of a type hint.

    Raises:
        HintError: the hint has no field.
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
        raise HintError("block-unknown-hint", hint=_written(hint))
    return FieldType(_TYPES[name])


def _parsed(text: str) -> ast.expr:
    try:
        expression = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        expression = None
    if expression is None or isinstance(expression, ast.Constant):
        raise HintError("block-unknown-hint", hint=text[:40])
    return expression


def _alternatives(hint: ast.expr) -> Iterator[ast.expr]:
    """The members of ``a | b``, without None."""
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
    names = {_name(alternative) for alternative in alternatives}
    # Only tags have both a number and a name.
    if names == {"int", "str"}:
        return FieldType("apriltext")
    written = " | ".join(map(_written, alternatives))
    raise HintError("block-unknown-hint", hint=written)


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
    raise HintError("block-unknown-hint", hint=_written(hint))


def _annotated(inside: ast.expr, hint: ast.expr) -> FieldType:
    parts = inside.elts if isinstance(inside, ast.Tuple) else [inside]
    declared = field_type(parts[0])
    for note in parts[1:]:
        if isinstance(note, ast.Call) and _name(note.func) == "Range":
            if declared.type not in NUMBERS:
                raise HintError("block-hint-range-not-number", hint=_written(hint))
            return FieldType(declared.type, range=_range(note))
    return declared


def _range(call: ast.Call) -> Range:
    names = ("least", "most", "step")
    given = dict(zip(names, call.args, strict=False))
    given |= {keyword.arg or "": keyword.value for keyword in call.keywords}
    numbers = {name: _number(value) for name, value in given.items()}
    if len(call.args) > len(names) or not {"least", "most"} <= numbers.keys() <= {*names}:
        raise HintError("block-hint-range-form", hint=_written(call))
    limits = Range(numbers["least"] or 0, numbers["most"] or 0, numbers.get("step"))
    if wrong := range_problem(limits):
        raise HintError("block-hint-range", hint=_written(call), problem=wrong)
    return limits


def _number(expression: ast.expr) -> float | None:
    try:
        value = ast.literal_eval(expression)
    except (ValueError, TypeError, RecursionError, MemoryError):
        value = expression
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise HintError("block-hint-range-number", hint=_written(expression))
    return value


def _choices(inside: ast.expr) -> tuple[str, ...]:
    items = inside.elts if isinstance(inside, ast.Tuple) else [inside]
    texts = [item.value for item in items if isinstance(item, ast.Constant)]
    choices = tuple(dict.fromkeys(text for text in texts if is_choice(text)))
    if len(choices) != len(items) or not 0 < len(choices) <= MOST_CHOICES:
        raise HintError("block-hint-choices", hint=_written(inside), most=MOST_CHOICES)
    return choices


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
