"""Split a line of Python into its words and the values between them, for blocks with sockets.

``turtle.forward(n + 1)`` has the words ``turtle.forward(`` and ``)``, and one value. Variables that
are set, and what is before a dot or a call if it is only a name, belong to the words.
"""

import ast
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import zip_longest
from typing import NamedTuple

from learnblock.language.python.quotes import are_for_every_python
from learnblock.language.tree.loads import parsed

#: The values that have sockets for the values in them; others are one socket with Python.
_VALUES = (
    ast.Attribute,
    ast.Await,
    ast.BinOp,
    ast.BoolOp,
    ast.Call,
    ast.Compare,
    ast.Dict,
    ast.DictComp,
    ast.GeneratorExp,
    ast.IfExp,
    ast.JoinedStr,
    ast.Lambda,
    ast.List,
    ast.ListComp,
    ast.Name,
    ast.NamedExpr,
    ast.Set,
    ast.SetComp,
    ast.Subscript,
    ast.Tuple,
    ast.UnaryOp,
    ast.Yield,
    ast.YieldFrom,
)
_LINES = (
    ast.AnnAssign,
    ast.Assert,
    ast.Assign,
    ast.AugAssign,
    ast.Delete,
    ast.Expr,
    ast.Global,
    ast.Import,
    ast.ImportFrom,
    ast.Nonlocal,
    ast.Pass,
    ast.Raise,
    ast.Return,
)


class SplitLine(NamedTuple):
    """The words of a line, one more than the values between them."""

    words: tuple[str, ...]
    values: tuple[ast.expr, ...] = ()


Split = Callable[[str], SplitLine | None]


@lru_cache(maxsize=4096)
def value_form(text: str) -> SplitLine | None:
    """The form of an expression; None if Python alone shows it."""
    node = _only_statement(text)
    match node:
        case ast.Expr(value=ast.JoinedStr() as value):
            return _f_string_form(text.strip(), value)
        case ast.Expr(value=value) if isinstance(value, _VALUES):
            return _split(text, value)
    return None


@lru_cache(maxsize=4096)
def line_form(text: str) -> SplitLine | None:
    """The form of a statement on one line; None if Python alone shows it."""
    if text.startswith("@"):
        return SplitLine((text,))
    node = _only_statement(text)
    return _split(text, node) if isinstance(node, _LINES) else None


@lru_cache(maxsize=4096)
def header_form(header: str) -> SplitLine:
    """The form of the first line of a part of a block, without its colon."""
    texts = (f"{header}: pass", f"{header}:\n case _: pass")
    node = next(filter(None, map(_only_statement, texts)), None) or _case(header)
    return SplitLine((header,)) if node is None else _split(header, node)


def _case(header: str) -> ast.match_case | None:
    """The case that a first line begins, at the places of that line."""
    match _only_statement(f"match _:\n {header}: pass"):
        case ast.Match(cases=[case]):
            for node in ast.walk(case):
                if isinstance(node, ast.expr | ast.keyword | ast.arg):
                    node.lineno -= 1
                    node.col_offset -= 1
                    node.end_lineno = node.lineno
                    node.end_col_offset = (node.end_col_offset or 0) - 1
            return case
    return None


def filled(words: Sequence[str], texts: Sequence[str], split: Split) -> str:
    """The line with other values, in brackets where it would mean something else without them.

    In an f-string, texts get the other quotes where Python needs that.
    """
    values = [_value(text) for text in texts]
    for spellings in _spellings(texts, values):
        plain = _joined(words, spellings)
        form = split(plain)
        if form is None or form.words != tuple(words) or not _same(form.values, values):
            continue
        if are_for_every_python(plain):
            return plain
    return _joined(words, _in_brackets(texts))


def _spellings(texts: Sequence[str], values: Sequence[ast.expr | None]) -> Iterator[Sequence[str]]:
    """The ways to write some values, the preferred one first."""
    yield texts
    yield _in_brackets(texts)
    requoted = [
        text if value is None else ast.unparse(value)
        for text, value in zip(texts, values, strict=True)
    ]
    yield requoted
    yield _in_brackets(requoted)


