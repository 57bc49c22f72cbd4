"""Find numbers that are not what their use needs: limits of `random`, and sums that are rounded."""

from collections.abc import Iterator

from learnblock.i18n import Phrase
from learnblock.language.check.findings import constant
from learnblock.language.check.types import Types
from learnblock.language.tree.nodes import Call, Expression, Name, Unary


def random_limits(types: Types, node: Call) -> Iterator[tuple[Phrase, Expression]]:
    """What is wrong with the limits of `random`, where they are certain, and which it is."""
    limits = [constant(bound) for bound in node.arguments]
    for bound, limit in zip(node.arguments, limits, strict=True):
        if types.has_decimals(bound):
            is_literal = limit is not None
            literal = Phrase("check-random-decimals", number=_written(types, bound))
            yield literal if is_literal else Phrase("check-decimals"), bound
    match node.arguments, limits:
        case [low, high], [float() | int() as least, float() | int() as most] if least > most:
            values = {"low": _written(types, low), "high": _written(types, high)}
            yield Phrase("check-random-order", **values), low


def rounded_side(
    types: Types, left: Expression, right: Expression
) -> tuple[Phrase, Expression] | None:
    """The side of ``==`` or ``!=`` that is calculated with decimals: it may miss the other."""
    for rounded, other in ((left, right), (right, left)):
        if types.is_rounded(rounded):
            name, value = types.findings.spelled(rounded), _written(types, other)
            is_short = isinstance(rounded, Name) and not value.endswith("...")
            code = "check-rounded" if is_short else "check-rounded-sum"
            return Phrase(code, name=name, value=value), rounded
    return None


def _written(types: Types, node: Expression) -> str:
    """A number as the program has it."""
    sign, number = ("-", node.operand) if isinstance(node, Unary) else ("", node)
    return sign + types.findings.spelled(number)
