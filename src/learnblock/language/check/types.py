"""The types of expressions, as far as they are certain before the run."""

from collections.abc import Mapping
from enum import IntEnum, auto
from fractions import Fraction
from math import isfinite
from types import MappingProxyType

from learnblock.language.check.findings import Findings, is_whole
from learnblock.language.tree.nodes import (
    Assign,
    Binary,
    Call,
    Compare,
    Conditional,
    Constant,
    Def,
    Dictionary,
    Expression,
    ForEach,
    ForRange,
    FString,
    Item,
    List,
    Name,
    Number,
    SkillCall,
    String,
    Unary,
)
from learnblock.language.tree.traversal import set_by, statements
from learnblock.language.workspace.literals import value_of


class Type(IntEnum):
    """A type. Nothing is reported about an unknown one."""

    UNKNOWN = auto()
    UNSET = auto()  # the type of a variable while the types that it depends on are being worked out
    NUMBER = auto()
    TEXT = auto()
    ANSWER = auto()  # a text that `input` returned
    BOOLEAN = auto()
    LIST = auto()
    DICTIONARY = auto()
    NOTHING = auto()  # the result of a function that returns nothing


TEXTS = frozenset((Type.TEXT, Type.ANSWER))
#: The types that Python can calculate with.
NUMBERS = frozenset((Type.NUMBER, Type.BOOLEAN))

KNOWN = NUMBERS | TEXTS | {Type.LIST, Type.DICTIONARY}

