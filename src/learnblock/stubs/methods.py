"""The definition of a skill as a method in a stub file."""

import ast
import builtins
import importlib
import textwrap
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from inspect import Parameter

from learnblock.client.signatures import parameters_of
from learnblock.storage import skill_files

_WIDTH = 100
_INDENT = " " * 4
#: Characters; stub files leave out longer defaults.
_LONGEST_DEFAULT = 50
_STARS = {Parameter.VAR_POSITIONAL: "*", Parameter.VAR_KEYWORD: "**"}
#: After these, parameters can be given by name alone.
_BEFORE_KEYWORDS = (Parameter.VAR_POSITIONAL, Parameter.KEYWORD_ONLY)


@dataclass(frozen=True, slots=True)
class Method:
    """A skill as a method.

    Args:
        name: the name of the skill.
        text: its definition in a class of a stub file.
        imports: the lines that import the names in its hints.
    """

    name: str
    text: str
    imports: frozenset[str] = field(default_factory=frozenset)


def methods_of(source: str, filename: str) -> Iterator[Method]:
    """The skills in a Python file, which does not run.

    Raises:
        ProgramError: the source is not valid Python.
    """
    tree = skill_files.parse(source, filename)
    imports = dict(_imports(tree))
    constants = dict(_constants(tree))
    for definition in skill_files.functions(tree):
        yield _method(definition, imports, constants)


def _imports(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """The names that a file imports by their whole path, each with the line that imports it."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.level == 0:
            for name in node.names:
                yield name.asname or name.name, f"from {node.module} import {_alias(name)}"
        elif isinstance(node, ast.Import):
            for name in node.names:
                yield (name.asname or name.name).partition(".")[0], f"import {_alias(name)}"


def _alias(name: ast.alias) -> str:
    return name.name if name.asname in (None, name.name) else f"{name.name} as {name.asname}"


def _constants(tree: ast.Module) -> Iterator[tuple[str, ast.expr]]:
    """The values that defaults may name: those of the file, and those of LearnBlock."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            yield node.targets[0].id, node.value
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("learnblock."):
            module = importlib.import_module(node.module or "")
            for name in node.names:
                value = getattr(module, name.name, None)
                if isinstance(value, str | int | float):
                    yield name.asname or name.name, ast.Constant(value)


def _method(
    definition: ast.FunctionDef, imports: Mapping[str, str], constants: Mapping[str, ast.expr]
) -> Method:
    writer = _Writer(imports, constants)
    parameters = ["self", *writer.parameters(definition.args)]
    if definition.returns is not None:
        result = f" -> {writer.hint(definition.returns)}"
    else:
        result = "" if _answers(definition) else " -> None"
    lines = [*_head(definition.name, parameters, result), *_docstring(definition)]
    text = textwrap.indent("\n".join(lines), _INDENT)
    return Method(definition.name, text, frozenset(writer.needed))


def _answers(definition: ast.FunctionDef) -> bool:
    nodes = ast.walk(definition)
    return any(isinstance(node, ast.Return) and node.value is not None for node in nodes)


def _head(name: str, parameters: list[str], result: str) -> Iterator[str]:
    """The first line of a definition, or several, as formatters write them."""
    line = f"def {name}({', '.join(parameters)}){result}:"
    if len(_INDENT + line) <= _WIDTH:
        yield line
        return
    yield f"def {name}("
    inside = f"{_INDENT}{', '.join(parameters)}"
    if len(_INDENT + inside) <= _WIDTH:
        yield inside
    else:
        yield from (f"{_INDENT}{parameter}," for parameter in parameters)
    yield f"){result}:"


def _docstring(definition: ast.FunctionDef) -> Iterator[str]:
    text = ast.get_docstring(definition)
    if not text:
        yield f"{_INDENT}..."
        return
    quoted = text.replace("\\", "\\\\").replace('"""', '\\"\\"\\"')
    end = "\n" if "\n" in quoted else ""
    yield from textwrap.indent(f'"""{quoted}{end}"""', _INDENT).splitlines()


class _Writer:
    """Writes parameters and hints, and collects the imports that they need."""

    def __init__(self, imports: Mapping[str, str], constants: Mapping[str, ast.expr]) -> None:
        self._imports = imports
        self._constants = constants
        self.needed: set[str] = set()

    def parameters(self, arguments: ast.arguments) -> Iterator[str]:
        """All parameters except the robot."""
        before = None
        for index, (argument, kind, default) in enumerate(parameters_of(arguments)):
            if before is Parameter.POSITIONAL_ONLY is not kind:
                yield "/"
            if kind is Parameter.KEYWORD_ONLY and before not in _BEFORE_KEYWORDS:
                yield "*"
            if index or kind in _STARS:
                yield _STARS.get(kind, "") + self._parameter(argument, default)
            before = kind
        if before is Parameter.POSITIONAL_ONLY:
            yield "/"

    def hint(self, hint: ast.expr) -> str:
        """A hint without quotes, or `Any` if it has a name of the file's own."""
        if isinstance(hint, ast.Constant) and isinstance(hint.value, str):
            try:
                hint = ast.parse(hint.value, mode="eval").body
            except SyntaxError:
                return self._any()
        names = _names_in(hint)
        if any(name not in self._imports and not hasattr(builtins, name) for name in names):
            return self._any()
        self.needed |= {self._imports[name] for name in names if name in self._imports}
        return _double_quoted(ast.unparse(hint))

    def _any(self) -> str:
        self.needed.add("from typing import Any")
        return "Any"

    def _parameter(self, argument: ast.arg, default: ast.expr | None = None) -> str:
        hint = f": {self.hint(argument.annotation)}" if argument.annotation else ""
        if default is None:
            return argument.arg + hint
        equals = " = " if hint else "="
        return f"{argument.arg}{hint}{equals}{self._default(default)}"

    def _default(self, default: ast.expr) -> str:
        """A literal; ``...`` for a default that only its file knows."""
        if isinstance(default, ast.Name):
            default = self._constants.get(default.id, default)
        try:
            text = repr(ast.literal_eval(default))
        except (ValueError, TypeError, RecursionError, MemoryError):
            return "..."
        return _double_quoted(text) if len(text) <= _LONGEST_DEFAULT else "..."


def _names_in(hint: ast.expr) -> Iterable[str]:
    return [node.id for node in ast.walk(hint) if isinstance(node, ast.Name)]


def _double_quoted(source: str) -> str:
    """Source with the quotes that formatters choose."""
    return source if '"' in source else source.replace("'", '"')