def _in_brackets(texts: Sequence[str]) -> list[str]:
    return [f"({text})" for text in texts]


def _value(text: str) -> ast.expr | None:
    node = _only_statement(text)
    return node.value if isinstance(node, ast.Expr) else None


def _same(values: Sequence[ast.expr], others: Sequence[ast.expr | None]) -> bool:
    return all(
        other is not None and ast.dump(value) == ast.dump(other)
        for value, other in zip(values, others, strict=True)
    )


def _joined(words: Sequence[str], texts: Sequence[str]) -> str:
    return "".join(word + text for word, text in zip_longest(words, texts, fillvalue=""))


def _only_statement(text: str) -> ast.stmt | None:
    """The statement that the text is; None if it is not valid Python, or several statements."""
    body = parsed(text.strip()).body
    return body[0] if len(body) == 1 else None


def _split(text: str, node: ast.AST) -> SplitLine:
    written = text.strip().encode()
    values = sorted(_sockets(node), key=lambda value: value.col_offset)
    words: list[str] = []
    place = 0
    for value in values:
        words.append(written[place : value.col_offset].decode())
        place = value.end_col_offset or 0
    words.append(written[place:].decode())
    return SplitLine(tuple(words), tuple(values))


def _f_string_form(text: str, node: ast.JoinedStr) -> SplitLine | None:
    """The form of an f-string; None where Python 3.11 does not know where its values are."""
    form = _split(text, node)
    written = text.encode()
    segments = [
        written[value.col_offset : value.end_col_offset].decode(errors="replace")
        for value in form.values
    ]
    if _joined(form.words, segments) == text and _same(form.values, list(map(_value, segments))):
        return form
    return None


def _sockets(node: ast.AST) -> Iterator[ast.expr]:
    """The values in a node that have sockets of their own."""
    match node:
        case ast.Expr(value=value):
            yield from _sockets(value)
        case ast.Name() | ast.Constant():
            return
        case ast.FormattedValue(value=value, format_spec=format_spec):
            yield value
            if format_spec is not None:
                yield from _sockets(format_spec)
        case ast.Attribute(value=value):
            yield from _owner(value)
        case ast.AnnAssign(value=value):
            if value is not None:
                yield value
        case _:
            for part in _parts(node):
                yield from _socket(part)


def _parts(node: ast.AST) -> Iterable[ast.AST]:
    """The parts of a node in which there are values."""
    match node:
        case ast.Call(func=function, args=arguments, keywords=keywords):
            return (*_owner(function), *arguments, *keywords)
        case ast.Subscript(value=value, slice=ast.Tuple(elts=parts)) if any(
            isinstance(part, ast.Slice | ast.Starred) for part in parts
        ):
            # `:, 0` in `table[:, 0]` is no value by itself.
            return (value, *parts)
        case ast.JoinedStr(values=parts):
            return [part for part in parts if isinstance(part, ast.FormattedValue)]
        case ast.FunctionDef() | ast.AsyncFunctionDef():
            return (node.args,)
        case ast.Match(subject=value) | ast.match_case(guard=value):
            # A value in a pattern is no value by itself: a variable there would be set.
            return () if value is None else (value,)
    return ast.iter_child_nodes(node)


def _socket(part: ast.AST) -> Iterator[ast.expr]:
    """A value itself; of what is no value, the values in it."""
    match part:
        case ast.Starred() | ast.Slice() | ast.FormattedValue():
            yield from _sockets(part)
        case ast.stmt():
            return
        case ast.arguments(defaults=defaults, kw_defaults=others):
            yield from defaults
            yield from filter(None, others)
        case ast.expr() if isinstance(getattr(part, "ctx", None), ast.Store | ast.Del):
            return
        case ast.expr():
            yield part
        case ast.keyword() | ast.comprehension() | ast.withitem():
            yield from _sockets(part)


def _owner(node: ast.expr) -> Iterator[ast.expr]:
    """What is before a dot or a call, unless it is only names with dots."""
    match node:
        case ast.Attribute(value=value):
            yield from _owner(value)
        case ast.Name():
            return
        case _:
            yield node
