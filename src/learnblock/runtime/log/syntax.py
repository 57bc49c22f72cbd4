"""What the statements of a program read, write and declare."""

import ast
from collections import deque
from collections.abc import Iterable, Iterator, Sequence

#: Methods of lists, dicts and sets that change them.
_CHANGING = frozenset(
    {"append", "extend", "insert", "remove", "pop", "clear", "sort", "reverse", "update", "add"}
)

#: Decorators of the robot that make a function an event.
_EVENTS = frozenset({"when", "when_start"})


def names_read(node: ast.AST) -> tuple[str, ...]:
    """The variables that an expression or statement reads, in the order of its tree.

    The variables of a comprehension or a lambda are its own.
    """
    return tuple(dict.fromkeys(_names_read(node)))


def _names_read(node: ast.AST) -> Iterator[str]:
    ahead: deque[tuple[ast.AST, frozenset[str]]] = deque([(node, frozenset())])
    while ahead:
        inner, own = ahead.popleft()
        if isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Load) and inner.id not in own:
            yield inner.id
        own |= _own_names(inner)
        ahead.extend((part, own) for part in ast.iter_child_nodes(inner))


def _own_names(node: ast.AST) -> frozenset[str]:
    """The variables that an expression has for itself."""
    match node:
        case ast.ListComp() | ast.SetComp() | ast.DictComp() | ast.GeneratorExp():
            targets = (part for loop in node.generators for part in ast.walk(loop.target))
            return frozenset(part.id for part in targets if isinstance(part, ast.Name))
        case ast.Lambda():
            return frozenset(part.arg for part in ast.walk(node.args) if isinstance(part, ast.arg))
    return frozenset()


def names_written(target: ast.expr) -> tuple[str, ...]:
    """The variables that an assignment to `target` writes, or whose list it changes."""
    if isinstance(target, ast.Tuple | ast.List):
        return tuple(name for element in target.elts for name in names_written(element))
    while isinstance(target, ast.Subscript | ast.Attribute | ast.Starred):
        target = target.value
    return (target.id,) if isinstance(target, ast.Name) else ()


def written_value(target: ast.expr) -> ast.expr:
    """The expression that reads what has been assigned to `target`."""
    return values_of(names_written(target))


def values_of(names: Sequence[str]) -> ast.expr:
    """The expression that reads some variables."""
    read = [ast.Name(name, ast.Load()) for name in names]
    return read[0] if len(read) == 1 else ast.Tuple([*read], ast.Load())


def names_captured(pattern: ast.pattern) -> Iterator[str]:
    """The variables that a pattern of `match` writes."""
    for part in ast.walk(pattern):
        if isinstance(part, ast.MatchAs | ast.MatchStar) and part.name:
            yield part.name
        elif isinstance(part, ast.MatchMapping) and part.rest:
            yield part.rest


def changed_list(value: ast.expr) -> str:
    """The variable whose list, dict or set a statement changes; "" if it changes none."""
    if (
        isinstance(value, ast.Call)
        and isinstance(value.func, ast.Attribute)
        and value.func.attr in _CHANGING
    ):
        # Also of a list in a list: `rows[0].append(1)`.
        names = names_written(value.func.value)
        return names[0] if names else ""
    return ""


def declarations(body: Sequence[ast.stmt]) -> Iterable[ast.stmt]:
    """What must stay ahead in a function: its docstring, and what is global."""
    for statement in body:
        is_text = isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)
        if not (is_text or isinstance(statement, ast.Global | ast.Nonlocal)):
            return
        yield statement


def is_event(decorator: ast.expr) -> bool:
    """Whether a decorator makes a function an event of the robot."""
    function = decorator.func if isinstance(decorator, ast.Call) else decorator
    return isinstance(function, ast.Attribute) and function.attr in _EVENTS


def is_implicit(method: ast.FunctionDef) -> bool:
    """Whether Python itself calls a method, such as ``__repr__`` while a value is described."""
    name = method.name
    return name.startswith("__") and name.endswith("__") and name not in {"__init__", "__call__"}


def has_yield(node: ast.FunctionDef) -> bool:
    """Whether a function is a generator."""
    return any(isinstance(inner, ast.Yield | ast.YieldFrom) for inner in ast.walk(node))
