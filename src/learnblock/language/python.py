"""A tree as Python: the program that a good teacher would write."""

import re
from collections.abc import Callable, Iterator
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from typing import Any

from learnblock.language import markers, names, ranges
from learnblock.language.expressions import LOOSEST, SIGN, TIGHTEST, ExpressionWriter
from learnblock.language.format import comment_text
from learnblock.language.layout import placed, prologue_length
from learnblock.language.library import MODULES, TEMPLATES, is_builtin
from learnblock.language.nodes import (
    Activate,
    Assign,
    Binary,
    Blank,
    Body,
    Break,
    Call,
    Comment,
    Constant,
    Continue,
    Deactivate,
    Def,
    Expression,
    ForEach,
    ForRange,
    If,
    Import,
    Index,
    Item,
    Main,
    Name,
    Node,
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
    Statement,
    Unary,
    When,
    While,
    statements,
)
from learnblock.language.source_map import SourceMap

DEFAULT_ROBOT = "learnblock.robots.sim_ebo"
ROBOT_IMPORT = re.compile(r"^from[ \t]+([\w.]+)[ \t]+import[ \t]+Robot\b", re.MULTILINE)
_RAW_ATOM = re.compile(r"[^\W\d]\w*(?:\.[^\W\d]\w*)*")


@dataclass(frozen=True, slots=True)
class PythonText:
    """Python and where each of its lines comes from."""

    text: str
    source_map: SourceMap


def to_python(program: Program, robot_module: str | None = DEFAULT_ROBOT) -> PythonText:
    """A program in Python, for one robot.

    Args:
        program: one that was read from Python is given back as it was, but for the robot's import.
        robot_module: the module from which ``Robot`` is imported, the one thing that differs
            between robots; None keeps the one that the program was read with.
    """
    if program.python is not None:
        return _kept(program, program.python, robot_module)
    if _is_raw(program):
        return _kept(program, program.items[0].text, None)  # type: ignore[union-attr]
    return canonical(program, robot_module or DEFAULT_ROBOT)


def canonical(program: Program, robot_module: str) -> PythonText:
    """A program in Python as we spell it, whatever it was read from."""
    writer = _Writer(program, frozenset())
    text = writer.program(robot_module)
    if writer.clashes:
        writer = _Writer(program, frozenset(writer.clashes))
        text = writer.program(robot_module)
    return PythonText(text, SourceMap(tuple(writer.sources), tuple(writer.nodes)))


def _is_raw(program: Program) -> bool:
    return len(program.items) == 1 and program.main is None and isinstance(program.items[0], Raw)


def _kept(program: Program, text: str, robot_module: str | None) -> PythonText:
    if robot_module is not None:
        text = ROBOT_IMPORT.sub(
            lambda match: match[0].replace(match[1], robot_module, 1), text, count=1
        )
    lines = text.count("\n") + (not text.endswith("\n"))
    sources: list[int] = [0] * lines
    nodes: list[Node | None] = [None] * lines
    raw_only = _is_raw(program) and program.python is None
    for line, source, node in _raw_lines(program) if raw_only else _read_lines(program):
        if line <= lines and not sources[line - 1]:
            sources[line - 1], nodes[line - 1] = source, node
    return PythonText(text, SourceMap(tuple(sources), tuple(nodes)))


def _raw_lines(program: Program) -> Iterator[tuple[int, int, Node]]:
    """The lines of a program that is all raw Python: its first stands below ``python:``."""
    node = program.items[0]
    assert isinstance(node, Raw)  # noqa: S101 - the caller has asked
    below = node.span.line + (1 if node.span.line else 0)
    from_python = node.span.end_column == 0
    for index in range(node.text.count("\n") + 1):
        yield index + 1, (index + 1 if from_python else below + index), node


def _read_lines(program: Program) -> Iterator[tuple[int, int, Node]]:
    """A program read from Python stands in Python where its spans say."""
    for statement in statements(program.items + (program.main.body if program.main else ())):
        for line in range(statement.span.line, statement.span.end_line + 1):
            yield line, line, statement
        if isinstance(statement, If):
            for part in (*statement.branches, statement.otherwise):
                if part is not None:
                    yield part.span.line, part.span.line, statement


