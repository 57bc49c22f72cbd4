"""Rename a variable, a function or a ``when`` everywhere in a program."""

import unicodedata
from collections.abc import Callable, Iterable, Iterator
from dataclasses import fields, replace
from typing import Any, Literal

from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.language.blocktext import names
from learnblock.language.blocktext.lexer import KEYWORDS
from learnblock.language.blocktext.names import state_of
from learnblock.language.edit.python_names import UnsupportedNameError, functions_with, renamed_in
from learnblock.language.edit.symbols import Symbols
from learnblock.language.tree.builtins import FUNCTIONS
from learnblock.language.tree.nodes import (
    Activate,
    AnyPython,
    Call,
    Deactivate,
    Def,
    Item,
    Main,
    Name,
    Program,
    PythonBlock,
    RawExpression,
    SkillCall,
    Span,
    When,
)
from learnblock.language.tree.traversal import statements

Sort = Literal["variable", "function", "when"]
LONGEST_NAME = 100

#: Returns a node with the new name, or unchanged.
Change = Callable[[Any], Any]


def rename(program: Program, sort: Sort, name: str, new: str) -> Program:
    """Rename a variable, a function or a ``when``.

    Args:
        program: the tree; the spans of the result are still those of the old names.
        sort: the kind of name.
        name: the old name; ``function.variable`` for a local variable of one function.
        new: the new name.

    Raises:
        UnknownNameError: the old name does not exist.
        LearnBlockError: the new name is taken or not valid.
    """
    new = unicodedata.normalize("NFKC", new.strip())
    if new == name.rpartition(".")[2]:
        return program
    symbols = Symbols(program)
    _check_name(new)
    rename_ = {"variable": _variable, "function": _function, "when": _when}[sort]
    return replace(rename_(symbols, name, new), python=None)


def rename_skill(program: Program, name: str, new: str) -> Program:
    """Rename the calls of a skill, to ``function.NEW(...)``."""

    def change(node: Any) -> Any:
        if isinstance(node, SkillCall) and node.name == name:
            return replace(node, name=new)
        return node

    return replace(_everywhere(program, change), python=None)


def _check_name(new: str) -> None:
    if not new.isidentifier() or len(new) > LONGEST_NAME:
        raise LearnBlockError("edit-bad-name", name=new[:LONGEST_NAME])
    if new in KEYWORDS:
        raise LearnBlockError("blocktext-reserved-word", word=new)


# Variables.


def _variable(symbols: Symbols, name: str, new: str) -> Program:
    scope, _, plain = name.rpartition(".")
    items = _scopes_of(symbols, scope, plain)
    _refuse_taken(symbols, new)
    is_called = plain not in symbols.functions
    change = _variable_change(plain, new, is_called=is_called)
    program = _mapped(symbols.program, items, change)
    for function in _functions_with(items, plain):
        program = _everywhere(program, _parameter_change(function, plain, new))
    return program


def _functions_with(items: tuple[Item, ...], parameter: str) -> Iterator[str]:
    """The functions that have a parameter of this name, also in Python."""
    for item in statements(items):
        if isinstance(item, Def) and parameter in item.parameters:
            yield item.name
        elif isinstance(item, AnyPython):
            yield from functions_with(item.text, names.to_python(parameter))


def _scopes_of(symbols: Symbols, scope: str, name: str) -> tuple[Item, ...]:
    """The items of the top level in which `name` means this variable."""
    owners = tuple(item for item in symbols.items if name in symbols.own(item))
    if scope:
        owners = tuple(item for item in owners if getattr(item, "name", "") == scope)
    elif name in symbols.variables or _is_set_in_python(symbols, name):
        return tuple(item for item in symbols.items if name not in symbols.own(item))
    if not owners:
        raise UnknownNameError("variable", name, symbols.variables)
    return owners


def _is_set_in_python(symbols: Symbols, name: str) -> bool:
    return names.to_python(name) in symbols.set_in_python


def _refuse_taken(symbols: Symbols, new: str) -> None:
    own = {name for item in symbols.items for name in symbols.own(item)}
    if new in symbols.variables or new in own or new in symbols.in_python:
        raise LearnBlockError("edit-variable-exists", name=new)
    if new in symbols.functions:
        raise LearnBlockError("edit-function-exists", name=new)
    if state := state_of(new, symbols.whens.keys()):
        raise LearnBlockError("edit-name-of-state", name=new, when=state[0])


