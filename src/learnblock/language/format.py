"""A tree as Block-Text, in its one canonical spelling: four spaces, one statement a line."""

from collections.abc import Callable
from typing import Any

from learnblock.language import raw
from learnblock.language.expressions import ExpressionWriter
from learnblock.language.layout import placed
from learnblock.language.nodes import (
    Activate,
    Assign,
    Blank,
    Body,
    Break,
    Call,
    Comment,
    Continue,
    Deactivate,
    Def,
    ForEach,
    ForRange,
    If,
    Import,
    Index,
    Item,
    Main,
    Number,
    Pass,
    Perform,
    Program,
    Raw,
    RawExpression,
    Repeat,
    Return,
    Setup,
    SkillCall,
    When,
    While,
)
from learnblock.language.strings import quote


def format(program: Program) -> str:  # noqa: A001 - the verb that every formatter has
    """A program in Block-Text; the same tree always gives the same text."""
    return _Writer().program(program)


def comment_text(text: str) -> str:
    """A comment's text with its ``#``."""
    if not text:
        return "#"
    return f"#{text}" if text[0] in "#!:" else f"# {text}"


class _Writer(ExpressionWriter):
    def __init__(self) -> None:
        super().__init__()
        self.lines: list[str] = []
        self.indent = ""
        self.items: dict[type[Item | Main], Callable[[Any], None]] = {
            Comment: lambda node: self.line(comment_text(node.text)),
            Blank: lambda _: self.lines.append(""),
            Perform: lambda node: self.line(self.expression(node.call), node.comment),
            Assign: self.assign,
            If: self.if_chain,
            While: self.while_loop,
            Repeat: self.repeat,
            ForEach: self.for_each,
            ForRange: self.for_range,
            Break: lambda node: self.line("break", node.comment),
            Continue: lambda node: self.line("continue", node.comment),
            Return: self.return_,
            Pass: lambda node: self.line("pass", node.comment),
            Activate: lambda node: self.line(f"activate {node.name}", node.comment),
            Deactivate: lambda node: self.line(f"deactivate {node.name}", node.comment),
            Raw: self.raw_block,
            Import: lambda node: self.line(f"import {quote(node.module)}", node.comment),
            Setup: self.setup,
            Def: self.definition,
            When: self.when,
            Main: lambda node: self.block("main", node.body),
        }

    def program(self, program: Program) -> str:
        main = () if program.main is None else (program.main,)
        for item, apart, blank, _ in placed((*program.items, *main, *program.ending)):
            if apart or blank:
                self.lines.append("")
            self.items[type(item)](item)
        return "\n".join([*self.lines, ""]) if self.lines else ""

    def line(self, text: str, comment: str | None = None) -> None:
        end = "" if comment is None else "  " + comment_text(comment)
        self.lines.append(f"{self.indent}{text}{end}")

    def block(self, header: str, body: Body, comment: str | None = None) -> None:
        self.branch(header, body, comment)
        self.line("end")

    def branch(self, header: str, body: Body, comment: str | None) -> None:
        self.line(header + ":", comment)
        outer, self.indent = self.indent, self.indent + "    "
        for statement in body or (Pass(),):
            self.items[type(statement)](statement)
        self.indent = outer

    def assign(self, node: Assign) -> None:
        target = self.expression(node.target)
        self.line(f"{target} {node.operator} {self.expression(node.value)}", node.comment)

    def if_chain(self, node: If) -> None:
        word = "if"
        for branch in node.branches:
            condition = self.expression(branch.condition)
            self.branch(f"{word} {condition}", branch.body, branch.comment)
            word = "elif"
        if node.otherwise is not None:
            self.branch("else", node.otherwise.body, node.otherwise.comment)
        self.line("end")

    def while_loop(self, node: While) -> None:
        self.block(f"while {self.expression(node.condition)}", node.body, node.comment)

    def repeat(self, node: Repeat) -> None:
        self.block(f"repeat {self.count(node)}", node.body, node.comment)

    def count(self, node: Repeat) -> str:
        """`repeat [1][0]:` would read as an index, so a count that begins so goes in brackets."""
        text = self.expression(node.count)
        return f"({text})" if text.startswith("[") else text

    def for_each(self, node: ForEach) -> None:
        header = f"for {node.target.name} in {self.expression(node.values)}"
        self.block(header, node.body, node.comment)

    def for_range(self, node: ForRange) -> None:
        header = (
            f"for {node.target.name} from {self.expression(node.start)} "
            f"to {self.expression(node.stop)}"
        )
        if node.step is not None:
            header += f" step {self.expression(node.step)}"
        self.block(header, node.body, node.comment)

    def return_(self, node: Return) -> None:
        value = "" if node.value is None else " " + self.expression(node.value)
        self.line(f"return{value}", node.comment)

    def raw_block(self, node: Raw) -> None:
        self.line("python:")
        self.lines.extend(raw.written(node.text, self.indent + "    "))
        self.line("end")

    def setup(self, node: Setup) -> None:
        self.line(f"robot({self.arguments(node.arguments, node.keywords)})", node.comment)

    def definition(self, node: Def) -> None:
        header = f"def {node.name}({', '.join(node.parameters)})"
        self.block(header, node.body, node.comment)

    def when(self, node: When) -> None:
        condition = "" if node.condition is None else f" = {self.expression(node.condition)}"
        self.block(f"when {node.name}{condition}", node.body, node.comment)

    def call(self, node: Call, _: int) -> str:
        return f"{node.name}({self.arguments(node.arguments, node.keywords)})"

    def skill_call(self, node: SkillCall, _: int) -> str:
        return f"function.{node.name}({self.arguments(node.arguments, node.keywords)})"

    def raw(self, node: RawExpression, _: int) -> str:
        return "`" + node.text.replace("`", "``") + "`"

    def index(self, node: Index, level: int) -> str:
        # A number before a bracket needs no brackets of its own here.
        if isinstance(node.value, Number):
            return f"{node.value.text}[{self.expression(node.index)}]"
        return super().index(node, level)
