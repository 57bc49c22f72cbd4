"""Read expressions of Python; those without an equivalent in Block-Text remain raw Python."""

import ast
from collections.abc import Callable

from learnblock.language.blocktext import names
from learnblock.language.blocktext.names import state_of
from learnblock.language.blocktext.nested_reader import MAX_HEIGHT
from learnblock.language.python.quotes import are_for_every_python
from learnblock.language.tree import texts
from learnblock.language.tree.builtins import TEMPLATES, is_builtin, recognized
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
    Span,
    String,
    Unary,
)
from learnblock.language.tree.traversal import moved

BINARY: dict[type[ast.operator], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "//",
    ast.Mod: "%",
    ast.Pow: "**",
}
_UNARY: dict[type[ast.unaryop], str] = {ast.Not: "not", ast.USub: "-", ast.UAdd: "+"}
_COMPARE: dict[type[ast.cmpop], str] = {
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.Lt: "<",
    ast.Gt: ">",
    ast.LtE: "<=",
    ast.GtE: ">=",
    ast.In: "in",
    ast.NotIn: "not in",
}
# Trees of this height stay within the parser's limit when they are written as Block-Text.
_MAX_HEIGHT = MAX_HEIGHT - 20


class Unlike(Exception):  # noqa: N818 - not an error: such Python stays raw Python
    """This Python has no equivalent in Block-Text."""


