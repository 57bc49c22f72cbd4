"""The comments in generated Python that mark what Python cannot express.

``# main`` is above the statements of `main`, ``# end`` above what follows them, and a block of raw
Python is between ``# python`` and ``# end``. A user's comment that looks like a marker gets another
``#``. A program without a robot has its main program below `IF_MAIN` instead, as in other Python.
"""

import ast
import io
import re
import tokenize
from collections.abc import Container
from functools import lru_cache
from typing import NamedTuple

from learnblock.language.tree.loads import matched_names, parsed

MAIN, END, PYTHON = "main", "end", "python"
_MARKERS = frozenset((MAIN, END, PYTHON))
#: The first line of the main program, without its colon, in a program without a robot.
IF_MAIN = 'if __name__ == "__main__"'
_PLAIN_END = re.compile(r"(\s*)(#[# ]*end\s*)")
_ESCAPED_END = re.compile(r"(\s*)# (#[# ]*end\s*)")


class NotedComment(NamedTuple):
    """A comment of a Python file.

    Args:
        column: the column, from 0.
        text: the comment without the ``#`` and surrounding white space.
        own_line: whether nothing else is on its line.
        inside: whether it is inside brackets.
    """

    column: int
    text: str
    own_line: bool
    inside: bool


class Notes(NamedTuple):
    """The parts of a file that Python's syntax tree omits, by line (from 1).

    Args:
        comments: the comment of each line that has one.
        in_string: the lines that begin inside a string.
        ends: the last line of each logical line, in order.
    """

    comments: dict[int, NotedComment]
    in_string: set[int]
    ends: list[int]


def notes(text: str) -> Notes | None:
    """The comments of Python source and its lines inside strings; None if it cannot be parsed."""
    notes = Notes({}, set(), [])
    depth = 0
    opened: list[int] = []
    try:
        for token in tokenize.generate_tokens(io.StringIO(text, newline="").readline):
            if token.type == tokenize.COMMENT:
                own_line = not token.line[: token.start[1]].strip()
                comment = token.string[1:].strip()
                noted = NotedComment(token.start[1], comment, own_line, depth > 0)
                notes.comments[token.start[0]] = noted
            elif token.type == tokenize.NEWLINE:
                notes.ends.append(token.start[0])
            elif token.type == tokenize.STRING:
                notes.in_string.update(range(token.start[0] + 1, token.end[0] + 1))
            elif token.type in _STRING_STARTS:
                opened.append(token.start[0])
            elif token.type in _STRING_ENDS:
                notes.in_string.update(range(opened.pop() + 1, token.end[0] + 1))
            elif token.type == tokenize.OP and token.string in {"(", "[", "{"}:
                depth += 1
            elif token.type == tokenize.OP and token.string in {")", "]", "}"}:
                depth -= 1
    except (tokenize.TokenError, SyntaxError, IndexError, ValueError):
        return None
    return notes


# Since 3.12 an f-string is several tokens, since 3.14 a template string too.
_STRING_STARTS = {getattr(tokenize, name, -1) for name in ("FSTRING_START", "TSTRING_START")}
_STRING_ENDS = {getattr(tokenize, name, -1) for name in ("FSTRING_END", "TSTRING_END")}


def escaped(comment: str) -> str:
    """A user's comment as written in Python."""
    return "# " + comment if comment.lstrip("# ") in _MARKERS else comment


def unescaped(comment: str) -> str:
    """The user's comment for a `comment` in Python."""
    if comment.startswith("# ") and comment.lstrip("# ") in _MARKERS:
        return comment[2:].lstrip(" ")
    return comment


def is_long_text(text: str) -> bool:
    """Whether raw Python is only text on several lines, which needs no markers around it."""
    if text[:1] not in "rRuU\"'" or text.count("\n") < 2 or not text.endswith("\n"):
        return False
    match parsed(text).body:
        case [ast.Expr(value=ast.Constant(value=str()), lineno=1, end_lineno=last)]:
            return last == text.count("\n") and text.rstrip("\n") == text[:-1]
    return False


def raw_lines(text: str, indent: str) -> list[str]:
    """The lines of a block of raw Python between its markers, indented by `indent`."""
    noted = notes(text)
    in_string = noted.in_string if noted else set()
    result = []
    for number, line in enumerate(text.removesuffix("\n").split("\n") if text else [], 1):
        kept = line
        if number not in in_string:
            kept = _PLAIN_END.sub(r"\1# \2", line) if _PLAIN_END.fullmatch(line) else line
            kept = indent + kept if kept else ""
        result.append(kept)
    return result


def raw_text(lines: list[str], first: int, indent: str, in_string: set[int]) -> str:
    """The raw Python in the `lines` of a file, which begin at line `first`."""
    result = []
    for number, line in enumerate(lines, first):
        kept = line
        if number not in in_string:
            kept = line.removeprefix(indent) if line.startswith(indent) else line.lstrip(" \t")
            if _ESCAPED_END.fullmatch(kept):
                kept = _ESCAPED_END.sub(r"\1\2", kept)
        result.append(kept + "\n")
    return "".join(result)


@lru_cache(maxsize=4096)
def raw_names(text: str) -> frozenset[str]:
    """The variables that Python source reads or sets; empty if it is not valid Python."""
    return frozenset(variable_names(parsed(text.removeprefix("@"))))


def variable_names(tree: ast.AST, whens: Container[str] | None = None) -> set[str]:
    """The variables of a Python tree.

    Args:
        tree: the tree of a file or a part of one.
        whens: names that are listed only if more than their state is used; None for all names.
    """
    names: set[str] = set()
    states: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and node.attr in STATE_ATTRIBUTES:
            if isinstance(node.value, ast.Name) and (whens is None or node.value.id in whens):
                states.add(id(node.value))
        elif isinstance(node, ast.Name) and id(node) not in states:
            names.add(node.id)
        elif isinstance(node, ast.arg):
            names.add(node.arg)
        else:
            names.update(matched_names(node))
    return names


def set_names(text: str) -> set[str]:
    """The variables that Python source sets, and the parameters of its functions."""
    names: set[str] = set()
    for node in ast.walk(parsed(text.removeprefix("@"))):
        match node:
            case ast.arg(arg=name) | ast.Name(id=name, ctx=ast.Store()):
                names.add(name)
            case _:
                names.update(matched_names(node))
    return names


def defined_names(text: str) -> set[str]:
    """The names that Python source imports and defines, and those of the errors that it catches."""
    names: set[str] = set()
    for node in ast.walk(parsed(text)):
        match node:
            case (
                ast.FunctionDef(name=name)
                | ast.AsyncFunctionDef(name=name)
                | ast.ClassDef(name=name)
                | ast.ExceptHandler(name=str(name))
            ):
                names.add(name)
            case ast.alias(name=name, asname=other):
                names.add((other or name).partition(".")[0])
    return names


STATE_ATTRIBUTES = frozenset(("active", "time", "activate", "deactivate"))
