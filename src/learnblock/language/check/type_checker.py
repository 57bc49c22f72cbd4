"""Find what cannot work because of the types of values: ``"score: " + score``."""

from collections.abc import Callable
from typing import Any

from learnblock.errors import Severity
from learnblock.i18n import Phrase
from learnblock.language.check.argument_types import COLLECTIONS, OF_ITEM, OF_NUMBERS, TAKES
from learnblock.language.check.findings import Findings, is_whole
from learnblock.language.check.list_checker import check_lists
from learnblock.language.check.number_checker import random_limits, rounded_side
from learnblock.language.check.types import KNOWN, NUMBERS, TEXTS, Type, Types
from learnblock.language.tree.builtins import FUNCTIONS
from learnblock.language.tree.nodes import (
    Assign,
    Binary,
    Call,
    Compare,
    Conditional,
    Def,
    Expression,
    ForEach,
    ForRange,
    If,
    Index,
    Item,
    Name,
    Number,
    Repeat,
    SkillCall,
    String,
    Unary,
    WaitUntil,
    When,
    While,
)
from learnblock.language.tree.traversal import (
    all_expressions,
    expressions,
    set_by,
    statements,
)

#: The operators that text does not have.
_CALCULATING = frozenset(("+=", "-=", "/=", "//=", "**="))
_EQUALITIES = frozenset(("==", "!="))
_ORDERS = frozenset(("<", ">", "<=", ">="))


def check_types(findings: Findings) -> None:
    """Report the expressions of a program that cannot work."""
    checker = _TypeChecker(findings)
    checker.run()
    if Type.LIST in checker.types.variables.values():
        check_lists(findings)


#: The most times that the advice names; a number such as 1e400 is larger than any whole number.
_MOST_REPEATS = 10**9


