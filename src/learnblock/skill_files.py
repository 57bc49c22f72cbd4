"""Python files of skills, read without running them: whatever stands in one does nothing yet."""

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.errors import Diagnostic, ProgramError
from learnblock.home import home

if TYPE_CHECKING:
    import ast
    from importlib.metadata import EntryPoint

#: Bytes; longer files are no skills that a person wrote.
LARGEST = 1024 * 1024

_DEFINITION = re.compile(r"^def[ \t]+([^\W\d_]\w*)[ \t]*\([ \t]*[^\W\d*)]", re.MULTILINE)


def own_files() -> tuple[Path, ...]:
    """The files in the ``skills`` folder of `home`, in the order of their names."""
    return tuple(sorted(filter(Path.is_file, (home() / "skills").glob("*.py"))))


def plugins() -> "Iterable[EntryPoint]":
    """The installed plugins: each names a module by an entry point ``learnblock.skills``."""
    from importlib.metadata import entry_points  # noqa: PLC0415 - it searches all that is installed

    return entry_points(group="learnblock.skills")


def read(path: Path) -> str:
    """The text of a file of skills.

    Raises:
        ProgramError: it is longer than any that a person wrote.
        OSError: it cannot be read.
    """
    with path.open("rb") as file:
        data = file.read(LARGEST + 1)
    if len(data) > LARGEST:
        message = f"the file is larger than {LARGEST:,} bytes: no skills are read from it"
        raise ProgramError(str(path), [Diagnostic("too-large", message)])
    return data.decode("utf-8-sig", "replace")


def parse(source: str, filename: str) -> "ast.Module":
    """The tree of a Python file.

    Raises:
        ProgramError: it is no Python.
    """
    import ast  # noqa: PLC0415 - most programs have no skills of their own

    with _told(source, filename):
        return ast.parse(source, filename)


def require_python(source: str, filename: str) -> None:
    """Refuse also what Python would refuse when it is imported; it is translated, and not run.

    Raises:
        ProgramError: it is no Python.
    """
    with _told(source, filename):
        compile(source, filename, "exec", dont_inherit=True)


@contextmanager
def _told(source: str, filename: str) -> Iterator[None]:
    """What Python says of a file, in our words."""
    import warnings  # noqa: PLC0415 - most programs have no skills of their own

    try:
        with warnings.catch_warnings():
            # Who wrote the file hears of these when it is run.
            warnings.simplefilter("ignore")
            yield
    except SyntaxError as error:
        place = (error.lineno or 0, error.offset or 0, error.end_offset or 0)
        raise ProgramError(filename, [_no_python(error.msg, *place)], source) from None
    except (ValueError, RecursionError, MemoryError) as error:
        raise ProgramError(filename, [_no_python(str(error))], source) from None


def functions(tree: "ast.Module") -> Iterator["ast.FunctionDef"]:
    """The definitions of the skills: public functions that take the robot first."""
    import ast  # noqa: PLC0415 - see `parse`

    for statement in tree.body:
        if (
            isinstance(statement, ast.FunctionDef)
            and not statement.name.startswith("_")
            and (statement.args.posonlyargs or statement.args.args)
        ):
            yield statement


def names(path: Path) -> tuple[str, ...]:
    """The names of the skills in a file, also of one that is no Python as it is.

    Raises:
        OSError: it cannot be read.
    """
    found = path.stat()
    return _names(path, (found.st_mtime_ns, found.st_size))


def names_in(source: str) -> tuple[str, ...]:
    """What seem to be the names of the skills in a text that is no Python."""
    return tuple(dict.fromkeys(_DEFINITION.findall(source)))


@lru_cache(maxsize=512)
def _names(path: Path, version: tuple[int, int]) -> tuple[str, ...]:  # noqa: ARG001 - reads anew when changed
    try:
        source = read(path)
    except ProgramError:
        return ()
    try:
        tree = parse(source, str(path))
    except ProgramError:
        return names_in(source)
    return tuple(dict.fromkeys(function.name for function in functions(tree)))


def _no_python(reason: str, line: int = 0, column: int = 0, end_column: int = 0) -> Diagnostic:
    message = f"this is no Python: {reason}"
    return Diagnostic("syntax-error", message, line, column, max(end_column, 0))
