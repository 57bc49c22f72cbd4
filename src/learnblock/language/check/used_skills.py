"""The calls of skills in a program, in blocks and in the parts that stay Python.

A function that nothing mentions is left out, since it never runs.
"""

import ast
from collections.abc import Container, Iterator
from dataclasses import dataclass

from learnblock.blocks.source.uses import dotted
from learnblock.language.blocktext.names import from_python
from learnblock.language.tree.loads import parsed
from learnblock.language.tree.markers import defined_names
from learnblock.language.tree.nodes import (
    NOWHERE,
    AnyPython,
    Blank,
    Call,
    Comment,
    Constant,
    Def,
    Expression,
    Import,
    Item,
    Keyword,
    Name,
    Program,
    PythonBlock,
    Raw,
    RawExpression,
    Setup,
    SkillCall,
    Span,
    String,
    WithoutRobot,
)
from learnblock.language.tree.traversal import all_expressions, statements
from learnblock.senses import METHODS

#: What else a file with functions for other programs may contain.
_BESIDE_FUNCTIONS = Blank | Comment | WithoutRobot | Import | Setup
#: Columns by which Block-Text indents a block.
_INDENT = 4


def skill_calls(
    program: Program,
    skills: Container[str],
    functions: Container[str] = frozenset(),
    *,
    in_python: bool = False,
) -> Iterator[SkillCall]:
    """Every call of a skill, in source order.

    Methods of `robot.senses` count as skills, and are called ``senses.heading`` and so on.

    Args:
        program: the tree.
        skills: the names of the skills, to find them in parts that stay Python.
        functions: functions of imported files that count as skills, as the program writes them.
        in_python: whether its author wrote Python.
    """
    parts = tuple(statements(_running(program)))
    raw = _Raw.of(parts, skills, functions)
    for item in parts:
        if isinstance(item, AnyPython):
            # In Block-Text it is inside of a block.
            line, column = item.span.line, item.span.column
            if not in_python and isinstance(item, Raw):
                line, column = line + 1, column + _INDENT
            place = Span(line, column)
            yield from raw.calls(item.text, place)
        for node in all_expressions(item):
            if isinstance(node, SkillCall):
                yield node
            elif isinstance(node, Call) and node.name in functions:
                yield SkillCall(node.name, node.arguments, node.keywords, node.span)
            elif isinstance(node, RawExpression):
                for call in raw.calls(node.text.strip(), node.span):
                    yield SkillCall(call.name, call.arguments, call.keywords, node.span)


def imports_of(program: Program) -> ast.Module:
    """What the parts of a program that stay Python import, and its own imports."""
    imports: list[ast.stmt] = []
    for item in statements(_running(program)):
        if isinstance(item, AnyPython):
            nodes = ast.walk(parsed(item.text))
            imports += [node for node in nodes if isinstance(node, ast.Import | ast.ImportFrom)]
        elif isinstance(item, Import):
            imports.append(ast.ImportFrom(item.module, [ast.alias("*")], 0))
    return ast.Module(imports, [])


def _running(program: Program) -> tuple[Item, ...]:
    """The items of the top level and of `main`, without functions that nothing mentions."""
    main = () if program.main is None else program.main.body
    waiting = program.functions
    everything: tuple[Item, ...] = (*program.items, *main)
    running: list[Item] = [item for item in everything if not isinstance(item, Def)]
    if all(isinstance(item, _BESIDE_FUNCTIONS) for item in running):
        return everything
    ahead = running.copy()
    while ahead:
        mentioned = [waiting.pop(name) for name in _names(ahead.pop()) if name in waiting]
        ahead.extend(mentioned)
        running.extend(mentioned)
    return tuple(sorted(running, key=lambda item: item.span.line))


def _names(item: Item) -> Iterator[str]:
    """The names of variables and functions that an item mentions."""
    for statement in statements((item,)):
        if isinstance(statement, AnyPython):
            yield from _names_in(statement.text)
        for node in all_expressions(statement):
            if isinstance(node, Call | Name):
                yield node.name
            elif isinstance(node, RawExpression):
                yield from _names_in(node.text)