class ExpressionReader:
    """Reads expressions.

    Args:
        lines: the lines of the file.
        whens: the names in Block-Text of the ``when``s, by their names in Python.
        functions: the names in Block-Text of the user's functions.

    `robot` is the robot's name in Python; None where no call is one of a skill.
    """

    robot: str | None = "robot"

    def __init__(self, lines: list[str], whens: dict[str, str], functions: frozenset[str]) -> None:
        self.lines, self.whens, self.functions = lines, whens, functions
        self.when_names = frozenset(whens.values())
        self.height = 0  # the height, so far, of the expression being read

    def is_robot(self, node: ast.expr) -> bool:
        return isinstance(node, ast.Name) and node.id == self.robot

    def called(self, name: str) -> str:
        """The name in Block-Text of a function."""
        plain = names.from_python(name)
        if plain is None or name in self.whens:
            raise Unlike
        return plain

    def identifier(self, name: str) -> str:
        plain = names.from_python(name)
        if plain is None or name in self.whens or state_of(plain, self.when_names):
            raise Unlike
        return plain

    def expression(self, node: ast.expr) -> Expression:
        self.height += 1
        try:
            return self.exact(node) if self.height < _MAX_HEIGHT else self.raw(node)
        except Unlike:
            return self.raw(node)
        finally:
            self.height -= 1

    def exact(self, node: ast.expr) -> Expression:  # noqa: PLR0911 - one for each kind
        span = span_of(node)
        match node:
            case ast.Constant():
                return self.constant(node, span)
            case ast.Name(id=name):
                return Name(self.identifier(name), span)
            case ast.BinOp(left=left, op=operator, right=right) if type(operator) in BINARY:
                symbol = BINARY[type(operator)]
                return Binary(symbol, self.expression(left), self.expression(right), span)
            case ast.BoolOp(op=operator, values=values):
                return self.logic("and" if isinstance(operator, ast.And) else "or", values)
            case ast.UnaryOp(op=operator, operand=operand) if type(operator) in _UNARY:
                return Unary(_UNARY[type(operator)], self.expression(operand), span)
            case ast.Compare():
                return self.comparison(node, span)
            case _:
                return self.composed(node, span)

    def composed(self, node: ast.expr, span: Span) -> Expression:
        match node:
            case ast.List(elts=items):
                return List(tuple(self.argument(item) for item in items), span)
            case ast.Dict(keys=keys, values=values):
                return self.dictionary(keys, values, span)
            case ast.JoinedStr(values=values):
                return self.f_string(values, span)
            case ast.IfExp(test=test, body=yes, orelse=no):
                return Conditional(
                    self.expression(yes), self.expression(test), self.expression(no), span
                )
        return self.access(node, span)

    def access(self, node: ast.expr, span: Span) -> Expression:
        match node:
            case ast.Attribute(value=ast.Name(id=name), attr="active" | "time" as attribute) if (
                name in self.whens
            ):
                prefix = "state_" if attribute == "active" else "time_"
                return Name(prefix + self.whens[name], span)
            case ast.Call(func=ast.Attribute(value=owner, attr=name)) if self.is_robot(owner):
                return self.skill_call(node, name, span)
            case ast.Subscript(value=value, slice=index) if not isinstance(
                index, ast.Slice | ast.Tuple
            ):
                return Index(self.expression(value), self.expression(index), span)
        return self.library_call(node, span) or self.call(node, span)

    def constant(self, node: ast.Constant, span: Span) -> Expression:
        value = node.value
        if value is None or isinstance(value, bool):
            return Constant(value, span)
        if isinstance(value, str):
            return String(value, span)
        if isinstance(value, int | float):
            return Number(self.segment(node), span)
        raise Unlike

    def dictionary(
        self, keys: list[ast.expr | None], values: list[ast.expr], span: Span
    ) -> Dictionary:
        known = [key for key in keys if key is not None]
        if len(known) < len(values):
            raise Unlike
        return Dictionary(
            tuple(map(self.expression, known)), tuple(map(self.expression, values)), span
        )

    def f_string(self, values: list[ast.expr], span: Span) -> FString:
        if span.line != span.end_line:
            return self.long_f_string(values, span)
        joined = texts.f_string(map(self.part, values), span)
        if joined is None:
            raise Unlike
        return joined

    def long_f_string(self, values: list[ast.expr], span: Span) -> FString:
        """An f-string on several lines, of which Python 3.11 doesn't know where its values are."""
        text = _on_one_line(ast.JoinedStr(values))
        reader = ExpressionReader([text], self.whens, self.functions)
        match ast.parse(text, mode="eval").body:
            case ast.JoinedStr(values=pieces):
                return moved(reader.f_string(pieces, Span(1, 1, 1)), span)
        raise Unlike

    def part(self, node: ast.expr) -> Expression:
        """A text or a value of an f-string."""
        match node:
            case ast.Constant(value=str(value)):
                return String(value, span_of(node))
            case ast.FormattedValue(value=value, conversion=-1, format_spec=None) if not (
                isinstance(value, ast.Constant) and isinstance(value.value, str)
            ):
                return self.expression(value)
        raise Unlike

    def logic(self, operator: str, values: list[ast.expr]) -> Expression:
        if self.height + len(values) > _MAX_HEIGHT:
            raise Unlike
        result = self.expression(values[0])
        for value in values[1:]:
            right = self.expression(value)
            first, last = result.span, right.span
            span = Span(first.line, first.column, last.end_line, last.end_column)
            result = Binary(operator, result, right, span)
        return result

    def comparison(self, node: ast.Compare, span: Span) -> Compare:
        operators = [_COMPARE.get(type(operator)) for operator in node.ops]
        known = tuple(operator for operator in operators if operator is not None)
        if len(known) < len(operators):
            raise Unlike
        operands = (node.left, *node.comparators)
        return Compare(known, tuple(self.expression(operand) for operand in operands), span)

    def skill_call(self, node: ast.Call, name: str, span: Span) -> Call | SkillCall:
        arguments, keywords = self.arguments(node, names.attribute_from_python)
        if name == "elapsedTime":
            if name in self.functions:
                raise Unlike
            return Call(name, arguments, keywords, span)
        return SkillCall(names.attribute_from_python(name), arguments, keywords, span)

    def library_call(self, node: ast.expr, span: Span) -> Expression | None:
        match = recognized(node)
        if match is None:
            return None
        template, parts = match
        if template.name in self.functions:
            raise Unlike
        return Call(template.name, tuple(self.expression(part) for part in parts), (), span)

    def call(self, node: ast.expr, span: Span) -> Call:
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
            raise Unlike
        python_name = node.func.id
        if is_builtin(python_name, len(node.args)):
            if python_name in self.functions:
                raise Unlike
            arguments, keywords = self.arguments(node, names.attribute_from_python)
            return Call(python_name, arguments, keywords, span)
        name = self.called(python_name)
        arguments, keywords = self.arguments(node, names.keyword_from_python)
        if [names.to_python(keyword.name) for keyword in keywords] != [
            keyword.arg for keyword in node.keywords
        ]:
            raise Unlike
        if name not in self.functions and self.means_another(name, arguments, keywords):
            raise Unlike
        return Call(name, arguments, keywords, span)

    @staticmethod
    def means_another(
        name: str, arguments: tuple[Expression, ...], keywords: tuple[Keyword, ...]
    ) -> bool:
        """Whether a call of `name` would be a call of a library function in Block-Text."""
        if name == "elapsedTime" or is_builtin(name, len(arguments)):
            return True
        return not keywords and (name, len(arguments)) in TEMPLATES

    def arguments(
        self, node: ast.Call, rename: Callable[[str], str]
    ) -> tuple[tuple[Expression, ...], tuple[Keyword, ...]]:
        arguments = tuple(self.argument(argument) for argument in node.args)
        keywords = tuple(self.keyword(keyword, rename) for keyword in node.keywords)
        return arguments, keywords

    def keyword(self, node: ast.keyword, rename: Callable[[str], str]) -> Keyword:
        if node.arg is None:
            raise Unlike
        return Keyword(rename(node.arg), self.expression(node.value), span_of(node))

    def argument(self, node: ast.expr) -> Expression:
        if isinstance(node, ast.Starred):
            raise Unlike
        return self.expression(node)

    def raw(self, node: ast.expr) -> RawExpression:
        text = self.one_line(node)
        if isinstance(node, ast.Yield | ast.YieldFrom | ast.NamedExpr):
            # Python's tree omits their brackets, which are needed in most places.
            text = f"({text})"
        return RawExpression(text, span_of(node))

    def one_line(self, node: ast.stmt | ast.expr) -> str:
        """The source of a node on a single line; that of another, written on one line."""
        return self.segment(node) if node.end_lineno == node.lineno else _on_one_line(node)

    def segment(self, node: ast.stmt | ast.expr) -> str:
        """The source of a node on a single line."""
        end = node.end_col_offset
        if node.end_lineno != node.lineno or end is None:
            raise Unlike
        line = self.lines[node.lineno - 1]
        if line.isascii():
            return line[node.col_offset : end]
        return line.encode()[node.col_offset : end].decode()


def _on_one_line(node: ast.AST) -> str:
    text = ast.unparse(node)
    if "\n" in text or not are_for_every_python(text):
        raise Unlike
    return text


def start_of(node: ast.stmt) -> int:
    decorators = getattr(node, "decorator_list", None)
    return (
        min([node.lineno, *(decorator.lineno for decorator in decorators)])
        if decorators
        else node.lineno
    )


def end_of(node: ast.stmt) -> int:
    return node.end_lineno or node.lineno


def span_of(node: ast.stmt | ast.expr | ast.keyword) -> Span:
    start = start_of(node) if isinstance(node, ast.stmt) else node.lineno
    end, column = node.end_lineno or start, node.end_col_offset or 0
    return Span(start, node.col_offset + 1, end, column + 1)
