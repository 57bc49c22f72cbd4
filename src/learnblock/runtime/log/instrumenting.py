"""Instruments a program: the same program, which also reports its steps.

Each expression that the log wants to know is put into a call of a noting function, which returns
its value unchanged. Lines stay as they are, so that errors, breakpoints and the trace do, too.
Left alone is what only Python itself can say: generators, coroutines, comprehensions, and what is
in a class, of whose methods only the calls are noted.
"""

import ast
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from learnblock.runtime.log.nodes import Kind, Node
from learnblock.runtime.log.numbering import Numbering, Placed
from learnblock.runtime.log.syntax import (
    changed_list,
    declarations,
    has_yield,
    is_event,
    is_implicit,
    names_captured,
    names_read,
    names_written,
    values_of,
    written_value,
)

#: The names of the noting functions, which the program finds among its builtins.
CONDITION, LOOP, TURN = "__log_condition__", "__log_loop__", "__log_turn__"
OPERAND, RESULT, WRITE = "__log_operand__", "__log_result__", "__log_write__"
CALLS, ENTER, LEAVE = "__log_calls__", "__log_enter__", "__log_leave__"
RETURN, JUMP = "__log_return__", "__log_jump__"
#: As `RESULT`, of a call that may change a list; and variables that have been deleted.
CHANGER, GONE = "__log_changer__", "__log_gone__"
NOTING = (
    *(CONDITION, LOOP, TURN, OPERAND, RESULT, WRITE, CALLS, ENTER, LEAVE, RETURN, JUMP),
    *(CHANGER, GONE),
)

#: Functions that change none of their arguments.
_HARMLESS = frozenset(
    {"abs", "bool", "chr", "enumerate", "float", "int", "len", "max", "min", "ord", "print"}
    | {"range", "round", "sorted", "str", "sum", "zip"}
)
#: Modules of which that is true, and the robot.
_HARMLESS_BASES = frozenset({"math", "robot", "time"})
#: What a `when`'s function tells about it.
_STATES = frozenset({"active", "time"})
#: Inside these nothing is noted.
_ALONE = (
    ast.AsyncFunctionDef,
    ast.Lambda,
    ast.ListComp,
    ast.SetComp,
    ast.DictComp,
    ast.GeneratorExp,
    ast.JoinedStr,
)
_JUMPS = {ast.Break: Kind.BREAK, ast.Continue: Kind.CONTINUE, ast.Pass: Kind.PASS}


@dataclass(frozen=True)
class Instrumented:
    """A program that reports its steps.

    Args:
        tree: its syntax tree, with the lines of the original.
        nodes: the places that it tells about.
    """

    tree: ast.Module
    nodes: tuple[Node, ...]


# Why: docs/decisions.md, "A log is made by an instrumented copy of the program"
def instrument(source: str, functions: Iterable[str] = ()) -> Instrumented:
    """Instrument a program.

    Args:
        source: its Python.
        functions: the names of functions that are instrumented elsewhere, as in another cell.

    Raises:
        SyntaxError: it is not Python.
        RecursionError: it is nested too deeply.
    """
    tree = ast.parse(source)
    work = _Instrumenting(source, tree, functions)
    tree.body = work.block(tree.body)
    return Instrumented(ast.fix_missing_locations(tree), tuple(work.nodes.numbered))


