"""Write a tree as Python in its canonical form, formatted like common formatters do."""

import ast
import re
from collections.abc import Set as AbstractSet

from learnblock.language.blocktext import names
from learnblock.language.blocktext.names import state_of
from learnblock.language.python import imports
from learnblock.language.tree import markers, ranges
from learnblock.language.tree.builtins import LOOPED, MODULES, TEMPLATES, is_builtin
from learnblock.language.tree.expression_writer import LOOSEST, SIGN, TIGHTEST
from learnblock.language.tree.extents import every
from learnblock.language.tree.identifiers import IDENTIFIER
from learnblock.language.tree.layout import is_definition, placed, prologue_length
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Binary,
    Blank,
    Body,
    Call,
    Comment,
    Constant,
    Deactivate,
    Def,
    Expression,
    ForRange,
    Import,
    Item,
    Main,
    Name,
    Node,
    Number,
    Pass,
    Program,
    PythonLine,
    Raw,
    RawExpression,
    Repeat,
    Setup,
    SkillCall,
    Unary,
    WaitUntil,
    When,
    WithoutRobot,
)
from learnblock.language.tree.traversal import locals_in, own_statements
from learnblock.language.tree.writer import ProgramWriter, comment_text

#: Text as a statement, and what else must be above every other statement.
_TEXT = re.compile(r"[rRuU]?[\"']")
_HEAD = re.compile(rf"{_TEXT.pattern}|from\s+__future__\b")
_RAW_ATOM = re.compile(rf"{IDENTIFIER}(?:\.{IDENTIFIER})*")


def global_names(body: Body, parameters: tuple[str, ...], whens: AbstractSet[str]) -> list[str]:
    """The variables that a function must declare ``global`` in Python, by their Python names."""
    assigned: set[str] = set()
    for statement in own_statements(body):
        if isinstance(statement, Assign) and isinstance(statement.target, Name):
            assigned.add(statement.target.name)
    shared = assigned - locals_in(body).keys() - set(parameters)
    return sorted(names.to_python(name) for name in shared if state_of(name, whens) is None)


