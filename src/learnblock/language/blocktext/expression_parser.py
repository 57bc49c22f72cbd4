"""Parse expressions of Block-Text by precedence climbing, with the precedence of Python."""

import re
from collections.abc import Callable

from learnblock.errors import EscapeError
from learnblock.i18n import Phrase
from learnblock.language.blocktext import open_brackets, slips
from learnblock.language.blocktext.dictionary_parser import dictionary
from learnblock.language.blocktext.f_string_parser import bad_f_string, f_string
from learnblock.language.blocktext.lexer import KEYWORDS, LINE_ENDS, Token
from learnblock.language.blocktext.nested_reader import LOOSEST, MAX_HEIGHT, NestedReader
from learnblock.language.blocktext.open_brackets import CLOSING
from learnblock.language.blocktext.slips import Slip, symbol
from learnblock.language.blocktext.token_reader import new
from learnblock.language.tree.characters import write_instead
from learnblock.language.tree.nodes import (
    Binary,
    Call,
    Compare,
    Conditional,
    Constant,
    Expression,
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
from learnblock.language.tree.strings import unquote

MAX_DIGITS = 1000

_LEVELS = {
    "if": 0,
    "or": 1,
    "and": 2,
    "not": 4,  # of `not in`
    "in": 4,
    "==": 4,
    "!=": 4,
    "<": 4,
    ">": 4,
    "<=": 4,
    ">=": 4,
    "+": 5,
    "-": 5,
    "*": 6,
    "/": 6,
    "//": 6,
    "%": 6,
    "**": 8,
}
OPERATORS = frozenset(_LEVELS) - {"if"}
_OR = 1
_NOT, _COMPARE, _SIGN, _POWER = 3, 4, 7, 8
_CONSTANTS = {"True": True, "False": False, "None": None}
NUMBER = re.compile(
    r"0[xX](?:_?[0-9a-fA-F])+|0[bB](?:_?[01])+|0[oO](?:_?[0-7])+"
    r"|0(?:_?0)*|[1-9](?:_?[0-9])*"
    r"|(?:[0-9](?:_?[0-9])*)?\.[0-9](?:_?[0-9])*(?:[eE][-+]?[0-9](?:_?[0-9])*)?"
    r"|[0-9](?:_?[0-9])*\.(?:[eE][-+]?[0-9](?:_?[0-9])*)?"
    r"|[0-9](?:_?[0-9])*[eE][-+]?[0-9](?:_?[0-9])*"
)
_AFTER_NAME = frozenset((".", "string"))
_SQUARE_BRACKET = symbol("]")
_DOT_AND_SKILL = Phrase("blocktext-wanted-dot-and-skill")


class ExpressionParser(NestedReader):
    """Reads expressions of all kinds."""

    def expression(self, level: int = LOOSEST) -> Expression:
        kinds = self.kinds
        kind = kinds[self.index]
        atom = _ATOMS.get(kind)
        if atom is None:
            left = self.prefixed(kind, level)
        else:
            left = atom(self, self.tokens[self.index])
            if kinds[self.index] == "[":
                left = self.indexed(left)
        while True:
            operator = kinds[self.index]
            binding = _LEVELS.get(operator)
            if binding is None or binding < level:
                return left
            if binding == _COMPARE:
                if operator == "not" and kinds[self.index + 1] != "in":
                    return left
                left = self.comparison(left)
                continue
            if binding == LOOSEST:
                left = self.conditional(left)
                continue
            height = self.height
            if height >= MAX_HEIGHT:
                raise self.slip(
                    "too-deep", Phrase("blocktext-too-many-operators", limit=MAX_HEIGHT)
                )
            self.index += 1
            right = self.exponent() if binding == _POWER else self.expression(binding + 1)
            self.grow(height)
            left = Binary(operator, left, right, _joined(left.span, right.span))

    def exponent(self) -> Expression:
        self.nest()
        exponent = self.expression(_SIGN)
        self.nesting -= 1
        return exponent

    def prefixed(self, kind: str, level: int) -> Expression:
        token = self.tokens[self.index]
        if kind not in {"-", "+", "not"}:
            raise self.no_value()
        if kind == "not" and level > _NOT:
            raise self.slip("not-needs-brackets", Phrase("blocktext-not-needs-brackets"))
        self.index += 1
        self.nest()
        operand = self.expression(_NOT if kind == "not" else _SIGN)
        self.nesting -= 1
        self.grow(0)
        last = operand.span
        span = Span(token.line, token.column, last.end_line, last.end_column)
        return Unary(kind, operand, span)

    def comparison(self, left: Expression) -> Compare:
        operators: list[str] = []
        operands = [left]
        while True:
            operator = self.kinds[self.index]
            if operator == "not" and self.kinds[self.index + 1] == "in":
                self.index += 1
                operator = "not in"
            elif _LEVELS.get(operator) != _COMPARE or operator == "not":
                break
            height = self.height
            self.index += 1
            operators.append(operator)
            operands.append(self.expression(_COMPARE + 1))
            self.height = max(height, self.height)
        self.grow(0)
        span = _joined(left.span, operands[-1].span)
        return Compare(tuple(operators), tuple(operands), span)

    def conditional(self, yes: Expression) -> Conditional:
        height, word = self.height, self.token
        self.index += 1
        self.nest()
        condition = self.expression(_OR)
        if self.kinds[self.index] != "else":
            raise slips.no_else(word, self.token)
        height = max(height, self.height)
        self.index += 1
        no = self.expression()
        self.nesting -= 1
        self.grow(height)
        return Conditional(yes, condition, no, _joined(yes.span, no.span))

    def postfix(self, token: Token) -> Expression:
        value = self.skill_call(token) if token.kind == "function" else self.name(token)
        return self.indexed(value) if self.kinds[self.index] == "[" else value

    def indexed(self, value: Expression) -> Expression:
        while self.kinds[self.index] == "[":
            height = self.height
            self.index += 1
            self.nest()
            index = self.expression()
            self.nesting -= 1
            if self.kinds[self.index] == ":":
                raise self.slip("slice", Phrase("blocktext-slice"))
            close = self.expect("]", _SQUARE_BRACKET)
            self.grow(height)
            first = value.span
            value = Index(
                value, index, Span(first.line, first.column, close.line, close.column + 1)
            )
        return value

    def name(self, token: Token) -> Expression:
        _, text, line, column = token
        self.index += 1
        if self.kinds[self.index] != "(":
            self.height = 1
            if self.kinds[self.index] in _AFTER_NAME:
                raise slips.odd_name(token, self.token, self.tokens[self.index + 1])
            return name_of(token)
        arguments, keywords = self.arguments()
        close = self.tokens[self.index - 1]
        return Call(
            text, arguments, keywords, new(Span, (line, column, close.line, close.column + 1))
        )

    def skill_call(self, token: Token) -> Call | SkillCall:
        self.index += 1
        self.expect(".", _DOT_AND_SKILL)
        name = self.token
        if name.kind != "name" and name.kind not in KEYWORDS:
            raise self.unexpected(Phrase("blocktext-wanted-skill"))
        self.index += 1
        if self.kinds[self.index] != "(":
            message = Phrase("blocktext-call-needs-brackets", skill=name.text)
            raise self.slip("missing-brackets", message, name)
        arguments, keywords = self.arguments()
        close = self.tokens[self.index - 1]
        span = new(Span, (token.line, token.column, close.line, close.column + 1))
        # elapsedTime belongs to the language, but is a method of the robot in Python.
        node = Call if name.text == "elapsedTime" else SkillCall
        return node(name.text, arguments, keywords, span)

    def arguments(self) -> tuple[tuple[Expression, ...], tuple[Keyword, ...]]:
        opening = self.token
        self.index += 1
        if self.kinds[self.index] == ")":
            self.index += 1
            self.height = 1
            return (), ()
        self.nest()
        arguments: list[Expression] = []
        keywords: list[Keyword] = []
        height = 0
        while True:
            self.argument(arguments, keywords)
            height = max(height, self.height)
            if not self.another(opening, ")"):
                break
        self.nesting -= 1
        self.height = height
        self.grow(0)
        return tuple(arguments), tuple(keywords)

    def argument(self, arguments: list[Expression], keywords: list[Keyword]) -> None:
        token = self.tokens[self.index]
        if self.kinds[self.index + 1] == "=" and (token.kind == "name" or token.kind in KEYWORDS):
            self.index += 2
            if any(keyword.name == token.text for keyword in keywords):
                message = Phrase("blocktext-duplicate-argument", name=token.text)
                raise self.slip("duplicate-argument", message, token)
            value = self.expression()
            last = value.span
            span = Span(token.line, token.column, last.end_line, last.end_column)
            keywords.append(Keyword(token.text, value, span))
            return
        if keywords:
            message = Phrase("blocktext-argument-order", name=keywords[0].name)
            raise self.slip("argument-order", message, token)
        arguments.append(self.expression())

    def no_value(self) -> Slip:
        """The slip at a token that begins no value."""
        if self.kinds[self.index] in LINE_ENDS and self.before.kind in {",", *CLOSING}:
            return self.unclosed_below()
        return slips.no_value(self.token, self.before, OPERATORS)

    def unclosed_below(self) -> Slip:
        """The slip of a bracket that is never closed, with its values on the lines below."""
        tokens, line = self.tokens, self.line_before()
        end = open_brackets.end_of_values(tokens, self.index)
        values = tokens[self.index : end]
        brackets = open_brackets.opened([*line, *values]) or open_brackets.opened(line)
        if not values:
            instead, missing = self.closed_line()
            more = {"closing": missing, "instead": instead}
            message = Phrase(
                "blocktext-unclosed-bracket-in-line", opening=brackets[-1].text, **more
            )
        else:
            # The lines below have been understood, so they are not read as statements.
            self.kinds[self.index : end] = ["continued"] * len(values)
            last = tokens[end - 1]
            below = self.lines[last.line - 1][: last.column - 1] + last.text
            message = Phrase(
                "blocktext-unclosed-bracket-below",
                opening=brackets[-1].text,
                closing=open_brackets.closing(brackets),
                last=str(last.line),
                instead=below.strip().removesuffix(",") + open_brackets.closing(brackets),
            )
        return self.slip("unclosed-bracket", message, brackets[-1])

    def parenthesized(self, token: Token) -> Expression:
        self.index += 1
        self.nest()
        value = self.expression()
        self.nesting -= 1
        if self.kinds[self.index] != ")":
            raise self.unclosed_bracket(token, ")", self.unexpected(symbol(")")))
        self.index += 1
        return value

    def list(self, token: Token) -> List:
        self.index += 1
        items: list[Expression] = []
        height = 0
        self.nest()
        if self.kinds[self.index] == "]":
            self.index += 1
        else:
            items.append(self.expression())
            height = self.height
            while self.another(token, "]"):
                items.append(self.expression())
                height = max(height, self.height)
        self.nesting -= 1
        self.height = height
        self.grow(0)
        close = self.tokens[self.index - 1]
        span = Span(token.line, token.column, close.line, close.column + 1)
        return List(tuple(items), span)

    def constant(self, token: Token) -> Constant:
        kind, _, line, column = token
        self.index += 1
        self.height = 1
        return Constant(_CONSTANTS[kind], new(Span, (line, column, line, column + len(kind))))

    def number(self, token: Token) -> Number:
        _, text, line, column = token
        self.index += 1
        self.height = 1
        if not (text.isdecimal() and text[0] != "0" and len(text) < MAX_DIGITS):
            self.check_number(token)
        if self.kinds[self.index] == "name":
            self.check_unit(token, self.token)
        return Number(text, new(Span, (line, column, line, column + len(text))))

    def check_number(self, token: Token) -> None:
        text = token.text
        if len(text) >= MAX_DIGITS:
            message = Phrase("blocktext-number-too-long", digits=len(text), limit=MAX_DIGITS)
            raise self.slip("bad-number", message, token)
        if not NUMBER.fullmatch(text):
            plain = text.lstrip("0_")
            if text[0] == "0" and plain.isdecimal():
                raise self.slip("bad-number", write_instead(text, plain), token)
            raise self.slip("bad-number", Phrase("blocktext-bad-number", text=text), token)

    def check_unit(self, number: Token, name: Token) -> None:
        if name.line == number.line and name.column == number.column + len(number.text):
            message = Phrase("blocktext-number-with-letters", text=number.text + name.text)
            raise self.slip("bad-number", message, number)

    def string(self, token: Token) -> String:
        _, text, line, column = token
        self.index += 1
        self.height = 1
        if self.kinds[self.index] == "string":
            raise slips.two_strings(token, self.token)
        span = new(Span, (line, column, line, column + len(text)))
        return String(self.unquoted(token), span)

    def unquoted(self, token: Token) -> str:
        try:
            return unquote(token.text)
        except EscapeError as error:
            raise self.slip("bad-escape", error.phrase, token) from None

    def raw_expression(self, token: Token) -> RawExpression:
        self.index += 1
        self.height = 1
        span = Span(token.line, token.column, token.line, token.column + len(token.text))
        return RawExpression(python_of(token), span)


# How an expression is read, by the kind of its first token.
_ATOMS: dict[str, Callable[[ExpressionParser, Token], Expression]] = {
    "number": ExpressionParser.number,
    "string": ExpressionParser.string,
    "f-string": f_string,
    "f-bad": bad_f_string,
    "name": ExpressionParser.name,
    "function": ExpressionParser.skill_call,
    "True": ExpressionParser.constant,
    "False": ExpressionParser.constant,
    "None": ExpressionParser.constant,
    "(": ExpressionParser.parenthesized,
    "[": ExpressionParser.list,
    "{": dictionary,
    "raw": ExpressionParser.raw_expression,
}


def python_of(token: Token) -> str:
    """The Python between the backticks of a token."""
    return token.text[1:-1].replace("``", "`")


def name_of(token: Token) -> Name:
    """The variable named by a token."""
    _, text, line, column = token
    return Name(text, new(Span, (line, column, line, column + len(text))))


def _joined(first: Span, last: Span) -> Span:
    return new(Span, (first.line, first.column, last.end_line, last.end_column))
