"""Signatures of skills, read from their source without running it."""

import ast
import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from learnblock.blocks.schema.configuration import ParameterType, Returns
from learnblock.blocks.source.hints import FieldType, field_type
from learnblock.blocks.source.uses import UsedNames, uses_of
from learnblock.errors import HintError
from learnblock.i18n import Phrase
from learnblock.storage import skill_files

_BY_DEFAULT: dict[str, ParameterType] = {
    "float": "float",
    "int": "int",
    "str": "string",
    "bool": "boolean",
    "list": "list",
}


@dataclass(frozen=True, slots=True)
class FilePosition:
    """A position in a file: line and columns, counted from 1."""

    line: int
    column: int
    end_column: int


@dataclass(frozen=True, slots=True)
class Argument:
    """A parameter after the robot.

    Args:
        name: the name of the parameter.
        field: the field for its hint, else for its default; a number if it has neither.
        is_said: whether the hint or the default determines the field.
        required: whether there is no default.
        default: a float, int, str, bool or list; None if it is not a literal.
        is_constant: whether the default is a literal.
        wrong: the mistake in its hint, or None.
        place: the position of its name.
    """

    name: str
    field: FieldType
    is_said: bool
    required: bool
    default: object
    is_constant: bool
    wrong: Phrase | None
    place: FilePosition


@dataclass(frozen=True, slots=True)
class Signature:
    """The signature of a skill's function.

    Args:
        name: the name of the function.
        robot: the name of its first parameter.
        arguments: the other parameters, in order.
        answers: whether it returns a value.
        returns: the kind of that value, if a hint says so.
        is_said: whether a hint says if it does; otherwise that follows from its `return`s.
        summary: the first paragraph of its docstring, if any.
        unfit: parameters that a block cannot set: ``*args``, and keyword-only ones without default.
        place: the position of its name.
        uses: what it uses, and what the functions of its file do that it calls.
    """

    name: str
    robot: str
    arguments: tuple[Argument, ...]
    answers: bool
    returns: Returns
    is_said: bool
    summary: str
    unfit: tuple[str, ...]
    place: FilePosition
    uses: UsedNames = field(default_factory=UsedNames)


def signatures(source: str, filename: str) -> tuple[Signature, ...]:
    """The signatures in a Python file; if several functions have the same name, the last one.

    Raises:
        ProgramError: the source is not valid Python.
    """
    tree = skill_files.parse(source, filename)
    uses = uses_of(tree)
    signatures = {function.name: signature(function) for function in skill_files.functions(tree)}
    return tuple(replace(signature, uses=uses[name]) for name, signature in signatures.items())


def signature(function: ast.FunctionDef) -> Signature:
    """The signature of a function that takes the robot first."""
    positional = [*function.args.posonlyargs, *function.args.args]
    has_hint = function.returns is not None
    summary = (ast.get_docstring(function) or "").partition("\n\n")[0]
    start = function.col_offset + len("def ")
    return Signature(
        name=function.name,
        robot=positional[0].arg,
        arguments=tuple(_arguments(function.args)),
        answers=_answers(function),
        returns=_returns(function.returns),
        is_said=has_hint,
        summary=" ".join(summary.split()),
        unfit=tuple(_unfit(function.args)),
        place=FilePosition(function.lineno, start + 1, start + 1 + len(function.name)),
    )


def _arguments(arguments: ast.arguments) -> Iterator[Argument]:
    positional = [*arguments.posonlyargs, *arguments.args]
    required = len(positional) - len(arguments.defaults)
    for i, argument in enumerate(positional[1:], start=1):
        yield _argument(argument, arguments.defaults[i - required] if i >= required else None)


def _argument(argument: ast.arg, expression: ast.expr | None) -> Argument:
    default, is_constant = _constant(expression)
    field, wrong = _field(argument.annotation)
    by_default = _BY_DEFAULT.get(type(default).__name__)
    column = argument.col_offset + 1
    return Argument(
        name=argument.arg,
        field=field or FieldType(by_default or "float"),
        is_said=bool(field or by_default),
        required=expression is None,
        default=default,
        is_constant=is_constant,
        wrong=wrong,
        place=FilePosition(argument.lineno, column, column + len(argument.arg)),
    )


def _field(hint: ast.expr | None) -> tuple[FieldType | None, Phrase | None]:
    """The field of a hint, or the mistake in the hint."""
    if hint is None:
        return None, None
    try:
        return field_type(hint), None
    except HintError as error:
        return None, error.phrase


def _constant(expression: ast.expr | None) -> tuple[object, bool]:
    """The value of a default, and whether it is a literal."""
    if expression is None:
        return None, False
    try:
        value: object = ast.literal_eval(expression)
    except (ValueError, TypeError, RecursionError, MemoryError):
        return None, False
    return (value, True) if _is_plain(value) else (None, False)


def _is_plain(value: object) -> bool:
    """Whether the value can be stored as JSON."""
    if isinstance(value, list):
        return all(map(_is_plain, value))
    if isinstance(value, float):
        return math.isfinite(value)
    if isinstance(value, str):
        # A file cannot contain half a character, such as "\ud800".
        return value.encode("utf-8", "ignore").decode() == value
    return value is None or isinstance(value, int)


def _unfit(arguments: ast.arguments) -> Iterator[str]:
    for default, argument in zip(arguments.kw_defaults, arguments.kwonlyargs, strict=True):
        if default is None:
            yield argument.arg
    if arguments.vararg:
        yield f"*{arguments.vararg.arg}"


def _returns(hint: ast.expr | None) -> Returns:
    is_name = isinstance(hint, ast.Name) and hint.id == "bool"
    is_text = isinstance(hint, ast.Constant) and hint.value == "bool"
    return "boolean" if is_name or is_text else "any"


def _answers(function: ast.FunctionDef) -> bool:
    if function.returns is not None:
        hint = function.returns
        return not (isinstance(hint, ast.Constant) and hint.value in (None, "None"))
    return any(
        isinstance(node, ast.Return) and node.value is not None for node in _own_nodes(function)
    )


def _own_nodes(function: ast.FunctionDef) -> Iterator[ast.AST]:
    """The nodes of a function without those of functions inside it."""
    waiting: list[ast.AST] = [*function.body]
    while waiting:
        node = waiting.pop()
        if not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)):
            yield node
            waiting += ast.iter_child_nodes(node)
