"""Find imports of missing modules and names, without importing anything."""

import ast
import importlib.util
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from learnblock.errors import Diagnostic, LearnBlockError, nearest
from learnblock.i18n import Phrase
from learnblock.storage import skill_files
from learnblock.storage.home import home

_OURS = "learnblock"
_LIBRARIES = "learnblock.libraries"
_PACKAGE = Path(__file__).parents[2]


def wrong_imports(tree: ast.Module) -> Iterator[Diagnostic]:
    """Report the imports of a file that cannot work, except those in a ``try``."""
    expected = {
        id(inner)
        for node in ast.walk(tree)
        if isinstance(node, ast.Try) and node.handlers
        for statement in node.body
        for inner in ast.walk(statement)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Import | ast.ImportFrom) and id(node) not in expected:
            for message in _wrong(node):
                column = node.col_offset + 1
                yield Diagnostic("unknown-import", message, node.lineno, column)


def _wrong(node: ast.Import | ast.ImportFrom) -> Iterator[Phrase]:
    if isinstance(node, ast.Import):
        for alias in node.names:
            yield from _wrong_module(alias.name)
    elif node.level:
        yield Phrase("custom-import-relative")
    else:
        module = node.module or ""
        wrong = [*_wrong_module(module)]
        yield from wrong
        if not wrong and module.partition(".")[0] == _OURS:
            for alias in node.names:
                yield from _wrong_name(module, alias.name)


def _wrong_module(module: str) -> Iterator[Phrase]:
    top, _, _ = module.partition(".")
    if top == _OURS:
        yield from _wrong_module_of_ours(module)
    elif not _is_installed(top):
        yield Phrase("custom-import-package", module=module, package=top)


@lru_cache(maxsize=256)
def _is_installed(package: str) -> bool:
    try:
        return importlib.util.find_spec(package) is not None
    except (ImportError, ValueError):
        return False


def _wrong_module_of_ours(module: str) -> Iterator[Phrase]:
    if module.startswith(f"{_LIBRARIES}."):
        name = module.split(".")[2]
        if not (home() / "libraries" / name / "library.toml").is_file():
            yield Phrase("custom-import-library", module=module, library=name)
    elif _file_of_ours(module) is None:
        parent, _, name = module.rpartition(".")
        near = nearest(name, _modules(parent))
        if near is None:
            yield Phrase("custom-import-module", module=module)
        else:
            yield Phrase("custom-import-module-like", module=module, suggestion=near)


def _wrong_name(module: str, name: str) -> Iterator[Phrase]:
    file = None if module.startswith(f"{_LIBRARIES}.") else _file_of_ours(module)
    if file is None or name == "*" or _file_of_ours(f"{module}.{name}"):
        return
    names = _names(file)
    if name not in names:
        public = [name for name in names if not name.startswith("_")]
        near = nearest(name, public)
        if near is None:
            yield Phrase("custom-import-name", module=module, name=name)
        else:
            yield Phrase("custom-import-name-like", module=module, name=name, suggestion=near)


def _file_of_ours(module: str) -> Path | None:
    path = _PACKAGE.joinpath(*module.split(".")[1:])
    for file in (path.with_name(f"{path.name}.py"), path / "__init__.py"):
        if file.is_file():
            return file
    return None


def _modules(package: str) -> list[str]:
    folder = _PACKAGE.joinpath(*package.split(".")[1:])
    return [path.stem for path in folder.glob("*") if path.suffix == ".py" or path.is_dir()]


@lru_cache(maxsize=64)
def _names(file: Path) -> frozenset[str]:
    """The names that one of our modules defines or imports."""
    try:
        tree = skill_files.parse(skill_files.read(file), str(file))
    except (LearnBlockError, OSError):
        return frozenset()
    return frozenset(name for node in ast.walk(tree) for name in _defined(node))


def _defined(node: ast.AST) -> Iterator[str]:
    match node:
        case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
            yield name
        case ast.Name(id=name, ctx=ast.Store()):
            yield name
        case ast.ImportFrom(module=str(module), names=[ast.alias(name="*")]):
            file = _file_of_ours(module)
            yield from _names(file) if file else ()
        case ast.Import(names=names) | ast.ImportFrom(names=names):
            yield from (alias.asname or alias.name.partition(".")[0] for alias in names)
