"""How many decimals a number needs, so that a sentence about a condition is correct."""

import ast
import operator
from collections.abc import Callable, Mapping
from typing import Any

#: The number of decimals if they are enough.
FEW = 2
#: In place of a count, for numbers as they are.
ALL = 17

_COMPARISONS: dict[type, Callable[[Any, Any], bool]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_ARITHMETIC: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
}


class _UnknownError(Exception):
    """A condition has a part whose value is unknown."""


def decimals(condition: str, values: Mapping[str, Any], *, was_true: bool) -> int:
    """How many decimals of some values give a condition the result that it had.

    Args:
        condition: an expression of the program, in Python.
        values: of its parts, by their text.
        was_true: whether the condition was true.
    """
    tree = _parsed(condition)
    if tree is None or not any(isinstance(value, float) for value in values.values()):
        return FEW
    for count in range(FEW, ALL + 1):
        approximations = {text: _shown(value, count) for text, value in values.items()}
        try:
            if bool(_value(tree, approximations)) == was_true:
                return count
        except (_UnknownError, ArithmeticError, TypeError, ValueError):
            return FEW
    return FEW


def is_compared_exactly(condition: str) -> bool:
    """Whether a condition asks if two values are exactly equal."""
    tree = _parsed(condition)
    return tree is not None and any(isinstance(node, ast.Eq | ast.NotEq) for node in ast.walk(tree))


def _parsed(condition: str) -> ast.expr | None:
    try:
        return ast.parse(condition, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def rounded(value: float, count: int) -> float:
    """A number with this many decimals."""
    return value if count >= ALL else round(value, count)


def _shown(value: Any, count: int) -> Any:
    return rounded(value, count) if isinstance(value, float) else value


def _value(node: ast.expr, values: Mapping[str, Any]) -> Any:
    """The value of an expression of numbers, comparisons and known parts."""
    text = ast.unparse(node)
    if text in values:
        return values[text]
    match node:
        case ast.Constant():
            result = node.value
        case ast.UnaryOp(ast.Not(), operand):
            result = not _value(operand, values)
        case ast.UnaryOp(ast.USub(), operand):
            result = -_value(operand, values)
        case ast.BinOp(left, op, right) if type(op) in _ARITHMETIC:
            result = _ARITHMETIC[type(op)](_value(left, values), _value(right, values))
        case ast.BoolOp(op, parts):
            result = _joined(parts, values, is_or=isinstance(op, ast.Or))
        case ast.Compare(left, ops, others):
            result = _compared(left, ops, others, values)
        case _:
            raise _UnknownError
    return result


def _joined(parts: list[ast.expr], values: Mapping[str, Any], *, is_or: bool) -> bool:
    # An operand that was not evaluated has no value: the result was known before.
    for part in parts:
        if bool(_value(part, values)) == is_or:
            return is_or
    return not is_or


def _compared(
    left: ast.expr, ops: list[ast.cmpop], others: list[ast.expr], values: Mapping[str, Any]
) -> bool:
    before = _value(left, values)
    for op, other in zip(ops, others, strict=True):
        if type(op) not in _COMPARISONS:
            raise _UnknownError
        value = _value(other, values)
        if not _COMPARISONS[type(op)](before, value):
            return False
        before = value
    return True