def _variable_change(name: str, new: str, *, is_called: bool) -> Change:
    named = Name | Call if is_called else Name

    def change(node: Any) -> Any:
        if isinstance(node, named) and node.name == name:
            return replace(node, name=new)
        if isinstance(node, Def) and name in node.parameters:
            parameters = tuple(
                new if parameter == name else parameter for parameter in node.parameters
            )
            return replace(node, parameters=parameters)
        return _in_python(node, name, new)

    return change


def _parameter_change(function: str, name: str, new: str) -> Change:
    def change(node: Any) -> Any:
        if isinstance(node, Call) and node.name == function:
            keywords = tuple(
                replace(keyword, name=new) if keyword.name == name else keyword
                for keyword in node.keywords
            )
            return replace(node, keywords=keywords)
        return node

    return change


# Functions and `when`s.


def _function(symbols: Symbols, name: str, new: str) -> Program:
    if name not in symbols.functions and not _is_set_in_python(symbols, name):
        raise UnknownNameError("function", name, symbols.functions)
    if new in FUNCTIONS:
        raise LearnBlockError("edit-language-function", name=new)
    _refuse_taken(symbols, new)

    def change(node: Any) -> Any:
        if isinstance(node, Def | Call | Name) and node.name == name:
            return replace(node, name=new)
        return _in_python(node, name, new)

    return _everywhere(symbols.program, change)


def _when(symbols: Symbols, name: str, new: str) -> Program:
    if name not in symbols.whens:
        raise UnknownNameError("event", name, symbols.whens)
    if new in symbols.whens:
        raise LearnBlockError("edit-when-exists", name=new)
    if "start" in (name, new):
        raise LearnBlockError("edit-when-start")
    for state in (f"state_{new}", f"time_{new}"):
        if state in symbols.variables:
            raise LearnBlockError("edit-variable-exists", name=state)

    def change(node: Any) -> Any:
        if isinstance(node, When | Activate | Deactivate) and node.name == name:
            return replace(node, name=new)
        if isinstance(node, Name) and (state := state_of(node.name, {name})):
            return replace(node, name=node.name.removesuffix(state[0]) + new)
        return _in_python(node, name, new)

    return _everywhere(symbols.program, change)


# Raw Python.


def _in_python(node: Any, name: str, new: str) -> Any:
    if not isinstance(node, AnyPython | RawExpression):
        return node
    try:
        text = renamed_in(node.text, names.to_python(name), names.to_python(new))
    except UnsupportedNameError:
        if node.span.line:
            raise LearnBlockError(
                "edit-used-in-line", name=name, line=str(node.span.line)
            ) from None
        raise LearnBlockError("edit-used-in-python", name=name) from None
    if text == node.text:
        return node
    if isinstance(node, PythonBlock):
        return node.with_text(text)
    return replace(node, text=text)


# Trees.


def _everywhere(program: Program, change: Change) -> Program:
    symbols = Symbols(program)
    return _mapped(program, symbols.items, change)


def _mapped(program: Program, items: Iterable[Item], change: Change) -> Program:
    """Apply `change` to some items of the top level and of `main`."""
    chosen = {id(item) for item in items}

    def each(body: tuple[Item, ...]) -> tuple[Any, ...]:
        return tuple(_rewritten(item, change) if id(item) in chosen else item for item in body)

    main = program.main and Main(each(program.main.body), program.main.span)
    return replace(program, items=each(program.items), main=main)


def _rewritten(node: Any, change: Change) -> Any:
    """Apply `change` to all nodes inside a node, and then to itself."""
    changed = {}
    for field in fields(node):
        value = getattr(node, field.name)
        other = _rewritten_value(value, change)
        if other is not value:
            changed[field.name] = other
    return change(replace(node, **changed) if changed else node)


def _rewritten_value(value: Any, change: Change) -> Any:
    if isinstance(value, Span):
        return value
    if isinstance(value, tuple):
        mapped = tuple(_rewritten_value(item, change) for item in value)
        same = all(item is other for item, other in zip(mapped, value, strict=True))
        return value if same else mapped
    return _rewritten(value, change) if hasattr(value, "__dataclass_fields__") else value
