"""Python files of skills, read without running them."""

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.errors import Diagnostic, ProgramError
from learnblock.i18n import Phrase
from learnblock.storage import installed
from learnblock.storage.home import home

if TYPE_CHECKING:
    import ast
    from importlib.metadata import EntryPoint

#: The limit in bytes, larger than any hand-written file of skills.
LARGEST = 1024 * 1024
#: The limit of statements outside of functions, which definitions are too.
MOST_STATEMENTS = 1000

_DEFINITION = re.compile(r"^def[ \t]+([^\W\d_]\w*)[ \t]*\([ \t]*[^\W\d*)]", re.MULTILINE)


def own_files() -> tuple[Path, ...]:
    """List the files in the ``skills`` folder of `home`, sorted by name."""
    return tuple(sorted(filter(Path.is_file, (home() / "skills").glob("*.py"))))


def plugins() -> "Iterable[EntryPoint]":
    """List the installed plugins: the entry points in the group ``learnblock.skills``."""
    return installed.entry_points("learnblock.skills")


def read(path: Path) -> str:
    """Read the text of a file of skills.

    Raises:
        ProgramError: the file is too large.
        OSError: it cannot be read.
    """
    with path.open("rb") as file:
        data = file.read(LARGEST + 1)
    if len(data) > LARGEST:
        message = Phrase("file-too-large", name=path.name, limit=LARGEST // 1024**2)
        raise ProgramError(str(path), [Diagnostic("too-large", message)])
    return data.decode("utf-8-sig", "replace")


def parse(source: str, filename: str) -> "ast.Module":
    """Parse a Python file.

    Raises:
        ProgramError: the file is not valid Python.
    """
    import ast  # noqa: PLC0415 - most programs have no custom skills

    with _reporting(source, filename):
        tree = ast.parse(source, filename)
    if len(tree.body) > MOST_STATEMENTS:
        message = Phrase("file-too-many-statements", count=len(tree.body), limit=MOST_STATEMENTS)
        raise ProgramError(filename, [Diagnostic("too-large", message)], source)
    return tree


def require_python(source: str, filename: str) -> None:
    """Compile a Python file without running it, to find what an import would refuse.

    Raises:
        ProgramError: the file is not valid Python.
    """
    with _reporting(source, filename):
        compile(source, filename, "exec", dont_inherit=True)


@contextmanager
def _reporting(source: str, filename: str) -> Iterator[None]:
    """Report Python's errors about a file as our own."""
    import warnings  # noqa: PLC0415 - most programs have no custom skills

    try:
        with warnings.catch_warnings():
            # These are shown when the file is run.
            warnings.simplefilter("ignore")
            yield
    except SyntaxError as error:
        place = (error.lineno or 0, error.offset or 0, error.end_offset or 0)
        raise ProgramError(filename, [_not_python(error.msg, *place)], source) from None
    except (ValueError, RecursionError, MemoryError) as error:
        raise ProgramError(filename, [_not_python(str(error))], source) from None


def functions(tree: "ast.Module") -> Iterator["ast.FunctionDef"]:
    """List the definitions of the skills: public functions with the robot as first parameter."""
    import ast  # noqa: PLC0415 - see `parse`

    for statement in tree.body:
        if (
            isinstance(statement, ast.FunctionDef)
            and not statement.name.startswith("_")
            and (statement.args.posonlyargs or statement.args.args)
        ):
            yield statement


def names(path: Path) -> tuple[str, ...]:
    """List the names of the skills in a file, even if it is not valid Python.

    Raises:
        OSError: it cannot be read.
    """
    status = path.stat()
    return _names(path, (status.st_mtime_ns, status.st_size))


def names_in(source: str) -> tuple[str, ...]:
    """Guess the names of the skills in a file that is not valid Python."""
    return tuple(dict.fromkeys(_DEFINITION.findall(source)))


def definition(path: Path, name: str) -> "ast.FunctionDef | None":
    """Return the definition of a skill in a file; None if the file is not valid Python.

    Raises:
        OSError: it cannot be read.
    """
    status = path.stat()
    return (_definitions(path, (status.st_mtime_ns, status.st_size)) or {}).get(name)


@lru_cache(maxsize=512)
def _names(path: Path, version: tuple[int, int]) -> tuple[str, ...]:
    definitions = _definitions(path, version)
    if definitions is not None:
        return tuple(definitions)
    try:
        return names_in(read(path))
    except ProgramError:
        return ()


@lru_cache(maxsize=512)
def _definitions(path: Path, version: tuple[int, int]) -> "dict[str, ast.FunctionDef] | None":  # noqa: ARG001 - read again after a change
    try:
        tree = parse(read(path), str(path))
    except ProgramError:
        return None
    return {function.name: function for function in functions(tree)}


def _not_python(reason: str, line: int = 0, column: int = 0, end_column: int = 0) -> Diagnostic:
    message = Phrase("file-not-python", reason=reason)
    return Diagnostic("syntax-error", message, line, column, max(end_column, 0))
