"""Programs that can reach nothing but their robot, so that they may share a process with it.

What Block-Text without raw Python and imports is translated to is plain. Everything else is refused
unless it is known to be harmless: a plain program has no way to an object's inside, such as
``robot.clock`` or ``__class__``, and imports nothing that could provide one.
"""

import ast
import re
from collections.abc import Callable, Mapping
from functools import cache, lru_cache
from typing import Any

from learnblock.blocks import builtin
from learnblock.language.tree.builtins import BUILTINS, MODULES, TEMPLATES
from learnblock.runtime.program import Program

#: Methods of every robot, of its events, and of lists, dictionaries and text.
_OF_ROBOTS = frozenset({"run", "time", "wait_until", "when", "when_start"})
_OF_EVENTS = frozenset({"activate", "active", "deactivate", "time"})
#: The keyword arguments of Python's own functions; `file` would write to any object.
_KEYWORDS = frozenset({"end", "sep"})
_ROBOT = "robot"
_ROBOT_MODULE = re.compile(r"learnblock\.robots\.[a-z]\w*")
#: Nodes that need no closer look than at what is in them.
_HARMLESS = (
    ast.Module, ast.Expr, ast.If, ast.While, ast.For, ast.Break, ast.Continue, ast.Return, ast.Pass,
    ast.Global, ast.Assign, ast.AugAssign, ast.Lambda, ast.arguments, ast.List, ast.Tuple,
    ast.Subscript, ast.Slice, ast.UnaryOp, ast.BinOp, ast.BoolOp, ast.Compare, ast.IfExp,
    ast.JoinedStr, ast.operator, ast.unaryop, ast.boolop, ast.cmpop, ast.expr_context, ast.Dict,
)  # fmt: skip


def is_plain(program: Program) -> bool:
    """Whether a program can reach nothing but its robot."""
    tree = _tree(program.python)
    return tree is not None and _Inspection(tree).passes()


def dead_ends(program: Program) -> tuple[int, ...]:
    """The lines of endless loops with an empty body, such as one not filled in yet.

    Once in such a loop, a plain program runs until its host ends it.
    """
    tree = _tree(program.python)
    loops = [] if tree is None else filter(_is_empty_and_endless, ast.walk(tree))
    return tuple(sorted({line for loop in loops for line in _lines(loop)}))


@lru_cache(maxsize=1)
def _tree(text: str) -> ast.Module | None:
    try:
        return ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


class _Inspection:
    """The inspection of a program.

    Args:
        tree: the program.
    """

    def __init__(self, tree: ast.Module) -> None:
        self._nodes = [*ast.walk(tree)]
        self._own = _defined(self._nodes)
        #: Where robot and modules may be named: before a dot, and where the robot is created.
        self._owners = {id(node.value) for node in self._nodes if isinstance(node, ast.Attribute)}
        creations = (node for node in self._nodes if _creates_robot(node))
        self._creations = {id(part) for creation in creations for part in ast.walk(creation)}

    def passes(self) -> bool:
        reserved = {_ROBOT, "Robot", *MODULES}
        return self._own.isdisjoint(reserved) and all(map(self._allows, self._nodes))

    def _allows(self, node: ast.AST) -> bool:
        if isinstance(node, ast.Name):
            return self._allows_name(node)
        if isinstance(node, ast.Call):
            return self._allows_call(node)
        look = _LOOKS.get(type(node))
        return isinstance(node, _HARMLESS) if look is None else look(node)

    def _allows_name(self, node: ast.Name) -> bool:
        if node.id in {_ROBOT, "Robot"} and id(node) in self._creations:
            return True
        if node.id == _ROBOT or node.id in MODULES:
            return id(node) in self._owners
        if isinstance(node.ctx, ast.Del) or not _is_visible(node.id):
            return False
        return node.id in self._own or node.id in BUILTINS or node.id == "range"

    def _allows_call(self, call: ast.Call) -> bool:
        if not isinstance(call.func, ast.Name):
            return isinstance(call.func, ast.Attribute)
        return call.func.id in self._own or {keyword.arg for keyword in call.keywords} <= _KEYWORDS


def _defined(nodes: list[ast.AST]) -> set[str]:
    """The names that a program gives to its variables, parameters and functions."""
    defined = set()
    for node in nodes:
        match node:
            case ast.FunctionDef(name=name) | ast.arg(arg=name):
                defined.add(name)
            case ast.Name(id=name, ctx=ast.Store()) if name != _ROBOT:
                defined.add(name)
            case ast.Global(names=names):
                defined.update(names)
    return defined


def _creates_robot(node: ast.AST) -> bool:
    """Whether this is ``robot = Robot()``."""
    match node:
        case ast.Assign(
            targets=[ast.Name(id="robot")],
            value=ast.Call(func=ast.Name(id="Robot"), args=[], keywords=[]),
        ):
            return True
    return False


def _imports_robot(node: ast.ImportFrom) -> bool:
    """Whether this is ``from learnblock.robots.sim_ebo import Robot``."""
    [*names] = ((alias.name, alias.asname) for alias in node.names)
    is_robots = _ROBOT_MODULE.fullmatch(node.module or "") is not None
    return node.level == 0 and is_robots and names == [("Robot", None)]


def _is_empty_and_endless(node: ast.AST) -> bool:
    """Whether this is ``while True: pass``."""
    if not isinstance(node, ast.While) or not isinstance(node.test, ast.Constant):
        return False
    return bool(node.test.value) and all(isinstance(part, ast.Pass) for part in node.body)


def _lines(node: ast.AST) -> range:
    assert isinstance(node, ast.stmt)  # noqa: S101 - a loop
    return range(node.lineno, (node.end_lineno or node.lineno) + 1)


def _is_visible(name: str) -> bool:
    return name == "_" or not name.startswith("_")


def _attributes(owner: ast.expr) -> frozenset[str]:
    """The attributes that a program may use of a value."""
    if isinstance(owner, ast.Name):
        if owner.id == _ROBOT:
            return _OF_ROBOTS | builtin().keys()
        if owner.id in MODULES:
            return _functions()[owner.id]
    return _functions()[""] | _OF_EVENTS


@cache
def _functions() -> dict[str, frozenset[str]]:
    """The functions of each module that the language uses, and the methods under ""."""
    functions: dict[str, set[str]] = {name: set() for name in ("", *MODULES)}
    for template in TEMPLATES.values():
        for node in ast.walk(template.pattern):
            if isinstance(node, ast.Attribute):
                owner = node.value
                is_module = isinstance(owner, ast.Name) and owner.id in MODULES
                functions[owner.id if is_module else ""].add(node.attr)  # type: ignore[attr-defined]
    return {name: frozenset(attributes) for name, attributes in functions.items()}


#: What to look at in the other nodes.
_LOOKS: Mapping[type[ast.AST], Callable[[Any], bool]] = {
    ast.Attribute: lambda node: (
        isinstance(node.ctx, ast.Load) and node.attr in _attributes(node.value)
    ),
    ast.Constant: lambda node: (
        node.value is None or isinstance(node.value, bool | int | float | str)
    ),
    ast.FormattedValue: lambda node: node.conversion == -1 and node.format_spec is None,
    ast.FunctionDef: lambda node: _is_visible(node.name) and node.returns is None,
    ast.arg: lambda node: _is_visible(node.arg) and node.annotation is None,
    ast.keyword: lambda node: node.arg is not None,
    ast.Import: lambda node: all(
        alias.name in MODULES and alias.asname is None for alias in node.names
    ),
    ast.ImportFrom: _imports_robot,
    # A part of an import, which is checked as a whole.
    ast.alias: lambda _: True,
}