class _Instrumenting(ast.NodeTransformer):
    """The instrumenting of one program."""

    def __init__(self, source: str, tree: ast.Module, functions: Iterable[str]) -> None:
        self.nodes = Numbering(source)
        own = {node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}
        self._functions = own.union(functions)

    def block(self, body: Iterable[ast.stmt]) -> list[ast.stmt]:
        """Instrument the statements of a block."""
        statements: list[ast.stmt] = []
        for statement in body:
            new: Any = self.visit(statement)
            statements.extend(new if isinstance(new, list) else [new])
        return statements

    def visit(self, node: ast.AST) -> ast.AST | list[ast.stmt]:
        if isinstance(node, _ALONE):
            return node
        new: ast.AST | list[ast.stmt] = super().visit(node)
        return new

    # Expressions.

    def visit_Call(self, node: ast.Call) -> ast.AST:
        function = node.func
        base, name = "", ""
        if isinstance(function, ast.Attribute):
            name = function.attr
            base = function.value.id if isinstance(function.value, ast.Name) else ""
        elif isinstance(function, ast.Name):
            name = function.id
        number = self.nodes.begin(node, Kind.CALL, name=name, base=base, reads=names_read(node))
        if name == "wait_until" and len(node.args) == 1:
            self._instrument_condition(node.args[0], Kind.UNTIL)
        node.args = [self._expression(arg) for arg in node.args]
        for keyword in node.keywords:
            keyword.value = self._expression(keyword.value)
        if not base and name in self._functions:
            node.func = _noted(CALLS, number, function)
        elif isinstance(function, ast.Attribute):
            function.value = self._expression(function.value)
        self.nodes.end(number)
        return _noted(RESULT if self._is_harmless(base, name) else CHANGER, number, node)

    def _is_harmless(self, base: str, name: str) -> bool:
        """Whether a call changes no list without its being noted."""
        if base:
            return base in _HARMLESS_BASES or base in self._functions
        return name in _HARMLESS or name in self._functions

    def visit_NamedExpr(self, node: ast.NamedExpr) -> ast.AST:
        names = (node.target.id,)
        number = self.nodes.begin(node, Kind.ASSIGN, reads=names_read(node.value), writes=names)
        node.value = self._expression(node.value)
        self.nodes.end(number)
        node.value = _noted(WRITE, number, node.value)
        return node

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        is_state = (
            isinstance(node.ctx, ast.Load)
            and isinstance(node.value, ast.Name)
            and node.attr in _STATES
            and node.value.id in self._functions
        )
        if not is_state:
            return self.generic_visit(node)
        number = self.nodes.begin(node, Kind.STATE, name=node.attr, base=node.value.id)  # type: ignore[attr-defined] # a name
        return _noted(OPERAND, number, node)

    def visit_Compare(self, node: ast.Compare) -> ast.AST:
        node.left = self._operand(node.left)
        node.comparators = [self._operand(comparator) for comparator in node.comparators]
        return node

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.AST:
        node.values = [self._operand(operand) for operand in node.values]
        return node

    def _expression(self, node: ast.expr) -> ast.expr:
        new: ast.expr = self.visit(node)  # type: ignore[assignment] # an expression stays one
        return new

    def _operand(self, node: ast.expr) -> ast.expr:
        if not isinstance(node, ast.Name):
            return self._expression(node)
        number = self.nodes.begin(node, Kind.NAME, name=node.id, reads=(node.id,))
        return _noted(OPERAND, number, node)

    def _condition(
        self, test: ast.expr, kind: Kind, at: Placed, noting: str
    ) -> tuple[int, ast.expr]:
        number = self.nodes.begin(test, kind, reads=names_read(test), at=at)
        new = self._operand(test)
        self.nodes.end(number)
        return number, _noted(noting, number, new)

    def _instrument_condition(self, node: ast.AST, kind: Kind) -> int:
        """Instrument the condition of a `when` or of `wait until`, given as a lambda."""
        if not isinstance(node, ast.Lambda):
            return -1
        number, node.body = self._condition(node.body, kind, node, CONDITION)
        return number

    # Statements.

    def visit_If(self, node: ast.If) -> ast.AST:
        number, node.test = self._condition(node.test, Kind.IF, node, CONDITION)
        node.body = self._controlled(number, node.body)
        node.orelse = self._controlled(number, node.orelse, branch=False)
        self.nodes.end(number)
        return node

    def visit_While(self, node: ast.While) -> ast.AST:
        number, node.test = self._condition(node.test, Kind.WHILE, node, LOOP)
        node.body = self._controlled(number, node.body)
        node.orelse = self.block(node.orelse)
        self.nodes.end(number, node.end_lineno)
        return node

    def visit_For(self, node: ast.For) -> ast.AST:
        targets = names_written(node.target)
        number = self.nodes.begin(node, Kind.FOR, reads=names_read(node.iter), writes=targets)
        node.iter = self._expression(node.iter)
        body = self._controlled(number, node.body)
        value = written_value(node.target)
        node.body = [_statement(TURN, number, value, node), *body]
        node.orelse = self.block(node.orelse)
        self.nodes.end(number, node.end_lineno)
        return node

    def visit_With(self, node: ast.With) -> ast.AST:
        targets = [item.optional_vars for item in node.items if item.optional_vars]
        for item in node.items:
            item.context_expr = self._expression(item.context_expr)
        bound = self._bound(
            node, tuple(name for target in targets for name in names_written(target))
        )
        node.body = [*bound, *self.block(node.body)]
        return node

    def visit_Try(self, node: ast.Try | ast.TryStar) -> ast.AST:
        node.body = self.block(node.body)
        for handler in node.handlers:
            names = (handler.name,) if handler.name else ()
            # Python deletes the name at the end of the block.
            gone = self._deleted(handler.body[-1], names)
            bound = self._bound(handler, names)
            handler.body = [*bound, *self.block(handler.body), *gone]
        node.orelse = self.block(node.orelse)
        node.finalbody = self.block(node.finalbody)
        return node

    visit_TryStar = visit_Try  # noqa: N815 - `ast.NodeVisitor` looks for this name

    def visit_Match(self, node: ast.Match) -> ast.AST:
        node.subject = self._expression(node.subject)
        for case in node.cases:
            names = tuple(dict.fromkeys(names_captured(case.pattern)))
            if case.guard:
                case.guard = self._expression(case.guard)
            case.body = [*self._bound(case.body[0], names), *self.block(case.body)]
        return node

    def visit_Delete(self, node: ast.Delete) -> ast.AST | list[ast.stmt]:
        gone = tuple(target.id for target in node.targets if isinstance(target, ast.Name))
        changed = tuple(
            name
            for target in node.targets
            if not isinstance(target, ast.Name)
            for name in names_written(target)
        )
        more = self._bound(node, tuple(name for name in changed if name not in gone))
        return [node, *self._deleted(node, gone), *more]

    def _bound(self, at: ast.stmt | ast.ExceptHandler, names: tuple[str, ...]) -> list[ast.stmt]:
        """Note variables that a statement or an ``except`` has written, at the place of another."""
        if not names:
            return []
        number = self.nodes.begin(at, Kind.ASSIGN, writes=names)
        if isinstance(at, ast.ExceptHandler):
            self.nodes.end(number, at.lineno)
        return [_statement(WRITE, number, values_of(names), at)]

    def _deleted(self, at: ast.stmt, names: tuple[str, ...]) -> list[ast.stmt]:
        if not names:
            return []
        number = self.nodes.begin(at, Kind.ASSIGN, writes=names)
        return [_statement(GONE, number, ast.Constant(None), at)]

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        with self.nodes.definition():
            is_when = any(map(is_event, node.decorator_list))
            condition = -1
            for decorator in node.decorator_list:
                if is_when and isinstance(decorator, ast.Call) and decorator.args:
                    condition = self._instrument_condition(decorator.args[0], Kind.WHEN)
            if condition >= 0:
                self.nodes.change(condition, name=node.name)
            parameters = tuple(arg.arg for arg in node.args.args)
            self.nodes.enter_function(-1)
            number = self.nodes.begin(
                node,
                Kind.FUNCTION,
                name=node.name,
                parameters=parameters,
                is_when=is_when,
                first=min([node.lineno, *(each.lineno for each in node.decorator_list)]),
            )
            self.nodes.enter_function(number)
            if not has_yield(node):
                node.body = self._function_body(node, number)
            self.nodes.end(number, node.end_lineno)
        return node

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.AST:
        """Note the calls of the methods, and nothing else in a class."""
        for method in node.body:
            if isinstance(method, ast.FunctionDef) and not is_implicit(method):
                self._note_calls(method, f"{node.name}.{method.name}")
        return node

    def _note_calls(self, method: ast.FunctionDef, name: str) -> None:
        if has_yield(method):
            return
        number = self.nodes.begin(method, Kind.FUNCTION, name=name, first=method.lineno)
        self.nodes.end(number, method.end_lineno)
        ahead = [*declarations(method.body)]
        # Without the arguments: to describe an object may call its methods.
        method.body = self._enclosed(method, number, (), ahead, method.body[len(ahead) :])

    def _function_body(self, node: ast.FunctionDef, number: int) -> list[ast.stmt]:
        ahead = [*declarations(node.body)]
        return self._enclosed(
            node,
            number,
            tuple(arg.arg for arg in node.args.args),
            ahead,
            self.block(node.body[len(ahead) :]),
        )

    def _enclosed(
        self,
        node: ast.FunctionDef,
        number: int,
        arguments: Iterable[str],
        ahead: list[ast.stmt],
        body: list[ast.stmt],
    ) -> list[ast.stmt]:
        """A function's body, with a note where it is entered and left."""
        # The line where Python says that the function begins, so that it isn't a line of its body.
        at = node.decorator_list[0] if node.decorator_list else node
        values = ast.Tuple([ast.Name(name, ast.Load()) for name in arguments], ast.Load())
        left = _statement(LEAVE, number, ast.Constant(None), at)
        enclosed = ast.Try(
            body=body or [ast.Pass(lineno=node.lineno, col_offset=0)],
            handlers=[],
            orelse=[],
            finalbody=[left],
        )
        ast.copy_location(enclosed, at)
        return [*ahead, _statement(ENTER, number, values, at), enclosed]

    def visit_Return(self, node: ast.Return) -> ast.AST:
        number = self.nodes.begin(node, Kind.RETURN, reads=names_read(node))
        value = (
            self._expression(node.value)
            if node.value
            else ast.copy_location(ast.Constant(None), node)
        )
        node.value = _noted(RETURN, number, value)
        self.nodes.end(number)
        return node

    def _visit_jump(self, node: ast.stmt) -> list[ast.stmt]:
        number = self.nodes.begin(node, _JUMPS[type(node)])
        return [_statement(JUMP, number, ast.Constant(None), node), node]

    visit_Break = _visit_jump  # noqa: N815 - `ast.NodeVisitor` looks for this name
    visit_Continue = _visit_jump  # noqa: N815
    visit_Pass = _visit_jump  # noqa: N815

    def visit_Assign(self, node: ast.Assign) -> ast.AST | list[ast.stmt]:
        names = tuple(name for target in node.targets for name in names_written(target))
        number = self.nodes.begin(node, Kind.ASSIGN, reads=names_read(node), writes=names)
        node.value = self._expression(node.value)
        self.nodes.end(number)
        if all(isinstance(target, ast.Name) for target in node.targets):
            node.value = _noted(WRITE, number, node.value)
            return node
        return [node, *self._writes_after(node, number)]

    def visit_AugAssign(self, node: ast.AugAssign) -> list[ast.stmt]:
        number = self.nodes.begin(
            node, Kind.ASSIGN, reads=names_read(node), writes=names_written(node.target)
        )
        node.value = self._expression(node.value)
        self.nodes.end(number)
        return [node, *self._writes_after(node, number)]

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.AST:
        if node.value is None:
            return node
        number = self.nodes.begin(
            node, Kind.ASSIGN, reads=names_read(node.value), writes=names_written(node.target)
        )
        node.value = _noted(WRITE, number, self._expression(node.value))
        self.nodes.end(number)
        return node

    def visit_Expr(self, node: ast.Expr) -> ast.AST | list[ast.stmt]:
        changed = changed_list(node.value)
        if not changed:
            node.value = self._expression(node.value)
            return node
        number = self.nodes.begin(
            node, Kind.ASSIGN, reads=names_read(node.value), writes=(changed,)
        )
        node.value = self._expression(node.value)
        self.nodes.end(number)
        return [node, *self._writes_after(node, number)]

    def _writes_after(self, node: ast.stmt, number: int) -> list[ast.stmt]:
        """Note the variables that a statement has changed, behind it."""
        names = self.nodes.numbered[number].writes
        return [_statement(WRITE, number, values_of(names), node)] if names else []

    def visit_Import(self, node: ast.Import) -> ast.AST:
        return node

    def _controlled(
        self, number: int, body: Sequence[ast.stmt], *, branch: bool = True
    ) -> list[ast.stmt]:
        with self.nodes.controlled_by(number, branch=branch):
            return self.block(body)


def _noted(noting: str, number: int, value: ast.expr) -> ast.expr:
    call = ast.Call(ast.Name(noting, ast.Load()), [ast.Constant(number), value], [])
    for new in (call, call.func, call.args[0]):
        ast.copy_location(new, value)
    return call


def _statement(noting: str, number: int, value: ast.expr, at: ast.AST) -> ast.stmt:
    call = ast.Call(ast.Name(noting, ast.Load()), [ast.Constant(number), value], [])
    statement = ast.Expr(call)
    for new in ast.walk(statement):
        if isinstance(new, ast.expr | ast.stmt):
            ast.copy_location(new, at)
            # All on its first line: a block of several lines is the statement's own affair.
            new.end_lineno = new.lineno
            new.end_col_offset = new.col_offset
    return statement
