"""Write expressions as text: the part that Block-Text and Python share.

Brackets are written only where the tree needs them. Precedence is that of Python, loosest first.
"""

from collections.abc import Callable
from typing import Any, ClassVar

from learnblock.language.tree.nodes import (
    Binary,
    Call,
    Compare,
    Conditional,
    Constant,
    Dictionary,
    Expression,
    FString,
    Index,
    Keyword,
    List,
    Name,
    Number,
    RawExpression,
    SkillCall,
    String,
    Unary,
)
from learnblock.language.tree.strings import quote
from learnblock.language.tree.texts import written

LOOSEST, OR, NOT, COMPARE, SIGN, POWER, TIGHTEST = 0, 1, 3, 4, 7, 8, 9
_LEVELS = {"or": OR, "and": 2, "+": 5, "-": 5, "*": 6, "/": 6, "//": 6, "%": 6, "**": POWER}

_WRITERS: dict[type[Expression], str] = {
    Number: "number",
    String: "string",
    FString: "f_string",
    Constant: "constant",
    Name: "name",
    Call: "call",
    SkillCall: "skill_call",
    List: "list",
    Dictionary: "dictionary",
    Index: "index",
    Unary: "unary",
    Binary: "binary",
    Compare: "compare",
    Conditional: "conditional",
    RawExpression: "raw",
}


class ExpressionWriter:
    """Writes expressions; a subclass defines how names, calls and raw Python are written."""

    writers: ClassVar[dict[type[Expression], Callable[[Any, Any, int], str]]] = {}

    #: Whether a value in an f-string is being written, which has other quotes.
    in_text = False

    def __init_subclass__(cls) -> None:
        cls.writers = {kind: getattr(cls, name) for kind, name in _WRITERS.items()}

    def expression(self, node: Expression, level: int = LOOSEST) -> str:
        """`node` as text, in brackets if it binds more loosely than `level`."""
        return self.writers[type(node)](self, node, level)

    def number(self, node: Number, _: int) -> str:
        return node.text

    def string(self, node: String, _: int) -> str:
        return f"'{node.value}'" if self.in_text else quote(node.value)

    def f_string(self, node: FString, _: int) -> str:
        self.in_text = True
        parts = [
            written(part.value) if isinstance(part, String) else f"{{{self.expression(part)}}}"
            for part in node.parts
        ]
        self.in_text = False
        return f'f"{"".join(parts)}"'

    def constant(self, node: Constant, _: int) -> str:
        return str(node.value)

    def name(self, node: Name, _: int) -> str:
        return node.name

    def call(self, node: Call, _: int) -> str:
        raise NotImplementedError

    def skill_call(self, node: SkillCall, _: int) -> str:
        raise NotImplementedError

    def raw(self, node: RawExpression, level: int) -> str:
        raise NotImplementedError

    def keyword_name(self, name: str) -> str:
        return name

    def list(self, node: List, _: int) -> str:
        return f"[{', '.join([self.expression(item) for item in node.items])}]"

    def dictionary(self, node: Dictionary, _: int) -> str:
        entries = [
            f"{self.expression(key)}: {self.expression(value)}"
            for key, value in zip(node.keys, node.values, strict=True)
        ]
        return f"{{{', '.join(entries)}}}"

    def index(self, node: Index, _: int) -> str:
        return f"{self.receiver(node.value)}[{self.expression(node.index)}]"

    def unary(self, node: Unary, level: int) -> str:
        if node.operator == "not":
            own = NOT
            text = f"not {self.expression(node.operand, NOT)}"
        else:
            own = SIGN
            text = f"{node.operator}{self.expression(node.operand, SIGN)}"
        return f"({text})" if own < level else text

    def binary(self, node: Binary, level: int) -> str:
        own = _LEVELS[node.operator]
        if own == POWER:
            text = self.power(node)
        else:
            left = self.expression(node.left, own)
            text = f"{left} {node.operator} {self.expression(node.right, own + 1)}"
        return f"({text})" if own < level else text

    def power(self, node: Binary) -> str:
        left = self.expression(node.left, TIGHTEST)
        return f"{left} ** {self.expression(node.right, SIGN)}"

    def compare(self, node: Compare, level: int) -> str:
        parts = [self.expression(node.operands[0], COMPARE + 1)]
        for operator, operand in zip(node.operators, node.operands[1:], strict=True):
            parts.append(operator)
            parts.append(self.expression(operand, COMPARE + 1))
        text = " ".join(parts)
        return f"({text})" if level > COMPARE else text

    def conditional(self, node: Conditional, level: int) -> str:
        yes, condition = self.expression(node.yes, OR), self.expression(node.condition, OR)
        no = self.expression(node.no, LOOSEST if isinstance(node.no, Conditional) else OR)
        text = f"{yes} if {condition} else {no}"
        return f"({text})" if level > LOOSEST else text

    def receiver(self, node: Expression) -> str:
        """The source of an expression before a dot or a bracket."""
        text = self.expression(node, TIGHTEST)
        return f"({text})" if isinstance(node, Number) else text

    def arguments(
        self, arguments: tuple[Expression, ...], keywords: tuple[Keyword, ...] = ()
    ) -> str:
        """The text between the brackets of a call."""
        parts = [self.expression(argument) for argument in arguments]
        parts += [
            f"{self.keyword_name(keyword.name)}={self.expression(keyword.value)}"
            for keyword in keywords
        ]
        return ", ".join(parts)
