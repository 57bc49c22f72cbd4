"""Explanations of errors with the names and values of the program that raised them."""

import ast
import inspect
from collections.abc import Callable, Mapping
from types import FunctionType

from learnblock.i18n import Phrase
from learnblock.runtime.failed_code import FailedCode

#: Shown in a message in place of a list without a name.
_ANY = "..."
_WITH_VARIABLE = {
    "run-means-nothing": "run-means-nothing-in-variable",
    "run-means-attribute-of-nothing": "run-means-attribute-of-nothing-in-variable",
}


def in_own_words(meaning: Phrase, failed: FailedCode) -> Phrase:
    """An explanation, with the correction that the failed code suggests."""
    rewrite = _REWRITERS.get(meaning.code)
    return meaning if rewrite is None else rewrite(meaning, failed)


def _division(meaning: Phrase, failed: FailedCode) -> Phrase:
    return Phrase(meaning.code, operator=failed.division)


def _nothing(meaning: Phrase, failed: FailedCode) -> Phrase:
    variable = failed.nothing
    if variable is None:
        return meaning
    return Phrase(_WITH_VARIABLE[meaning.code], variable=variable, **meaning.values)


def _local(meaning: Phrase, failed: FailedCode) -> Phrase:
    if meaning.values["name"] not in failed.shared:
        return meaning
    return Phrase("run-means-global", function=failed.inside, **meaning.values)


def _argument(meaning: Phrase, failed: FailedCode) -> Phrase:
    """The message about an unknown argument, with those that the program's function has."""
    function = failed.value(failed.function)
    if not isinstance(function, FunctionType):
        return meaning
    known = tuple(f"'{name}'" for name in inspect.signature(function).parameters)
    if not known:
        return Phrase("run-means-no-arguments", **meaning.values)
    return Phrase("run-means-unknown-argument-of", known=known, **meaning.values)


def _domain(meaning: Phrase, failed: FailedCode) -> Phrase:
    if failed.function in {"sqrt", "isqrt"}:
        return Phrase("run-means-root")
    return Phrase("run-means-logarithm") if failed.function.startswith("log") else meaning


def _empty(meaning: Phrase, failed: FailedCode) -> Phrase:
    return Phrase(meaning.code, list=_list_of(failed), **meaning.values)


def _list_of(failed: FailedCode) -> str:
    """The name of the list that a failed call uses; an ellipsis if it has none."""
    match failed.node:
        case ast.Call(func=ast.Attribute(value=ast.Name(id=name), attr="pop")):
            return name
        case ast.Call(args=[ast.Name(id=name), *_]):
            return name
    return _ANY


def _search(meaning: Phrase, failed: FailedCode) -> Phrase:
    """The message about a value that is not in a list, with both."""
    match failed.node:
        case ast.Call(func=ast.Attribute(value=searched), args=[wanted, *_]):
            values, value = failed.quote(searched), failed.quote(wanted)
            if values and value:
                return Phrase("run-means-not-in-this-list", list=values, value=value)
    return meaning


_REWRITERS: Mapping[str, Callable[[Phrase, FailedCode], Phrase]] = {
    "run-means-zero-division": _division,
    "run-means-nothing": _nothing,
    "run-means-attribute-of-nothing": _nothing,
    "run-means-local": _local,
    "run-means-unknown-argument": _argument,
    "run-means-domain": _domain,
    "run-means-empty": _empty,
    "run-means-empty-without": _empty,
    "run-means-two-items": _empty,
    "run-means-not-in-list": _search,
}
