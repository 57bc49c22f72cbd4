"""The signature of a function whose file has not run, for editors and `help`."""

import ast
from collections.abc import Callable, Iterator
from inspect import Parameter, Signature
from typing import Any, NamedTuple


class WrittenParameter(NamedTuple):
    """A parameter in the source.

    Args:
        argument: its name and its hint.
        kind: as in `inspect.Parameter`.
        default: its default; None without one.
    """

    argument: ast.arg
    kind: Any
    default: ast.expr | None = None


def parameters_of(arguments: ast.arguments) -> Iterator[WrittenParameter]:
    """The parameters of a definition, in their order."""
    positional = [*arguments.posonlyargs, *arguments.args]
    defaults = [None] * (len(positional) - len(arguments.defaults)) + arguments.defaults
    for index, (argument, default) in enumerate(zip(positional, defaults, strict=True)):
        is_only = index < len(arguments.posonlyargs)
        kind = Parameter.POSITIONAL_ONLY if is_only else Parameter.POSITIONAL_OR_KEYWORD
        yield WrittenParameter(argument, kind, default)
    if arguments.vararg:
        yield WrittenParameter(arguments.vararg, Parameter.VAR_POSITIONAL)
    for argument, default in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True):
        yield WrittenParameter(argument, Parameter.KEYWORD_ONLY, default)
    if arguments.kwarg:
        yield WrittenParameter(arguments.kwarg, Parameter.VAR_KEYWORD)


class _Written:
    """A default or a hint as its source says it."""

    def __init__(self, source: str) -> None:
        self._source = source

    def __repr__(self) -> str:
        return self._source


def describe(function: Callable[..., Any], definition: ast.FunctionDef) -> None:
    """Give a function the signature and the docstring of a definition."""
    function.__doc__ = ast.get_docstring(definition)
    function.__signature__ = _signature(definition)  # type: ignore[attr-defined]


def _signature(definition: ast.FunctionDef) -> Signature:
    return Signature(
        [*map(_parameter, parameters_of(definition.args))],
        return_annotation=_hint(definition.returns),
        __validate_parameters__=False,
    )


def _parameter(parameter: WrittenParameter) -> Parameter:
    argument, kind, default = parameter
    value = Parameter.empty if default is None else _Written(ast.unparse(default))
    return Parameter(argument.arg, kind, default=value, annotation=_hint(argument.annotation))


def _hint(hint: ast.expr | None) -> Any:
    return Parameter.empty if hint is None else _Written(ast.unparse(hint))
