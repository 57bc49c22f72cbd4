"""Read statements of Python as a tree, with the comments and blank lines between them."""

import ast
import re
from collections.abc import Set as AbstractSet

from learnblock.language.python.comment_reader import CommentReader
from learnblock.language.python.expression_reader import (
    BINARY,
    Unlike,
    end_of,
    span_of,
    start_of,
)
from learnblock.language.python.skeleton import leading_globals
from learnblock.language.tree import markers, ranges
from learnblock.language.tree import raw as raw_python
from learnblock.language.tree.builtins import LOOPED
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Blank,
    Body,
    Branch,
    Break,
    Call,
    Comment,
    Continue,
    Deactivate,
    Def,
    Else,
    Expression,
    ForEach,
    ForRange,
    If,
    Import,
    Index,
    Item,
    Name,
    Number,
    Pass,
    Perform,
    Raw,
    Repeat,
    Return,
    Setup,
    SkillCall,
    Span,
    Statement,
    WaitUntil,
    When,
    While,
    WithoutRobot,
)

_ELSE = re.compile(r"\s*else\s*[:\\]")


class StatementReader(CommentReader):
    """Reads statements and bodies.

    `keeps_globals` is whether ``global`` is a statement of its own here, and not implied as at the
    head of a function with shared variables;
    `is_own_style` whether the file's author did not write it for a robot, and wants it as it is.
    """

    keeps_globals = True
    is_own_style = False
    #: The statements that are the first to set a local variable.
    first_of_locals: AbstractSet[ast.stmt] = frozenset()

    def trailing(self, body: Body, node: ast.stmt) -> Body:
        """A body with the comments below its last statement that are indented like it."""
        items: list[Item] = list(body)
        column = node.body[0].col_offset  # type: ignore[attr-defined]
        if self.line <= len(self.lines):
            self.notes_of_body(items, column)
        return stripped(tuple(as_statement(item) for item in items))

    def add_raw(self, items: list[Item], nodes: list[ast.stmt], index: int) -> int:
        first = nodes[index]
        last = index
        # Statements on the same line stay together.
        while last + 1 < len(nodes) and start_of(nodes[last + 1]) <= end_of(nodes[last]):
            last += 1
        start, end = start_of(first), end_of(nodes[last])
        if self.line > start:
            raise Unlike
        indent = self.lines[start - 1][: first.col_offset]
        text = markers.raw_text(self.lines[start - 1 : end], start, indent, self.in_string)
        span = Span(start, first.col_offset + 1, end, 1)
        items.append(Raw(text, span))
        self.line = end + 1
        return last + 1

    # Bodies.

    def block(
        self, nodes: list[ast.stmt], column: int, limit: int, *, top_level: bool = False
    ) -> list[Item]:
        """Read the statements `nodes`, indented by `column`, and comments up to line `limit`."""
        items: list[Item] = []
        index = 0
        while index < len(nodes):
            node = nodes[index]
            raw = self.notes(items, start_of(node), column)
            if raw:
                while index < len(nodes) and nodes[index].lineno < raw:
                    index += 1
                continue
            index = self.add(items, nodes, index, top_level=top_level)
        while self.notes(items, limit, column, leave=True):
            pass
        return items

    def add(self, items: list[Item], nodes: list[ast.stmt], index: int, *, top_level: bool) -> int:
        """Read one statement, or several as raw Python; return the index of the next."""
        node = nodes[index]
        saved = self.line
        if not top_level and not self.keeps_globals and node in leading_globals(nodes):
            if self.comment_after(node) is not None:
                items.append(self.own_comment(end_of(node)))
            self.line = end_of(node) + 1
            return index + 1
        try:
            inner = self.inner_comments(node)
            item = self.item(node) if top_level else self.statement(node)
        except Unlike:
            self.line = saved
            return self.add_python(items, nodes, index)
        items.extend(inner)
        items.append(item)
        self.line = max(self.line, end_of(node) + 1)
        return index + 1

    def add_python(self, items: list[Item], nodes: list[ast.stmt], index: int) -> int:
        """Read a statement without an equivalent in Block-Text, or several that share a line."""
        node = nodes[index]
        saved = self.line
        try:
            statements = self.python_items(node)
        except Unlike:
            self.line = saved
            return self.add_raw(items, nodes, index)
        items.extend(statements)
        self.line = max(self.line, end_of(node) + 1)
        return index + 1

    def python_items(self, node: ast.stmt) -> list[Item]:
        """Read a statement as Python that stays Python, with the comments inside it."""
        raise NotImplementedError

    def body(self, owner: int, nodes: list[ast.stmt], limit: int) -> Body:
        self.line = min(self.header_end(owner, nodes) + 1, start_of(nodes[0]))
        return stripped(
            tuple(as_statement(item) for item in self.block(nodes, nodes[0].col_offset, limit))
        )

    def own_body(self, node: ast.stmt, body: list[ast.stmt]) -> tuple[Body, str | None]:
        comment = self.header_comment(node.lineno, body)
        read = self.trailing(self.body(node.lineno, body, end_of(node) + 1), node)
        return (read if any(map(acts, read)) else (*read, Pass())), comment

    def part_body(self, line: int, nodes: list[ast.stmt], below: tuple[int, int] | None) -> Body:
        """Read the body of a part of an ``if``.

        Args:
            line: the line of its header.
            nodes: its statements.
            below: the first line of the header of the next part, and that of its colon. Comments
                above the colon, however they are indented, have no other place than this body.
        """
        read: list[Item] = list(self.body(line, nodes, end_of(nodes[-1]) + 1))
        column = nodes[0].col_offset
        if below is None:
            self.notes_of_body(read, column)
        else:
            while self.notes(read, below[0], column):
                pass
            read += self.comments_in(*below)
        body = stripped(tuple(as_statement(item) for item in read))
        return body if any(map(acts, body)) else (*body, Pass())

    # Statements.

    def item(self, node: ast.stmt) -> Item:
        """Read an item of the top level, or a statement."""
        raise NotImplementedError

    def statement(self, node: ast.stmt) -> Statement:  # noqa: PLR0911 - one for each kind
        comment = self.comment_after(node)
        span = span_of(node)
        match node:
            case ast.Expr(value=value):
                return self.perform(value, comment, span)
            case ast.Assign(targets=[target], value=value):
                read = self.target(target), "=", self.expression(value)
                return Assign(*read, comment, span, is_local=node in self.first_of_locals)
            case ast.AugAssign(target=target, op=operator, value=value):
                return self.augmented(target, operator, value, comment, span)
            case ast.Delete(targets=[ast.Subscript(value=values, slice=key)]) if (
                not isinstance(key, ast.Slice | ast.Tuple) and not self.is_own_style
            ):
                removed = (self.expression(values), self.expression(key))
                return Perform(Call("pop", removed, (), span), comment, span)
            case ast.Return(value=value):
                result = None if value is None else self.expression(value)
                return Return(result, comment, span)
            case ast.Pass():
                return Pass(comment, span)
            case ast.Break():
                return Break(comment, span)
            case ast.Continue():
                return Continue(comment, span)
            case _:
                return self.compound(node)

    def compound(self, node: ast.stmt) -> Statement:
        span = span_of(node)
        match node:
            case ast.If():
                return self.if_chain(node)
            case ast.While(test=test, body=body, orelse=[]):
                condition = self.expression(test)
                return While(condition, *self.own_body(node, body), span)
            case ast.For(
                target=ast.Name(id="_"),
                iter=ast.Call(
                    func=ast.Name(id="range"),
                    args=[count] | [ast.Constant(value=0), count],
                    keywords=[],
                ),
                body=body,
                orelse=[],
            ):
                return Repeat(self.expression(count), *self.own_body(node, body), span)
            case ast.For(target=target, iter=values, body=body, orelse=[]):
                return self.for_loop(node, target, values, body)
            case _:
                raise Unlike

    def for_loop(
        self, node: ast.For, target: ast.expr, values: ast.expr, body: list[ast.stmt]
    ) -> ForEach | ForRange:
        names = self.loop_variables(target)
        span = span_of(node)
        match values:
            case ast.Call(func=ast.Name(id="range"), args=bounds, keywords=[]):
                if len(names) != 1:
                    raise Unlike
                start, stop, step = self.bounds(bounds)
                return ForRange(names[0], start, stop, step, *self.own_body(node, body), span)
        return ForEach(names, self.looped(values), *self.own_body(node, body), span)

    def loop_variables(self, target: ast.expr) -> tuple[Name, ...]:
        parts = target.elts if isinstance(target, ast.Tuple) and target.elts[1:] else [target]
        targets = [self.target(part) for part in parts]
        names = tuple(target for target in targets if isinstance(target, Name))
        if len(names) != len(targets):
            raise Unlike
        return names

    def looped(self, values: ast.expr) -> Expression:
        """What a loop goes through; a list of it is made first only if the author makes one."""
        match values:
            case ast.Call(func=ast.Name(id="list")):
                looped = self.expression(values)
                if isinstance(looped, Call) and looped.name in LOOPED:
                    return Call("list", (looped,), (), looped.span)
                return looped
            case ast.Call():
                looped = self.expression(_listed(values))
                if isinstance(looped, Call) and looped.name in LOOPED:
                    return looped
        return self.expression(values)

    def bounds(self, bounds: list[ast.expr]) -> tuple[Expression, Expression, Expression | None]:
        read = [self.expression(bound) for bound in bounds[:1]]
        if len(bounds) == 1:
            return Number("0"), _last(read[0], 1), None
        if len(bounds) == 2:
            return read[0], _last(self.expression(bounds[1]), 1), None
        if len(bounds) != 3:
            raise Unlike
        step = self.expression(bounds[2])
        direction = ranges.direction(step)
        if direction:
            return read[0], _last(self.expression(bounds[1]), direction), step
        match bounds[1]:
            case ast.BinOp(
                left=stop,
                op=ast.Add(),
                right=ast.IfExp(
                    test=ast.Compare(
                        left=tested, ops=[ast.Gt()], comparators=[ast.Constant(value=0)]
                    ),
                    body=ast.Constant(value=1),
                    orelse=ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=1)),
                ),
            ) if self.expression(tested) == step:
                return read[0], self.expression(stop), step
        raise Unlike

    def if_chain(self, node: ast.If) -> If:
        branches: list[Branch] = []
        part: ast.If = node
        while True:
            condition = self.expression(part.test)
            first = part is node
            comment = self.header_comment(part.lineno, part.body)
            body = self.part_body(part.lineno, part.body, self.next_header(part))
            span = span_of(part) if first else Span(part.lineno, node.col_offset + 1)
            branches.append(Branch(condition, body, comment, span._replace(end_line=part.lineno)))
            if not part.orelse:
                return If(tuple(branches), None, span_of(node))
            following = part.orelse[0]
            if len(part.orelse) == 1 and isinstance(following, ast.If) and self.is_elif(following):
                part = following
                continue
            return If(tuple(branches), self.otherwise(part, node), span_of(node))

    def next_header(self, part: ast.If) -> tuple[int, int] | None:
        """The first line of the ``elif`` or ``else`` below a part, and the line of its colon."""
        if not part.orelse:
            return None
        following = part.orelse[0]
        if isinstance(following, ast.If) and self.is_elif(following):
            return following.lineno, self.header_end(following.lineno, following.body)
        line = self.else_line(start_of(following))
        return line, self.header_end(line, part.orelse)

    def is_elif(self, node: ast.If) -> bool:
        return self.lines[node.lineno - 1][node.col_offset :].startswith("elif")

    def otherwise(self, part: ast.If, node: ast.If) -> Else:
        line = self.else_line(start_of(part.orelse[0]))
        comment = self.header_comment(line, part.orelse)
        body = self.part_body(line, part.orelse, None)
        return Else(body, comment, Span(line, node.col_offset + 1, line, node.col_offset + 6))

    def else_line(self, first: int) -> int:
        line = first
        while line > 1 and not _ELSE.match(self.lines[line - 1]):
            line -= 1
        return line

    def perform(self, call: ast.expr, comment: str | None, span: Span) -> Statement:
        match call:
            case ast.Call(
                func=ast.Attribute(value=owner, attr="wait_until"),
                args=[ast.Lambda(args=arguments, body=condition)],
                keywords=[],
            ) if self.is_robot(owner) and not any(ast.iter_child_nodes(arguments)):
                return WaitUntil(self.expression(condition), comment, span)
            case ast.Call(
                func=ast.Attribute(
                    value=ast.Name(id=name), attr="activate" | "deactivate" as method
                ),
                args=[],
                keywords=[],
            ) if name in self.whens or not (self.is_own_style or name == self.robot):
                plain = self.whens.get(name) or self.called(name)
                node = Activate if method == "activate" else Deactivate
                return node(plain, comment, span)
            case ast.Call(func=ast.Attribute(value=owner, attr="run"), args=[]) if self.is_robot(
                owner
            ):
                # Block-Text implies it at the end; elsewhere, it stays Python.
                raise Unlike
        value = self.exact(call)
        if not isinstance(value, Call | SkillCall):
            raise Unlike
        return Perform(value, comment, span)

    def augmented(
        self,
        target: ast.expr,
        operator: ast.operator,
        value: ast.expr,
        comment: str | None,
        span: Span,
    ) -> Assign:
        symbol = BINARY.get(type(operator))
        if symbol is None:
            raise Unlike
        return Assign(self.target(target), symbol + "=", self.expression(value), comment, span)

    def target(self, node: ast.expr) -> Name | Index:
        if isinstance(node, ast.Name | ast.Attribute | ast.Subscript):
            read = self.exact(node)
            root: Expression = read
            while isinstance(root, Index):
                root = root.value
            if isinstance(read, Name | Index) and isinstance(root, Name | Call | SkillCall):
                return read
        raise Unlike


def _listed(node: ast.expr) -> ast.Call:
    """A list of a value."""
    function = ast.copy_location(ast.Name("list", ast.Load()), node)
    return ast.copy_location(ast.Call(function, [node], []), node)


def _last(end: Expression, direction: int) -> Expression:
    last = ranges.last(end, direction)
    if last is None:
        raise Unlike
    return last


def as_statement(item: Item) -> Statement:
    if isinstance(item, Def | When | Import | Setup | WithoutRobot):
        raise Unlike
    return item


def stripped(body: Body) -> Body:
    """A body without leading, trailing or consecutive blank lines."""
    statements: list[Statement] = []
    for item in body:
        if not isinstance(item, Blank) or (statements and not isinstance(statements[-1], Blank)):
            statements.append(item)
    if statements and isinstance(statements[-1], Blank):
        statements.pop()
    return tuple(statements)


def acts(item: Statement) -> bool:
    """Whether a statement does something; without such a statement, a body is empty."""
    if isinstance(item, Raw):
        return raw_python.code_lines(item.text)
    return not isinstance(item, Comment | Blank)