class _TypeChecker:
    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.types = Types(findings)
        self.spelled = findings.spelled

    def run(self) -> None:
        items = (*self.findings.program.items, *self.findings.main)
        for item in items:
            if isinstance(item, Def):
                self.types.parameters = frozenset(item.parameters)
            for statement in statements((item,)):
                self.statement(statement)
            self.types.parameters = frozenset()

    def statement(self, item: Item) -> None:
        for node in all_expressions(item):
            check = _EXPRESSIONS.get(type(node))
            if check is not None:
                check(self, node)
        check = _STATEMENTS.get(type(item))
        if check is not None:
            check(self, item)

    def report(self, message: Phrase, node: Expression, severity: Severity = "error") -> None:
        self.findings.report("wrong-type", message, node.span, severity)

    # Statements.

    def assignment(self, item: Assign) -> None:
        if item.operator == "+=" and self.adds_characters(item):
            self.report(self.append(item.target, item.value), item.value, "warning")
        elif item.operator in _CALCULATING and self.changes_answer(item):
            self.report(self.answer_changed(item), item.target)
        elif item.operator != "=":
            self.operands(item.operator[:-1], item.target, item.value)
        elif isinstance(item.value, Unary):
            self.swapped_operator(item.target, item.value)
        self.result(item.value)

    def adds_characters(self, item: Assign) -> bool:
        """Whether text is added to a list in place: Python then adds its characters one by one."""
        return self.types.of(item.target) is Type.LIST and self.types.of(item.value) in TEXTS

    def changes_answer(self, item: Assign) -> bool:
        """Whether a number is added to what was typed in, or taken away from it, in place."""
        kinds = (self.types.of(item.target), self.types.of(item.value))
        return kinds == (Type.ANSWER, Type.NUMBER)

    def answer_changed(self, item: Assign) -> Phrase:
        name, value = self.spelled(item.target), self.spelled(item.value)
        instead = f"{name} = int({name}) {item.operator[:-1]} {value}"
        return Phrase("check-answer-changed", name=name, instead=instead)

    def swapped_operator(self, target: Expression, value: Unary) -> None:
        """Report ``x =+ 1``, with a space between the sign and its number."""
        if value.operator != "not" and value.operand.span.column > value.span.column + 1:
            message = Phrase(
                "check-swapped-operator",
                found=f"={value.operator}",
                instead=f"{value.operator}=",
                name=self.spelled(target),
            )
            self.report(message, value, "warning")

    def result(self, value: Expression) -> None:
        if self.types.of(value) is Type.NOTHING and isinstance(value, Call | SkillCall):
            message = Phrase("check-no-result", call=self.spelled(value))
            self.report(message, value, "warning")

    def repeat(self, item: Repeat) -> None:
        self.number(item.count)
        if isinstance(item.count, Number) and not is_whole(item.count.text):
            less = int(min(max(float(item.count.text), 1), _MOST_REPEATS))
            message = Phrase(
                "check-repeat-whole-number",
                number=item.count.text,
                less=str(less),
                more=str(less + 1),
            )
            self.report(message, item.count)
        else:
            self.decimal(item.count)

    def decimal(self, node: Expression) -> None:
        """Report a calculation whose result has decimals where a whole number is needed."""
        if not isinstance(node, Number) and self.types.has_decimals(node):
            self.report(Phrase("check-decimals"), node)

    def range(self, item: ForRange) -> None:
        for bound in (item.start, item.stop, item.step):
            if bound is not None and not isinstance(bound, String):
                self.number(bound)
                self.decimal(bound)

    def each(self, item: ForEach) -> None:
        if len(item.targets) > 1 and self.types.of(item.values) is Type.DICTIONARY:
            names = ", ".join(target.name for target in item.targets)
            code = self.findings.worded("check-for-dictionary", "check-for-dictionary-python")
            message = Phrase(code, names=names, value=self.spelled(item.values))
            self.report(message, item.values, "warning")
        if self.types.of(item.values) in NUMBERS:
            code = self.findings.worded("check-for-number", "check-for-number-python")
            self.report(
                Phrase(code, name=item.targets[0].name, value=self.spelled(item.values)),
                item.values,
            )

    def conditions(self, item: If | While | WaitUntil | When) -> None:
        for condition in expressions(item):
            self.condition(condition)
            if isinstance(condition, Number) and not isinstance(item, While):
                message = Phrase("check-number-as-condition", number=condition.text)
                self.report(message, condition, "warning")

    def condition(self, node: Expression) -> None:
        if isinstance(node, Binary) and node.operator in {"and", "or"}:
            self.condition(node.left)
            if not self.is_bare_value(node):
                self.condition(node.right)
        elif isinstance(node, String):
            self.report(Phrase("check-text-as-condition"), node, "warning")
        elif self.types.of(node) is Type.NOTHING:
            message = Phrase("check-action-as-condition", call=self.spelled(node))
            self.report(message, node, "warning")

    def is_bare_value(self, node: Binary) -> bool:
        """Report ``x == 1 or 2``; whether it is that slip."""
        left = node.left
        while isinstance(left, Binary):
            left = left.right
        if not (isinstance(left, Compare) and isinstance(node.right, Number | String)):
            return False
        message = Phrase(
            "check-bare-value",
            operator=node.operator,
            variable=self.spelled(left.operands[0]),
            comparison=left.operators[0],
            value=self.spelled(node.right),
        )
        self.report(message, node.right, "warning")
        return True

    # Expressions.

    def binary(self, node: Binary) -> None:
        if node.operator in {"and", "or"}:
            self.is_bare_value(node)
        else:
            self.operands(node.operator, node.left, node.right)

    def operands(self, operator: str, left: Expression, right: Expression) -> None:
        zero = isinstance(right, Number) and right.text.strip("0._") == ""
        if operator in {"/", "//", "%"} and zero and self.types.of(left) in NUMBERS:
            self.report(Phrase("check-divide-by-zero", operator=operator), right, "warning")
        elif operator == "+":
            self.sum(left, right)
        elif operator == "*":
            self.product(left, right)
        elif operator != "%" or self.types.of(left) not in TEXTS:
            self.number(left)
            self.number(right)

    def sum(self, left: Expression, right: Expression) -> None:
        kinds = {self.types.of(left), self.types.of(right)}
        if not kinds <= KNOWN or kinds <= NUMBERS or kinds <= TEXTS or kinds == {Type.LIST}:
            return
        for operand, other in ((left, right), (right, left)):
            if self.types.of(operand) is Type.LIST:
                self.report(self.append(operand, other), other)
                return
        if not kinds & TEXTS:
            self.number(left if self.types.of(left) is Type.DICTIONARY else right)
            return
        text, other = (left, right) if self.types.of(left) in TEXTS else (right, left)
        if self.types.of(text) is Type.ANSWER or _is_number(text):
            self.number(text)
        else:
            self.report(Phrase("check-join-text", value=self.spelled(other)), other)

    def append(self, values: Expression, item: Expression) -> Phrase:
        code = self.findings.worded("check-append", "check-append-python")
        return Phrase(code, values=self.spelled(values), item=self.spelled(item))

    def product(self, left: Expression, right: Expression) -> None:
        kinds = (self.types.of(left), self.types.of(right))
        if Type.NUMBER in kinds and Type.ANSWER in kinds:
            answer = left if kinds[0] is Type.ANSWER else right
            self.report(self.advice(answer), answer, "warning")
        repeatable = TEXTS | {Type.LIST}
        if all(kind in repeatable for kind in kinds):
            # Multiplying text by a number repeats the text.
            self.number(right if self.types.of(right) in TEXTS else left)

    def sign(self, node: Unary) -> None:
        if node.operator != "not":
            self.number(node.operand)

    def comparison(self, node: Compare) -> None:
        for operator, left, right in zip(
            node.operators, node.operands, node.operands[1:], strict=False
        ):
            kinds = {self.types.of(left), self.types.of(right)}
            mixed = bool(kinds & NUMBERS) and bool(kinds & TEXTS) and kinds <= NUMBERS | TEXTS
            text = left if self.types.of(left) in TEXTS else right
            if mixed and operator in _ORDERS:
                self.number(text)
            elif mixed and operator in _EQUALITIES and Type.BOOLEAN not in kinds:
                message = Phrase("check-never-equal", advice=self.advice(text))
                self.report(message, text, "warning")
            elif operator in _EQUALITIES and (rounding := rounded_side(self.types, left, right)):
                message, rounded = rounding
                self.report(message, rounded, "warning")

    def index(self, node: Index) -> None:
        if self.types.of(node.value) in NUMBERS:
            self.report(Phrase("check-no-items", value=self.spelled(node.value)), node.value)
        elif self.types.of(node.value) in TEXTS | {Type.LIST}:
            self.number(node.index)
            self.decimal(node.index)

    def call(self, node: Call) -> None:
        if node.name in self.findings.functions:
            return
        kind = self.types.of_name(node.name)
        if kind in KNOWN and node.name not in FUNCTIONS:
            self.report(self.called_variable(node, kind), node)
        elif node.name == "int" and len(node.arguments) == 1:
            self.words_as_number(node.arguments[0])
        elif self.findings.is_of_language(node.name):
            self.arguments(node, TAKES.get(node.name, ()))
            if node.name == "random":
                for message, bound in random_limits(self.types, node):
                    self.report(message, bound)

    def called_variable(self, node: Call, kind: Type) -> Phrase:
        value = self.spelled(node.arguments[0]) if node.arguments else "0"
        code = "check-variable-called" if kind in NUMBERS else "check-list-called"
        return Phrase(code, name=node.name, value=value)

    def words_as_number(self, value: Expression) -> None:
        if isinstance(value, String) and not _reads_as_whole(value.value):
            self.report(Phrase("check-not-whole", text=value.value), value)

    def arguments(self, node: Call, takes: tuple[frozenset[Type], ...]) -> None:
        for wanted, value in zip(takes, node.arguments, strict=False):
            kind = self.types.of(value)
            if kind not in KNOWN or kind in wanted:
                continue
            if wanted is NUMBERS:
                self.number(value)
            else:
                self.report(self.argument(node, wanted, value), value)

    def argument(self, node: Call, wanted: frozenset[Type], value: Expression) -> Phrase:
        """The message about an argument that should be text or a list."""
        call, spelled = node.name, self.spelled(value)
        kind = self.types.of(value)
        if wanted == TEXTS:
            return Phrase("check-argument-type", call=call, wanted="text", value=spelled)
        if wanted == {Type.DICTIONARY}:
            return Phrase("check-argument-type", call=call, wanted="dictionary", value=spelled)
        if call == "len":
            code = "check-length-of-number" if kind is Type.NUMBER else "check-no-length"
            return Phrase(code, value=spelled)
        if call in OF_ITEM and self.types.of(node.arguments[-1]) is Type.LIST:
            values = self.spelled(node.arguments[-1])
            return Phrase("check-list-first", call=call, values=values, item=spelled)
        if call in OF_NUMBERS and kind in TEXTS:
            return Phrase("check-numbers-of-list", call=call, value=spelled)
        return Phrase("check-argument-type", call=call, wanted="list", value=spelled)

    def skill(self, node: SkillCall) -> None:
        """Report variables that hold text or a list where the skill expects a number."""
        skill = self.findings.skills.get(node.name)
        if skill is None:
            return
        named = {keyword.name: keyword.value for keyword in node.keywords}
        given = dict(
            zip([parameter.name for parameter in skill.parameters], node.arguments, strict=False)
        )
        for parameter in skill.parameters:
            value = {**named, **given}.get(parameter.name)
            if parameter.is_number and value is not None and not isinstance(value, String):
                self.number(value)

    def number(self, node: Expression) -> None:
        """Report a value that should be a number and is text or a list."""
        kind = self.types.of(node)
        if kind in TEXTS | COLLECTIONS:
            self.report(self.advice(node), node)

    def advice(self, node: Expression) -> Phrase:
        """How to turn text or a list into a number."""
        if self.types.of(node) is Type.DICTIONARY:
            return Phrase("check-dictionary-for-number", value=self.spelled(node))
        if self.types.of(node) is Type.LIST:
            return Phrase("check-list-for-number", values=self.spelled(node))
        if isinstance(node, String):
            number = node.value.strip()
            if _is_number(node):
                return Phrase("check-number-without-quotes", number=number)
            return Phrase("check-text-for-number")
        if isinstance(node, Name) and (words := self.words(node)) is not None:
            return Phrase("check-words-for-number", name=node.name, text=words)
        typed_in = self.types.of(node) is Type.ANSWER
        code = "check-answer-for-number" if typed_in else "check-convert-to-number"
        return Phrase(code, value=self.spelled(node))

    def words(self, node: Name) -> str | None:
        """A text that a variable holds, if it only ever holds texts that are not numbers."""
        words: str | None = None
        for item in self.findings.everything:
            if node.name not in set_by(item):
                continue
            match item:
                case Assign(operator="=", value=String(value=text)) if not _is_number(item.value):
                    words = words or text
                case _:
                    return None
        return words