def assigned_names(body: Body) -> tuple[set[str], set[str]]:
    """The variables that a body sets, and the variables of its ``for`` loops."""
    assigned: set[str] = set()
    counted: set[str] = set()
    for statement in statements(body):
        if isinstance(statement, Assign) and isinstance(statement.target, Name):
            assigned.add(statement.target.name)
        elif isinstance(statement, ForEach | ForRange):
            counted.add(statement.target.name)
    return assigned, counted


def global_names(body: Body, parameters: tuple[str, ...], whens: AbstractSet[str]) -> list[str]:
    """The variables that a function must declare ``global`` in Python, by their Python names."""
    assigned, counted = assigned_names(body)
    shared = assigned - counted - set(parameters)
    return sorted(names.to_python(name) for name in shared if state_of(name, whens) is None)


def state_of(name: str, whens: AbstractSet[str]) -> tuple[str, str] | None:
    """The ``when`` and the attribute that ``state_X`` or ``time_X`` asks for."""
    if name[:6] == "state_" and name[6:] in whens:
        return name[6:], "active"
    if name[:5] == "time_" and name[5:] in whens:
        return name[5:], "time"
    return None


class _Writer(ExpressionWriter):
    """Writes one program, on the assumption that just `clashing` variables are called like a when.

    Those that it meets are in `clashes` afterwards; where these are others, the text is not valid.
    """

    def __init__(self, program: Program, clashing: frozenset[str]) -> None:
        super().__init__()
        self.tree = program
        self.functions = program.functions
        stems = names.clashes(clashing)
        self.whens = {name: names.when_to_python(name, stems) for name in program.whens}
        self.watched = {names.stem(name) for name in self.whens}
        self.clashes: set[str] = set()
        self.modules: set[str] = set()
        self.lines: list[str] = []
        self.sources: list[int] = []
        self.nodes: list[Node | None] = []
        self.indent = ""
        self.items: dict[type[Item | Main], Callable[[Any], None]] = {
            Comment: self.comment,
            Blank: lambda _: self.blank(),
            Perform: lambda node: self.line(self.expression(node.call), node, node.comment),
            Assign: self.assign,
            If: self.if_chain,
            While: self.while_loop,
            Repeat: self.repeat,
            ForEach: self.for_each,
            ForRange: self.for_range,
            Break: lambda node: self.line("break", node, node.comment),
            Continue: lambda node: self.line("continue", node, node.comment),
            Return: self.return_,
            Pass: lambda node: self.line("pass", node, node.comment),
            Activate: lambda node: self.activation(node, "activate"),
            Deactivate: lambda node: self.activation(node, "deactivate"),
            Raw: self.raw_block,
            Import: lambda node: self.line(f"from {node.module} import *", node, node.comment),
            Setup: self.creation,
            Def: self.definition,
            When: self.when,
            Main: self.main,
        }

    # Lines.

    def line(self, text: str, node: Node | None = None, comment: str | None = None) -> None:
        if comment is not None:
            text = f"{text}  {comment_text(comment)}"
        self.lines.append(self.indent + text)
        self.nodes.append(node)
        self.sources.append(node.span.line if node is not None else 0)

    def blank(self, count: int = 1) -> None:
        for _ in range(count):
            self.lines.append("")
            self.nodes.append(None)
            self.sources.append(0)

    def program(self, robot_module: str) -> str:
        length = prologue_length(self.tree.items)
        self.in_order(self.tree.items[:length])
        above = len(self.lines)
        rest = list(self.tree.items[length:])
        place = next((i for i, item in enumerate(rest) if isinstance(item, Setup)), -1)
        creation = rest[: place + 1] or [Setup()]
        apart = isinstance(creation[0], Setup)
        if not apart:
            self.blank()
        self.in_order(creation)
        self.body_of(rest[place + 1 :])
        self.import_lines(above, robot_module, apart=apart)
        return "\n".join([*self.lines, ""])

    def in_order(self, items: Any) -> None:
        for item, apart, blank, _ in placed(items):
            if apart or blank:
                self.blank()
            self.items[type(item)](item)

    def creation(self, setup: Setup) -> None:
        arguments = self.arguments(setup.arguments, setup.keywords)
        self.line(f"robot = Robot({arguments})", setup, setup.comment)

    def import_lines(self, place: int, robot_module: str, *, apart: bool) -> None:
        """Put the imports above all that they serve, in the order of isort."""
        lines = [f"import {module}" for module in MODULES if module in self.modules]
        if lines:
            lines.append("")
        lines.append(f"from {robot_module} import Robot")
        if apart:
            lines.append("")
        self.lines[place:place] = lines
        self.sources[place:place] = [0] * len(lines)
        self.nodes[place:place] = [None] * len(lines)

    def body_of(self, items: list[Item]) -> None:
        main = () if self.tree.main is None else (self.tree.main,)
        previous: Item | Main = Setup()
        for item, apart, blank, leads in placed([*items, *main]):
            if apart or blank or isinstance(previous, Setup):
                far = isinstance(previous, Def | When) or isinstance(leads, Def | When)
                self.blank(2 if far else 1)
            self.items[type(item)](item)
            previous = item
        if self.whens:
            self.blank(2 if isinstance(previous, Def | When) else 1)
            self.line("robot.run()")
        if self.tree.ending:
            self.blank()
            self.line("# end")
            self.in_order(self.tree.ending)

    # Items and statements.

    def block(self, header: str, body: Body, node: Node, comment: str | None) -> None:
        self.line(header + ":", node, comment)
        outer, self.indent = self.indent, self.indent + "    "
        for statement in body or (Pass(),):
            self.items[type(statement)](statement)
        self.indent = outer

    def main(self, node: Main) -> None:
        self.line("# main", node)
        for statement in node.body or (Pass(),):
            self.items[type(statement)](statement)

    def comment(self, node: Comment) -> None:
        self.line(comment_text(markers.escaped(node.text)), node)

    def assign(self, node: Assign) -> None:
        target = self.expression(node.target)
        self.line(f"{target} {node.operator} {self.expression(node.value)}", node, node.comment)

    def if_chain(self, node: If) -> None:
        word = "if"
        for branch in node.branches:
            condition = self.expression(branch.condition)
            self.block(f"{word} {condition}", branch.body, branch, branch.comment)
            word = "elif"
        if node.otherwise is not None:
            part = node.otherwise
            self.block("else", part.body, part, part.comment)

    def while_loop(self, node: While) -> None:
        self.block(f"while {self.expression(node.condition)}", node.body, node, node.comment)

    def repeat(self, node: Repeat) -> None:
        header = f"for _ in range({self.expression(node.count)})"
        self.block(header, node.body, node, node.comment)

    def for_each(self, node: ForEach) -> None:
        header = f"for {self.expression(node.target)} in {self.expression(node.values)}"
        self.block(header, node.body, node, node.comment)

    def for_range(self, node: ForRange) -> None:
        header = f"for {self.expression(node.target)} in range({self.bounds(node)})"
        self.block(header, node.body, node, node.comment)

    def bounds(self, node: ForRange) -> str:
        direction = ranges.direction(node.step)
        start = self.expression(node.start)
        if node.step is None:
            end = self.expression(ranges.beyond(node.stop, 1))
            return end if node.start == Number("0") else f"{start}, {end}"
        step = self.expression(node.step)
        if direction:
            return f"{start}, {self.expression(ranges.beyond(node.stop, direction))}, {step}"
        # Which way it counts is known only when it runs.
        beyond = f"(1 if {self.expression(node.step, SIGN)} > 0 else -1)"
        return f"{start}, {self.expression(node.stop, 5)} + {beyond}, {step}"

    def return_(self, node: Return) -> None:
        value = "" if node.value is None else " " + self.expression(node.value)
        self.line(f"return{value}", node, node.comment)

    def activation(self, node: Activate | Deactivate, method: str) -> None:
        name = self.whens.get(node.name) or self.variable(node.name)
        self.line(f"{name}.{method}()", node, node.comment)

    def raw_block(self, node: Raw) -> None:
        self.watch_raw(node.text)
        self.line("# python", node)
        for index, line in enumerate(markers.raw_lines(node.text, self.indent), 1):
            self.lines.append(line)
            self.nodes.append(node)
            self.sources.append(node.span.line + index if node.span.line else 0)
        self.line("# end")

    def definition(self, node: Def) -> None:
        parameters = [self.variable(parameter) for parameter in node.parameters]
        header = f"def {self.variable(node.name)}({', '.join(parameters)})"
        self.function(header, node)

    def when(self, node: When) -> None:
        if node.condition is not None:
            self.line(f"@robot.when(lambda: {self.expression(node.condition)})", node)
        elif node.name == "start":
            self.line("@robot.when_start", node)
        else:
            self.line("@robot.when", node)
        self.function(f"def {self.whens[node.name]}()", node)

    def function(self, header: str, node: Def | When) -> None:
        self.line(header + ":", node, node.comment)
        self.indent = "    "
        parameters = node.parameters if isinstance(node, Def) else ()
        shared = global_names(node.body, parameters, self.whens.keys())
        if shared:
            self.line(f"global {', '.join(shared)}")
        body: tuple[Statement, ...] = node.body or (Pass(),)
        for statement in body:
            self.items[type(statement)](statement)
        self.indent = ""

    # Expressions.

    def variable(self, name: str) -> str:
        if self.watched and names.stem(name) in self.watched:
            self.clashes.add(name)
        return names.to_python(name)

    def name(self, node: Name, _: int) -> str:
        name = node.name
        if self.whens:
            state = state_of(name, self.whens.keys())
            if state is not None:
                return f"{self.whens[state[0]]}.{state[1]}"
        return self.variable(name)

    def keyword_name(self, name: str) -> str:
        return names.attribute_to_python(name)

    def skill_call(self, node: SkillCall, _: int) -> str:
        name = names.attribute_to_python(node.name)
        return f"robot.{name}({self.arguments(node.arguments, node.keywords)})"

    def call(self, node: Call, level: int) -> str:
        if node.name not in self.functions:
            known = self.library_call(node, level)
            if known is not None:
                return known
        arguments = [self.expression(argument) for argument in node.arguments]
        arguments += [
            f"{names.to_python(keyword.name)}={self.expression(keyword.value)}"
            for keyword in node.keywords
        ]
        return f"{self.variable(node.name)}({', '.join(arguments)})"

    def library_call(self, node: Call, _: int) -> str | None:
        name = node.name
        if name == "elapsedTime":
            return f"robot.elapsedTime({self.arguments(node.arguments, node.keywords)})"
        if is_builtin(name, len(node.arguments)):
            return f"{name}({self.arguments(node.arguments, node.keywords)})"
        template = TEMPLATES.get((name, len(node.arguments)))
        if template is None or node.keywords:
            return None
        if template.module:
            self.modules.add(template.module)
        written = [
            self.receiver(argument) if index in template.receivers else self.expression(argument)
            for index, argument in enumerate(node.arguments)
        ]
        if name == "sublist" and not all(map(_simple, node.arguments[1:])):
            # As every Python formatter has it: blanks where a bound is not simple.
            return f"{written[0]}[{written[1]} : {written[2]}]"
        return template.python.format(*written)

    def unary(self, node: Unary, level: int) -> str:
        operand = node.operand
        if node.operator != "not" and isinstance(operand, Binary) and operand.operator == "**":
            # As every Python formatter has it, since few know which of the two comes first.
            text = f"{node.operator}({self.power(operand)})"
            return f"({text})" if level > SIGN else text
        return super().unary(node, level)

    def power(self, node: Binary) -> str:
        left = self.expression(node.left, TIGHTEST)
        right = self.expression(node.right, SIGN)
        # As every Python formatter has it: no blanks where both sides are simple.
        hugged = _simple(node.left) and _simple(node.right)
        return f"{left}**{right}" if hugged else f"{left} ** {right}"

    def raw(self, node: RawExpression, level: int) -> str:
        self.watch_raw(node.text)
        text = node.text.strip()
        if level == LOOSEST or _RAW_ATOM.fullmatch(text):
            return text
        return text if _binds_tightest(text) else f"({text})"

    def index(self, node: Index, _: int) -> str:
        return f"{self.receiver(node.value)}[{self.expression(node.index)}]"

    def watch_raw(self, text: str) -> None:
        if self.watched:
            found = {names.from_python(name) for name in markers.raw_names(text)}
            self.clashes.update(name for name in found if name and names.stem(name) in self.watched)


def _simple(node: Expression) -> bool:
    if isinstance(node, Unary):
        return node.operator != "not" and isinstance(node.operand, Name | Number)
    return isinstance(node, Name | Number | Constant) or (
        isinstance(node, RawExpression) and _RAW_ATOM.fullmatch(node.text.strip()) is not None
    )


def _binds_tightest(text: str) -> bool:
    import ast  # noqa: PLC0415 - wanted by raw Python only

    try:
        node = ast.parse(text, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return isinstance(
        node,
        ast.Attribute
        | ast.Call
        | ast.Constant
        | ast.Dict
        | ast.DictComp
        | ast.GeneratorExp
        | ast.JoinedStr
        | ast.List
        | ast.ListComp
        | ast.Name
        | ast.Set
        | ast.SetComp
        | ast.Subscript,
    )
