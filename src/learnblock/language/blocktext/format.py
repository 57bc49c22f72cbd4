"""Write a tree as Block-Text in its canonical form: four spaces, one statement per line."""

from collections.abc import Mapping

from learnblock.language.tree import raw
from learnblock.language.tree.extents import Extent
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Blank,
    Call,
    Deactivate,
    Def,
    ForRange,
    Import,
    Index,
    Main,
    Node,
    Number,
    Program,
    Raw,
    RawExpression,
    Repeat,
    Setup,
    SkillCall,
    WaitUntil,
    When,
    While,
    WithoutRobot,
)
from learnblock.language.tree.strings import quote
from learnblock.language.tree.writer import ProgramWriter, comment_text


def format(program: Program) -> str:  # noqa: A001 - the usual name in formatters
    """Write a program in Block-Text; equal trees give equal text."""
    return _Writer().program(program)


def format_with_extents(program: Program) -> tuple[str, Mapping[int, Extent]]:
    """Write a program in Block-Text, with the lines of each statement by the `id()` of its node."""
    writer = _Writer()
    return writer.program(program), writer.extents


class _Writer(ProgramWriter):
    def program(self, program: Program) -> str:
        main = () if program.main is None else (program.main,)
        self.in_order((*program.items, *main, *program.ending))
        return "\n".join([*self.lines, ""]) if self.lines else ""

    def line(self, text: str, _: Node | None = None, comment: str | None = None) -> None:
        end = "" if comment is None else "  " + comment_text(comment)
        self.lines.append(f"{self.indent}{text}{end}")

    def blank(self, _: Blank | None = None) -> None:
        self.lines.append("")

    def close(self) -> None:
        self.line("end")

    def assign(self, node: Assign) -> None:
        word = "local " if node.is_local else ""
        target, value = self.expression(node.target), self.expression(node.value)
        self.line(f"{word}{target} {node.operator} {value}", node, node.comment)

    def while_loop(self, node: While) -> None:
        if node.is_endless:
            self.closed("forever", node)
        else:
            super().while_loop(node)

    def repeat(self, node: Repeat) -> None:
        self.closed(f"repeat {self.count(node)}", node)

    def count(self, node: Repeat) -> str:
        """The count, in brackets if it would be read as an index: ``repeat [1][0]:``."""
        text = self.expression(node.count)
        return f"({text})" if text.startswith("[") else text

    def for_range(self, node: ForRange) -> None:
        header = (
            f"for {node.target.name} from {self.expression(node.start)} "
            f"to {self.expression(node.stop)}"
        )
        if node.step is not None:
            header += f" step {self.expression(node.step)}"
        self.closed(header, node)

    def wait_until(self, node: WaitUntil) -> None:
        self.line(f"wait until {self.expression(node.condition)}", node, node.comment)

    def activation(self, node: Activate | Deactivate) -> None:
        self.line(f"{type(node).__name__.lower()} {node.name}", node, node.comment)

    def raw_block(self, node: Raw) -> None:
        self.line("python:")
        self.lines.extend(raw.written(node.text, self.indent + "    "))
        self.close()

    def without_robot(self, node: WithoutRobot) -> None:
        self.line("without robot", node)

    def import_(self, node: Import) -> None:
        self.line(f"import {quote(node.module)}", node, node.comment)

    def setup(self, node: Setup) -> None:
        self.line(f"robot({self.arguments(node.arguments, node.keywords)})", node, node.comment)

    def definition(self, node: Def) -> None:
        header = f"def {node.name}({', '.join(node.parameters)})"
        self.closed(header, node)

    def when(self, node: When) -> None:
        condition = "" if node.condition is None else f" = {self.expression(node.condition)}"
        self.closed(f"when {node.name}{condition}", node)

    def main(self, node: Main) -> None:
        self.block("main", node.body, node, None)
        self.close()

    def call(self, node: Call, _: int) -> str:
        return f"{node.name}({self.arguments(node.arguments, node.keywords)})"

    def skill_call(self, node: SkillCall, _: int) -> str:
        return f"function.{node.name}({self.arguments(node.arguments, node.keywords)})"

    def raw(self, node: RawExpression, _: int) -> str:
        return self.python(node.text)

    def python(self, text: str) -> str:
        return "`" + text.replace("`", "``") + "`"

    def index(self, node: Index, level: int) -> str:
        # Unlike in Python, a number before a bracket needs no brackets.
        if isinstance(node.value, Number):
            return f"{node.value.text}[{self.expression(node.index)}]"
        return super().index(node, level)