_RESULTS: Mapping[str, Type] = MappingProxyType(
    {
        "input": Type.ANSWER,
        **dict.fromkeys(("str", "upper", "lower", "title", "strip", "replace", "join"), Type.TEXT),
        **dict.fromkeys(
            (
                *("int", "float", "len", "sqrt", "exp", "log", "log10", "floor", "ceil", "round"),
                *("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "pi"),
                *("random", "random_fraction", "find", "count"),
            ),
            Type.NUMBER,
        ),
        **dict.fromkeys(("list", "sorted", "split", "keys", "items", "enumerate"), Type.LIST),
        **dict.fromkeys(
            (
                "print",
                "append",
                "extend",
                "insert",
                "remove",
                "clear",
                "sort",
                "reverse",
                "shuffle",
            ),
            Type.NOTHING,
        ),
        "elapsedTime": Type.BOOLEAN,
    }
)
#: The functions whose result Python never counts with.
_WITH_DECIMALS = frozenset(
    (
        *("float", "sqrt", "exp", "log", "log10", "sin", "cos", "tan", "asin", "acos", "atan"),
        *("atan2", "pi", "random_fraction"),
    )
)
#: The functions whose result is nearly always rounded.
_ROUNDED = frozenset(("exp", "log", "log10", "sin", "cos", "tan", "asin", "acos", "atan", "atan2"))
#: The number of passes over the assignments; types in longer chains of variables stay unknown.
_PASSES = 8


class Types:
    """The types of the variables and expressions of a program.

    A variable has a type if all its assignments have that type, wherever they are.
    """

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.parameters: frozenset[str] = frozenset()  # those of the checked function
        self.hidden = findings.raw_names | _all_parameters(findings)
        self.variables: dict[str, Type] = {}
        #: The variables whose value is never a whole number for Python.
        self.fractions: set[str] = set()
        #: The variables that are calculated with decimals.
        self.rounded: set[str] = set()
        if not findings.imports:
            self.work_out()
            self.work_out_fractions()
            self.work_out_rounded()

    def has_decimals(self, node: Expression) -> bool:  # noqa: PLR0911 - as `of`
        """Whether a value is certainly no whole number for Python, even one such as 5.0."""
        match node:
            case Number(text=text):
                return not is_whole(text)
            case Binary(operator="/", left=left, right=right):
                return {self.of(left), self.of(right)} <= NUMBERS
            case Binary(operator="+" | "-" | "*" | "//" | "%", left=left, right=right):
                is_number = {self.of(left), self.of(right)} <= NUMBERS
                return is_number and (self.has_decimals(left) or self.has_decimals(right))
            case Unary(operator="-" | "+", operand=operand):
                return self.has_decimals(operand)
            case Name(name=name):
                return name in self.fractions and self.of(node) is Type.NUMBER
            case Call(name=name):
                return name in _WITH_DECIMALS and self.findings.is_of_language(name)
        return False

    def is_rounded(self, node: Expression) -> bool:
        """Whether a number is calculated with decimals, which computers round."""
        match node:
            case Binary(operator="+" | "-" | "*", left=left, right=right):
                is_number = {self.of(left), self.of(right)} <= NUMBERS
                return is_number and (self._is_rough(left) or self._is_rough(right))
            case Unary(operator="-" | "+", operand=operand):
                return self.is_rounded(operand)
            case Name(name=name):
                return name in self.rounded and self.of(node) is Type.NUMBER
            case Call(name=name):
                return name in _ROUNDED and self.findings.is_of_language(name)
        return False

    def _is_rough(self, node: Expression) -> bool:
        """Whether a number, when it is calculated with, is not exact: 0.1, but not 0.5."""
        if isinstance(node, Number):
            value = value_of(node.text)
            if not isinstance(value, float) or not isfinite(value) or value.is_integer():
                return False
            return Fraction(node.text.replace("_", "")) != Fraction(value)
        return self.is_rounded(node)

    def work_out_rounded(self) -> None:
        """Find the variables that are calculated with decimals somewhere."""
        items = [item for item in self.findings.everything if isinstance(item, Assign)]
        for _ in range(_PASSES):
            before = set(self.rounded)
            for item in items:
                changes = item.operator in {"+=", "-=", "*="} and self._is_rough(item.value)
                if changes or (item.operator == "=" and self.is_rounded(item.value)):
                    self.rounded.update(set(set_by(item)) - self.hidden)
            if before == self.rounded:
                return

    def work_out_fractions(self) -> None:
        """Find the variables that hold numbers with decimals wherever they are set."""
        setting: dict[str, list[Item]] = {}
        for item in self.findings.everything:
            for name in set_by(item):
                setting.setdefault(name, []).append(item)
        for _ in range(_PASSES):
            fractions = {
                name
                for name, items in setting.items()
                if name not in self.hidden and all(map(self._sets_decimals, items))
            }
            if fractions == self.fractions:
                return
            self.fractions = fractions

    def _sets_decimals(self, item: Item) -> bool:
        if not isinstance(item, Assign):
            return False
        return item.operator == "/=" or (item.operator == "=" and self.has_decimals(item.value))

    def work_out(self) -> None:
        """Derive the types of the variables from each other until nothing changes."""
        setting = [
            (name, item)
            for item in self.findings.everything
            for name in set_by(item)
            if name not in self.hidden
        ]
        self.variables = dict.fromkeys((name for name, _ in setting), Type.UNSET)
        for _ in range(_PASSES):
            before = dict(self.variables)
            for name, item in setting:
                self.variables[name] = _joined(self.variables[name], self.of_assignment(item, name))
            if before == self.variables:
                return
        self.variables = {}

    def of_assignment(self, item: Item, name: str) -> Type:
        if isinstance(item, ForRange):
            return Type.NUMBER
        if isinstance(item, ForEach):
            is_letters = len(item.targets) == 1 and self.of(item.values) in TEXTS
            return Type.TEXT if is_letters else Type.UNKNOWN
        if not isinstance(item, Assign):
            return Type.UNKNOWN
        if item.operator == "=":
            return self.of(item.value)
        return self.of_sum(item.operator[:-1], self.variables[name], self.of(item.value))

    def of(self, node: Expression) -> Type:  # noqa: C901, PLR0911 - one for each expression
        """The type of an expression."""
        match node:
            case Number() | Unary(operator="-" | "+"):
                return Type.NUMBER
            case String() | FString():
                return Type.TEXT
            case List():
                return Type.LIST
            case Dictionary():
                return Type.DICTIONARY
            case Compare() | Unary():
                return Type.BOOLEAN
            case Constant(value=value):
                return Type.BOOLEAN if value is not None else Type.UNKNOWN
            case Name(name=name):
                return self.of_name(name)
            case Call(name=name):
                return self.of_call(name)
            case SkillCall(name=name):
                return self.of_skill(name)
            case Conditional():
                return _joined(self.of(node.yes), self.of(node.no))
            case Binary(operator="and" | "or"):
                return _joined(self.of(node.left), self.of(node.right))
            case Binary(operator=operator, left=left_side, right=right_side):
                return self.of_sum(operator, self.of(left_side), self.of(right_side))
        return Type.UNKNOWN

    def of_name(self, name: str) -> Type:
        if name in self.parameters or name in self.findings.functions:
            return Type.UNKNOWN
        return self.variables.get(name, Type.UNKNOWN)

    def of_call(self, name: str) -> Type:
        if name in self.findings.functions or name in self.hidden or self.findings.imports:
            return Type.UNKNOWN
        return _RESULTS.get(name, Type.UNKNOWN)

    def of_skill(self, name: str) -> Type:
        skill = self.findings.skills.get(name)
        return Type.UNKNOWN if skill is None or skill.returns_value else Type.NOTHING

    def of_sum(self, operator: str, left: Type, right: Type) -> Type:
        """The type of two operands with an arithmetic operator between them."""
        if Type.UNSET in {left, right}:
            return Type.UNSET
        if left in NUMBERS and right in NUMBERS:
            return Type.NUMBER
        if operator == "+" and left in TEXTS and right in TEXTS:
            return Type.TEXT
        if operator == "+" and left is right is Type.LIST:
            return Type.LIST
        # A sum that cannot be worked out stops the program with an error, so it has no type.
        return Type.UNSET if operator in {"+", "-"} and {left, right} <= KNOWN else Type.UNKNOWN


def _joined(first: Type, other: Type) -> Type:
    if first is Type.UNSET or first is other:
        return other
    if other is Type.UNSET:
        return first
    return Type.TEXT if first in TEXTS and other in TEXTS else Type.UNKNOWN


def _all_parameters(findings: Findings) -> set[str]:
    """The parameters of all functions: a variable of that name may be either."""
    return {
        name
        for item in findings.program.items
        if isinstance(item, Def)
        for name in (*item.parameters, *_loop_variables(item))
    }


def _loop_variables(function: Def) -> set[str]:
    """The variables of loops in a function, which are its own."""
    return {
        name
        for item in statements(function.body)
        if isinstance(item, ForEach | ForRange)
        for name in set_by(item)
    }