class PythonWriter(ProgramWriter):
    """Writes one program, assuming that only the `clashing` variables share a name with a ``when``.

    `clashes` collects those found while writing; if they differ, the text is not valid.
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
        self.sources: list[int] = []
        self.nodes: list[Node | None] = []

    # Lines.

    def line(self, text: str, node: Node | None = None, comment: str | None = None) -> None:
        if comment is not None:
            text = f"{text}  {comment_text(comment)}"
        self.lines.append(self.indent + text)
        self.nodes.append(node)
        self.sources.append(node.span.line if node is not None else 0)

    def blank(self, _: Blank | None = None) -> None:
        self.lines.append("")
        self.nodes.append(None)
        self.sources.append(0)

    def blanks(self, count: int) -> None:
        for _ in range(count):
            self.blank()

    def program(self, robot_module: str) -> str:
        if self.tree.is_without_robot:
            return self.program_without_robot()
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

    def program_without_robot(self) -> str:
        self.body_of(list(self.tree.items[1:]))
        missing = [
            f"import {module}"
            for module in MODULES
            if module in self.modules and not self.imports(module)
        ]
        if missing:
            self.insert(self.place_of_imports(), [*missing, ""])
        return "\n".join([*self.lines, ""]) if self.lines else ""

    def imports(self, module: str) -> bool:
        """Whether the program imports a module itself."""
        texts = (item.text for item in every(self.tree) if isinstance(item, Raw | PythonLine))
        return any(module in markers.defined_names(text) for text in texts)

    def place_of_imports(self) -> int:
        """The number of lines above the first statement that may need an import."""
        for item in self.tree.items[1:]:
            if isinstance(item, PythonLine | Raw) and _HEAD.match(item.text):
                continue
            if not isinstance(item, Comment | Blank):
                return self.extents[id(item)][0] - 1
        return len(self.lines)

    def import_lines(self, place: int, robot_module: str, *, apart: bool) -> None:
        """Insert the imports above the code that needs them, in the order of isort."""
        lines = [f"import {module}" for module in MODULES if module in self.modules]
        if lines:
            lines.append("")
        lines.append(f"from {robot_module} import Robot")
        if apart:
            lines.append("")
        self.insert(place, lines)

    def insert(self, place: int, lines: list[str]) -> None:
        self.lines[place:place] = lines
        self.sources[place:place] = [0] * len(lines)
        self.nodes[place:place] = [None] * len(lines)
        for key, (first, last) in self.extents.items():
            if first > place:
                self.extents[key] = (first + len(lines), last + len(lines))

    def body_of(self, items: list[Item]) -> None:
        main = () if self.tree.main is None else (self.tree.main,)
        previous: Item | Main | None = None if self.tree.is_without_robot else Setup()
        for item, apart, blank, leads in placed([*items, *main]):
            if apart or blank or isinstance(previous, Setup):
                far = is_definition(previous) or is_definition(leads)
                self.blanks(2 if far else 1)
            self.item(item)
            previous = item
        if self.whens:
            self.blanks(2 if isinstance(previous, Def | When) else 1)
            self.line("robot.run()")
        if self.tree.ending:
            self.blank()
            self.line("# end")
            self.in_order(self.tree.ending)

    # Items and statements.

    def comment(self, node: Comment) -> None:
        self.line(comment_text(markers.escaped(node.text)), node)

    def import_(self, node: Import) -> None:
        module = imports.to_python(node.module)
        self.line(f"from {module} import *", node, node.comment)

    def setup(self, node: Setup) -> None:
        arguments = self.arguments(node.arguments, node.keywords)
        self.line(f"robot = Robot({arguments})", node, node.comment)

    def main(self, node: Main) -> None:
        if self.tree.is_without_robot and not (self.whens or self.tree.ending):
            self.block(markers.IF_MAIN, node.body, node, None)
            return
        self.line("# main", node)
        for statement in node.body or (Pass(),):
            self.item(statement)

    def repeat(self, node: Repeat) -> None:
        self.closed(f"for _ in range({self.expression(node.count)})", node)

    def for_range(self, node: ForRange) -> None:
        self.closed(f"for {self.expression(node.target)} in range({self.bounds(node)})", node)

    def looped(self, values: Expression) -> str:
        match values:
            case Call("list", (Call() as inner,), ()) if self.is_looped(inner):
                # It makes a list by itself, if it is anywhere but in the first line of a loop.
                return self.expression(inner)
            case Call("items", (argument,)) if self.is_looped(values):
                return LOOPED["items"].format(self.receiver(argument))
            case Call(name=name, arguments=(argument,)) if self.is_looped(values):
                return LOOPED[name].format(self.expression(argument))
        return super().looped(values)

    def is_looped(self, call: Call) -> bool:
        """Whether a loop takes the values of a call without making a list of them."""
        is_known = call.name in LOOPED and call.name not in self.functions
        return is_known and len(call.arguments) == 1 and not call.keywords

    def bounds(self, node: ForRange) -> str:
        direction = ranges.direction(node.step)
        start = self.expression(node.start)
        if node.step is None:
            end = self.expression(ranges.beyond(node.stop, 1))
            return end if node.start == Number("0") else f"{start}, {end}"
        step = self.expression(node.step)
        if direction:
            return f"{start}, {self.expression(ranges.beyond(node.stop, direction))}, {step}"
        # The direction is known only when the program runs.
        beyond = f"(1 if {self.expression(node.step, SIGN)} > 0 else -1)"
        return f"{start}, {self.expression(node.stop, 5)} + {beyond}, {step}"

    def wait_until(self, node: WaitUntil) -> None:
        condition = self.expression(node.condition)
        self.line(f"robot.wait_until(lambda: {condition})", node, node.comment)

    def activation(self, node: Activate | Deactivate) -> None:
        name = self.whens.get(node.name) or self.variable(node.name)
        self.line(f"{name}.{type(node).__name__.lower()}()", node, node.comment)

    def raw_block(self, node: Raw) -> None:
        self.watch_raw(node.text)
        is_marked = not markers.is_long_text(node.text)
        if is_marked:
            self.line("# python", node)
        for index, line in enumerate(markers.raw_lines(node.text, self.indent), 1):
            self.lines.append(line)
            self.nodes.append(node)
            self.sources.append(node.span.line + index if node.span.line else 0)
        if is_marked:
            self.line("# end")

    def python(self, text: str) -> str:
        self.watch_raw(text)
        return text

    def without_robot(self, node: WithoutRobot) -> None:
        """Nothing says it in Python."""

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
        docstring = _docstring_length(node.body)
        for statement in node.body[:docstring]:
            self.item(statement)
        if shared:
            self.line(f"global {', '.join(shared)}")
        for statement in node.body[docstring:] or (() if docstring else (Pass(),)):
            self.item(statement)
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
            # Like Python formatters: spaces if a bound is not simple.
            return f"{written[0]}[{written[1]} : {written[2]}]"
        return template.python.format(*written)

    def unary(self, node: Unary, level: int) -> str:
        operand = node.operand
        if node.operator != "not" and isinstance(operand, Binary) and operand.operator == "**":
            # Like Python formatters, because the precedence is not widely known.
            text = f"{node.operator}({self.power(operand)})"
            return f"({text})" if level > SIGN else text
        return super().unary(node, level)

    def power(self, node: Binary) -> str:
        left = self.expression(node.left, TIGHTEST)
        right = self.expression(node.right, SIGN)
        # Like Python formatters: no spaces if both sides are simple.
        hugged = _simple(node.left) and _simple(node.right)
        return f"{left}**{right}" if hugged else f"{left} ** {right}"

    def raw(self, node: RawExpression, level: int) -> str:
        self.watch_raw(node.text)
        text = node.text.strip()
        if level == LOOSEST or _RAW_ATOM.fullmatch(text):
            return text
        return text if _binds_tightest(text) else f"({text})"

    def watch_raw(self, text: str) -> None:
        if self.watched:
            raw_names = {names.from_python(name) for name in markers.raw_names(text)}
            self.clashes.update(
                name for name in raw_names if name and names.stem(name) in self.watched
            )


def _docstring_length(body: Body) -> int:
    """How many statements at the head of a function are its docstring and comments above it."""
    for place, statement in enumerate(body):
        if isinstance(statement, PythonLine | Raw):
            return place + 1 if _TEXT.match(statement.text) else 0
        if not isinstance(statement, Comment | Blank):
            return 0
    return 0


def _simple(node: Expression) -> bool:
    if isinstance(node, Unary):
        return node.operator != "not" and isinstance(node.operand, Name | Number)
    return isinstance(node, Name | Number | Constant) or (
        isinstance(node, RawExpression) and _RAW_ATOM.fullmatch(node.text.strip()) is not None
    )


def _binds_tightest(text: str) -> bool:
    try:
        node = ast.parse(text, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return isinstance(
        node,
        # The first three are in brackets already wherever they are a value.
        ast.NamedExpr
        | ast.Yield
        | ast.YieldFrom
        | ast.Attribute
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
