"""Find names and skills that a file of blocks uses and that nothing defines; it is not run."""

import ast
import builtins
import dis
from collections.abc import Collection, Iterator
from operator import attrgetter
from types import CodeType

from learnblock.blocks.source.importable import missing_import
from learnblock.errors import Diagnostic, Severity, nearest
from learnblock.i18n import Phrase
from learnblock.language.check.findings import unknown

_BUILTINS = frozenset((*dir(builtins), "__file__"))
#: With these, a file can define names that cannot be found by reading it.
_DYNAMIC = frozenset(("exec", "eval", "globals", "locals", "vars", "__import__"))
_LOADS = frozenset(("LOAD_NAME", "LOAD_GLOBAL", "LOAD_FROM_DICT_OR_GLOBALS"))
#: The errors whose handlers expect that a name is missing.
_EXPECTING = frozenset(("NameError", "Exception", "BaseException"))
_ROBOT = "robot"
#: How similar a name is to a misspelled one, from 0 to 1.
_SLIP = 0.8

#: A line, and a column from 0.
_Place = tuple[int | None, int | None]


def unknown_names(tree: ast.Module, code: CodeType) -> Iterator[Diagnostic]:
    """Report each name, once, that would raise a NameError.

    Args:
        tree: the syntax tree of a file.
        code: the same, compiled: Python has found out which names are global.
    """
    nodes = [*ast.walk(tree)]
    if any(map(_makes_names, nodes)):
        return
    known = {*_BUILTINS, *_global_names(code)}
    places = {*_unknown_places(code, known)}
    expected = {id(inner) for node in nodes for inner in _expected_to_fail(node)}
    diagnostics = {
        node.id: _at(node, "unknown-name", _unknown_name(node, owner, known))
        for node, owner in reversed([*_names(nodes)])
        if (node.lineno, node.col_offset) in places and id(node) not in expected
    }
    yield from sorted(diagnostics.values(), key=attrgetter("line", "column"))


def unknown_skills(tree: ast.Module, known: Collection[str]) -> Iterator[Diagnostic]:
    """Report methods that are called on the robot although no robot has them.

    Args:
        tree: the syntax tree of a file.
        known: the names of all skills, and of what every robot has besides.
    """
    nodes = [*ast.walk(tree)]
    if any(_stores(node, _ROBOT) for node in nodes):
        return
    of_robot = [node for node in nodes if isinstance(node, ast.Attribute) and _is_robot(node.value)]
    assigned = {node.attr for node in of_robot if isinstance(node.ctx, ast.Store)}
    for node in of_robot:
        name = node.attr
        if name in known or name in assigned or name.startswith("_"):
            continue
        # It may be a skill of a block that is saved later, or of a robot of the user's own.
        severity: Severity = "error" if _is_slip(name, known) else "warning"
        yield _at(node, "unknown-skill", unknown("skill", name, nearest(name, known)), severity)


def _makes_names(node: ast.AST) -> bool:
    match node:
        case ast.Name(id=name):
            return name in _DYNAMIC
        case ast.ImportFrom(names=[ast.alias(name="*")]):
            return True
    return False


def _global_names(code: CodeType) -> Iterator[str]:
    """The names that a module sets."""
    yield from _operands(code, "STORE_NAME")
    for scope in _codes(code):
        yield from _operands(scope, "STORE_GLOBAL")


def _unknown_places(code: CodeType, known: Collection[str]) -> Iterator[_Place]:
    """Where a name is looked up that neither the module nor the class around it sets."""
    for scope in _codes(code):
        here = {*known, *_operands(scope, "STORE_NAME")}
        for instruction in dis.get_instructions(scope):
            is_unknown = instruction.opname in _LOADS and instruction.argval not in here
            if is_unknown and instruction.positions:
                yield instruction.positions.lineno, instruction.positions.col_offset


def _codes(code: CodeType) -> Iterator[CodeType]:
    """The code of a module, and of all functions and classes in it."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _codes(constant)


def _operands(code: CodeType, operation: str) -> Iterator[str]:
    return (
        instruction.argval
        for instruction in dis.get_instructions(code)
        if instruction.opname == operation
    )


def _expected_to_fail(node: ast.AST) -> Iterator[ast.AST]:
    """What is in a ``try`` that handles missing names."""
    if isinstance(node, ast.Try) and any(map(_expects, node.handlers)):
        for statement in node.body:
            yield from ast.walk(statement)


def _expects(handler: ast.ExceptHandler) -> bool:
    if handler.type is None:
        return True
    names = (name.id for name in ast.walk(handler.type) if isinstance(name, ast.Name))
    return not _EXPECTING.isdisjoint(names)


def _names(nodes: Collection[ast.AST]) -> Iterator[tuple[ast.Name, ast.AST]]:
    """Each name, with what it is a part of."""
    for owner in nodes:
        for node in ast.iter_child_nodes(owner):
            if isinstance(node, ast.Name):
                yield node, owner


def _unknown_name(node: ast.Name, owner: ast.AST, known: Collection[str]) -> Phrase:
    name = node.id
    if missing := missing_import(name, before_dot=isinstance(owner, ast.Attribute)):
        return missing
    is_called = isinstance(owner, ast.Call) and owner.func is node
    # True, False and errors are no functions, and only these begin with a capital.
    likely = [name for name in known if name not in _BUILTINS or (is_called and name.islower())]
    sort = "function" if is_called else "name"
    return unknown(sort, name, nearest(name, likely))


def _is_slip(name: str, known: Collection[str]) -> bool:
    """Whether a name is a known one misspelled, and not the next of a series such as `waltz2`."""
    near = nearest(name, known, likeness=_SLIP)
    return near is not None and name.strip("_0123456789") != near.strip("_0123456789")


def _is_robot(node: ast.AST) -> bool:
    return isinstance(node, ast.Name) and node.id == _ROBOT


def _stores(node: ast.AST, name: str) -> bool:
    return isinstance(node, ast.Name) and node.id == name and isinstance(node.ctx, ast.Store)


def _at(node: ast.expr, code: str, message: Phrase, severity: Severity = "error") -> Diagnostic:
    return Diagnostic(
        code, message, node.lineno, node.col_offset + 1, (node.end_col_offset or 0) + 1, severity
    )