_EXPRESSIONS: dict[type, Callable[[_TypeChecker, Any], None]] = {
    Binary: _TypeChecker.binary,
    Unary: _TypeChecker.sign,
    Compare: _TypeChecker.comparison,
    Conditional: lambda checker, node: checker.condition(node.condition),
    Index: _TypeChecker.index,
    Call: _TypeChecker.call,
    SkillCall: _TypeChecker.skill,
}
_STATEMENTS: dict[type, Callable[[_TypeChecker, Any], None]] = {
    Assign: _TypeChecker.assignment,
    Repeat: _TypeChecker.repeat,
    ForRange: _TypeChecker.range,
    ForEach: _TypeChecker.each,
    If: _TypeChecker.conditions,
    While: _TypeChecker.conditions,
    WaitUntil: _TypeChecker.conditions,
    When: _TypeChecker.conditions,
}


def _is_number(node: Expression) -> bool:
    """Whether a text is the spelling of a number."""
    if not isinstance(node, String):
        return False
    plain = node.value.strip().removeprefix("-").replace(".", "", 1)
    return plain.isascii() and plain.isdecimal()


def _reads_as_whole(text: str) -> bool:
    """Whether ``int`` can read a text, which allows more than the spelling of a number."""
    try:
        int(text)
    except ValueError:
        return False
    return True
