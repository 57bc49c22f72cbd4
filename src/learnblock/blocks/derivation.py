"""Block configurations of skills that have none, read from their source without running it."""

import ast
import importlib.util
import re
from collections.abc import Iterator
from importlib.machinery import ModuleSpec
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.blocks.configuration import BlockConfiguration, Parameter, ParameterType
from learnblock.errors import Diagnostic, LearnBlockError, ProgramError
from learnblock.home import home

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

_TYPES: dict[str, ParameterType] = {
    "float": "float",
    "int": "int",
    "str": "string",
    "bool": "boolean",
    "list": "list",
    # Tags go by their number or by their name, and nothing else goes by both.
    "int | str": "apriltext",
    "str | int": "apriltext",
}


def derive(source: str, filename: str) -> tuple[BlockConfiguration, ...]:
    """The blocks for the skills in a Python file: its public functions that take the robot first.

    Types come from the hints (or else from the defaults), the label from the function's name, the
    tooltip from the first paragraph of its docstring, the tab from the file's name. A function that
    returns something is a value, any other a statement.

        >>> source = 'def waltz(robot, times: int = 3) -> None: "Dance a waltz."'
        >>> (block,) = derive(source, "ball_room.py")
        >>> block.category, block.name, block.tooltip
        ('Ball room', 'waltz', {'EN': 'Dance a waltz.'})

    Raises:
        ProgramError: the source is no Python.
    """
    category = Path(filename).stem.replace("_", " ").capitalize()
    blocks = (_block(function, category) for function in skills_in(source, filename))
    return tuple({block.name: block for block in blocks}.values())


def derive_users() -> Iterator[BlockConfiguration]:
    """The blocks of the files in the ``skills`` folder of `home`.

    Raises:
        ProgramError: one of them is no Python.
    """
    for path in sorted((home() / "skills").glob("*.py")):
        yield from derive(_text(path), str(path))


def derive_plugins() -> Iterator[BlockConfiguration]:
    """The blocks of installed plugins: modules named by entry points ``learnblock.skills``.

    Raises:
        LearnBlockError: a plugin's module cannot be found.
        ProgramError: it is no Python.
    """
    from importlib.metadata import entry_points  # noqa: PLC0415 - it searches all that is installed

    for point in entry_points(group="learnblock.skills"):
        path = _source_of(point)
        yield from derive(_text(path), str(path))


def skills_in(source: str, filename: str) -> Iterator[ast.FunctionDef]:
    """The definitions of the skills in a Python file.

    Raises:
        ProgramError: the source is no Python.
    """
    for statement in _parse(source, filename).body:
        if (
            isinstance(statement, ast.FunctionDef)
            and not statement.name.startswith("_")
            and (statement.args.posonlyargs or statement.args.args)
        ):
            yield statement


def _parse(source: str, filename: str) -> ast.Module:
    try:
        return ast.parse(source, filename)
    except SyntaxError as error:
        diagnostic = Diagnostic(
            "syntax-error", f"{error.msg}", error.lineno or 0, error.offset or 0
        )
        raise ProgramError(filename, [diagnostic], source) from None
    except (ValueError, RecursionError, MemoryError) as error:
        diagnostic = Diagnostic("syntax-error", f"this cannot be read as Python: {error}")
        raise ProgramError(filename, [diagnostic], source) from None


def _text(path: Path) -> str:
    return path.read_text("utf-8-sig", errors="replace")


def _source_of(point: "EntryPoint") -> Path:
    """The file of a plugin's module, found without importing the packages it lies in."""
    package, *rest = point.module.split(".")
    spec = importlib.util.find_spec(package)
    candidates = [] if spec is None else list(_candidates(spec, rest))
    for path in candidates:
        if path.suffix == ".py" and path.is_file():
            return path
    raise LearnBlockError(
        f"the plugin `{point.name}` names the module {point.module}, which is not installed as"
        " Python source; reinstall the plugin"
    )


def _candidates(package: ModuleSpec, inside: list[str]) -> Iterator[Path]:
    """Where the module of that name inside a package may lie; the package itself for no name."""
    if not inside:
        yield Path(package.origin or "")
        return
    for location in package.submodule_search_locations or ():
        path = Path(location, *inside)
        yield path.with_suffix(".py")
        yield path / "__init__.py"


def _block(function: ast.FunctionDef, category: str) -> BlockConfiguration:
    label = _words(function.name)
    # The first paragraph of a docstring says what the skill does.
    tooltip = " ".join((ast.get_docstring(function) or label).partition("\n\n")[0].split())
    return BlockConfiguration(
        type="others",
        category=category,
        name=function.name,
        parameters=tuple(_parameters(function.args)),
        shapes=("blockLeft", "blockBoth") if _returns_value(function) else ("blockVertical",),
        languages={"EN": label},
        tooltip={"EN": tooltip},
    )


def _parameters(arguments: ast.arguments) -> Iterator[Parameter]:
    positional = [*arguments.posonlyargs, *arguments.args]
    required = len(positional) - len(arguments.defaults)
    # The first parameter is the robot.
    for i, argument in enumerate(positional[1:], start=1):
        default = _constant(arguments.defaults[i - required]) if i >= required else None
        yield Parameter(
            name=argument.arg,
            type=_type(argument.annotation, default),
            default=default,
            required=i < required,
            translations={"EN": _words(argument.arg)},
        )


def _constant(expression: ast.expr) -> object:
    """The value of a default, or None for one that only running the file would tell."""
    try:
        value: object = ast.literal_eval(expression)
    except (ValueError, TypeError):
        return None
    return value if isinstance(value, (bool, int, float, str, list)) else None


def _type(hint: ast.expr | None, default: object) -> ParameterType:
    written = "" if hint is None else ast.unparse(hint).strip("'\"").removesuffix(" | None")
    by_hint = _TYPES.get(written) or _TYPES.get(written.partition("[")[0])
    return by_hint or _TYPES.get(type(default).__name__, "float")


def _returns_value(function: ast.FunctionDef) -> bool:
    if function.returns is not None:
        return ast.unparse(function.returns) != "None"
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


def _words(name: str) -> str:
    """``followTheLight`` and ``follow_the_light`` as words that a block shows."""
    separate = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name)
    words = [word if word.isupper() else word.lower() for word in separate.split("_") if word]
    return " ".join(words)
