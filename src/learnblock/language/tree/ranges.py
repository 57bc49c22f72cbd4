"""Convert counting loops: ``for i from 1 to 10`` includes 10, ``range(1, 11)`` excludes 11."""

import re

from learnblock.language.tree.nodes import Binary, Expression, Number, Unary

_ONE = Number("1")
_WHOLE = re.compile(r"0|[1-9][0-9]{0,17}")


def beyond(stop: Expression, direction: int) -> Expression:
    """The end of a Python range whose last number is `stop`, counting up (1) or down (-1)."""
    value = _whole(stop)
    if value is not None:
        return _number(value + direction)
    forth, back = ("+", "-") if direction > 0 else ("-", "+")
    if isinstance(stop, Binary) and stop.operator == back and stop.right == _ONE:
        inner = stop.left
        # Only if `last` returns the original.
        if _whole(inner) is None and not (isinstance(inner, Binary) and inner.operator == forth):
            return inner
    return Binary(forth, stop, _ONE)


def last(end: Expression, direction: int) -> Expression | None:
    """The last number of a Python range up to `end`; None if `beyond` would not return `end`."""
    forth, back = ("+", "-") if direction > 0 else ("-", "+")
    value = _whole(end)
    if value is not None:
        before = _number(value - direction)
    elif isinstance(end, Binary) and end.operator == forth and end.right == _ONE:
        before = end.left
    else:
        before = Binary(back, end, _ONE)
    return before if beyond(before, direction) == end else None


def direction(step: Expression | None) -> int:
    """1 for a loop that counts up, -1 for one that counts down, 0 if unknown before the run."""
    if step is None or isinstance(step, Number):
        return 1
    if isinstance(step, Unary) and isinstance(step.operand, Number):
        return -1 if step.operator == "-" else 1
    return 0


def _whole(node: Expression) -> int | None:
    if isinstance(node, Unary) and node.operator == "-":
        inner = node.operand
        if isinstance(inner, Number) and inner.text != "0" and _WHOLE.fullmatch(inner.text):
            return -int(inner.text)
        return None
    if isinstance(node, Number) and _WHOLE.fullmatch(node.text):
        return int(node.text)
    return None


def _number(value: int) -> Expression:
    return Number(str(value)) if value >= 0 else Unary("-", Number(str(-value)))