def _names_in(text: str) -> Iterator[str]:
    for node in ast.walk(parsed(text.strip())):
        if isinstance(node, ast.Name) and (name := from_python(node.id)) is not None:
            yield name


@dataclass(frozen=True, slots=True)
class _Raw:
    """Finds skills in the parts that stay Python.

    Every attribute with the name of a skill counts, since any variable or parameter may be the
    robot; those of modules, and methods of the program's own classes, do not.

    Args:
        skills: the names of the skills.
        functions: the functions of imported files that count as skills.
        modules: the names that the program imports.
        methods: the names of the methods of its classes.
    """

    skills: Container[str]
    functions: Container[str]
    modules: frozenset[str]
    methods: frozenset[str]

    @classmethod
    def of(
        cls, parts: tuple[Item, ...], skills: Container[str], functions: Container[str]
    ) -> "_Raw":
        modules = {item.module for item in parts if isinstance(item, Import)}
        methods: set[str] = set()
        for item in parts:
            if isinstance(item, PythonBlock) and item.parts[0].word == "class":
                inner = (method for method in item.parts[0].body if isinstance(method, PythonBlock))
                methods |= {name for method in inner for name in defined_names(method.text)}
            for node in ast.walk(parsed(item.text if isinstance(item, AnyPython) else "")):
                if isinstance(node, ast.Import):
                    modules |= {
                        (alias.asname or alias.name).partition(".")[0] for alias in node.names
                    }
                elif isinstance(node, ast.ClassDef):
                    methods |= {
                        inner.name for inner in node.body if isinstance(inner, ast.FunctionDef)
                    }
        return cls(skills, functions, frozenset(modules), frozenset(methods))

    def calls(self, text: str, span: Span) -> Iterator[SkillCall]:
        """The calls in a text at a place; a skill that is not called at once counts as well."""
        tree = parsed(text)
        called = {id(node.func): node for node in ast.walk(tree) if isinstance(node, ast.Call)}
        nodes = (node for node in ast.walk(tree) if isinstance(node, ast.expr))
        places = [(node, name) for node in nodes if (name := self.skill(node))]
        for node, name in sorted(places, key=lambda place: (place[0].lineno, place[0].col_offset)):
            call = called.get(id(node))
            given = () if call is None else tuple(map(_argument, call.args))
            keywords = () if call is None else call.keywords
            named = tuple(
                Keyword(keyword.arg, _argument(keyword.value))
                for keyword in keywords
                if keyword.arg
            )
            yield SkillCall(name, given, named, _span(node, span))

    def skill(self, node: ast.expr) -> str:
        """The skill that an expression names; empty if it names none."""
        if (written := dotted(node)) in self.functions:
            return written
        match node:
            case ast.Attribute(value=ast.Name(id=owner)) if owner in self.modules:
                return ""
            case ast.Attribute(value=ast.Attribute(attr="senses"), attr=name) if name in METHODS:
                return f"senses.{name}"
            case ast.Attribute(attr=name):
                pass
            case ast.Call(func=ast.Name(id="getattr"), args=[_, ast.Constant(str(name)), *_]):
                pass
            case _:
                return ""
        return name if name in self.skills and name not in self.methods else ""


def _span(node: ast.expr, place: Span) -> Span:
    """Where a node of a text at a place is."""
    down, across = place.line - 1, place.column
    last, end = node.end_lineno or node.lineno, node.end_col_offset or node.col_offset
    return Span(node.lineno + down, node.col_offset + across, last + down, end + across)


def _argument(node: ast.expr) -> Expression:
    match node:
        case ast.Constant(value=str(text)):
            return String(text)
        case ast.Constant(value=bool() | None as value):
            return Constant(value)
    return RawExpression(ast.unparse(node), NOWHERE)
