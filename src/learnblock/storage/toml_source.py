"""Reads a hand-written TOML file into a Struct, and reports each mistake with its line.

Worlds, simulated robots and settings are such files. Errors of msgspec are reported in the terms
of the file: the key, its value, the allowed values (from the Struct's own types and descriptions),
and the line.
"""

import re
import tomllib
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import tomli_w
from msgspec import inspect

from learnblock.errors import (
    Diagnostic,
    FileError,
    LearnBlockError,
    UnknownNameError,
    nearest,
)
from learnblock.i18n import Phrase, Value
from learnblock.storage.file_phrases import place, unknown_key
from learnblock.storage.learned_types import learned
from learnblock.storage.struct_types import (
    KeyPath,
    choices,
    describe,
    entry_types,
    known_keys,
    type_at,
    type_of_key,
)
from learnblock.storage.toml_lines import find_key
from learnblock.storage.toml_values import loads, written

#: The limit in bytes; the largest built-in world has 3 % of it.
MAXIMUM_FILE_SIZE = 256 * 1024
_LONGEST_VALUE = 60

StructT = TypeVar("StructT", bound=msgspec.Struct)


@dataclass(frozen=True, slots=True)
class FileMistake:
    """A mistake that types can't express, such as two goals with the same name."""

    path: KeyPath
    code: str
    message: Phrase


def read(
    file: Path,
    struct: type[StructT],
    error: type[FileError],
    check: Callable[[StructT], Iterable[FileMistake]],
) -> StructT:
    """Read a file as a `struct`.

    Args:
        file: a TOML file in UTF-8 of at most `MAXIMUM_FILE_SIZE` bytes.
        struct: the type of the file's values.
        error: what to raise, with the diagnostics and the file's text.
        check: finds mistakes that the types of `struct` accept.
    """
    return read_text(text_of(file, error), file.name, struct, error, check)


def text_of(file: Path, error: type[FileError]) -> str:
    """The text of a file; see `read`."""
    size = file.stat().st_size
    if size > MAXIMUM_FILE_SIZE:
        message = Phrase("file-too-many-bytes", size=size, limit=MAXIMUM_FILE_SIZE)
        raise error(file.name, [Diagnostic("too-large", message)])
    try:
        return file.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as broken:
        message = Phrase("file-not-utf-8", position=str(broken.start))
        raise error(file.name, [Diagnostic("not-utf-8", message)]) from None


def read_text(
    source: str,
    name: str,
    struct: type[StructT],
    error: type[FileError],
    check: Callable[[StructT], Iterable[FileMistake]],
) -> StructT:
    """Read a file's text as a `struct`; see `read`."""
    return convert(parse(source, name, error), struct, error, check, name=name, source=source)


def parse(source: str, name: str, error: type[FileError]) -> dict[str, Any]:
    """Read a file's text into values by key.

    Args:
        source: TOML.
        name: the name of the file.
        error: what to raise, with the diagnostic and the text.
    """
    try:
        return loads(source)
    except tomllib.TOMLDecodeError as broken:
        reason, _, at = str(broken).partition(" (at line ")
        line, column = map(int, re.findall(r"\d+", at)) if at else (0, 0)
        message = Phrase("toml-broken", reason=reason)
    except RecursionError:
        line, column, message = 0, 0, Phrase("toml-too-deep")
    except ValueError as broken:
        # A number with more digits than Python converts, or a day that its month doesn't have.
        line, column, message = 0, 0, Phrase("toml-broken", reason=str(broken))
    raise error(name, [Diagnostic("invalid-toml", message, line, column)], source)


def convert(
    document: Mapping[str, Any],
    struct: type[StructT],
    error: type[FileError],
    check: Callable[[StructT], Iterable[FileMistake]],
    *,
    name: str,
    source: str = "",
) -> StructT:
    """Convert a file's values to a `struct`.

    Args:
        document: the values by key.
        struct: the type to convert them to.
        error: what to raise, with the diagnostics and the text.
        check: finds mistakes that the types of `struct` accept.
        name: the name of the file.
        source: the file's text, for the lines of mistakes.
    """
    described, mistakes = examine(document, struct, check)
    if described is None or mistakes:
        diagnostics = [_diagnostic(finding, source) for finding in mistakes]
        raise error(name, sorted(diagnostics, key=lambda d: (d.line, d.column)), source)
    return described


def examine(
    document: Mapping[str, Any],
    struct: type[StructT],
    check: Callable[[StructT], Iterable[FileMistake]],
) -> tuple[StructT | None, list[FileMistake]]:
    """Convert values to a `struct`; return it, None if its types refuse them, and the mistakes.

    Args:
        document: the values by key.
        struct: the type to convert them to.
        check: finds mistakes that the types of `struct` accept.
    """
    try:
        described = msgspec.convert(document, learned(struct))
    except msgspec.ValidationError as refusal:
        return None, [_explain(refusal, document, inspect.type_info(struct))]
    return described, list(check(described))


def write(struct: msgspec.Struct, name: str, error: type[FileError]) -> str:
    """Format a `struct` as the text of a file, as accepted by `read`; defaults are left out.

    Args:
        struct: the file's values.
        name: the name of the file.
        error: what to raise when the text is larger than `read` accepts.
    """
    text = tomli_w.dumps(_document_of(struct))
    size = len(text.encode())
    if size > MAXIMUM_FILE_SIZE:
        message = Phrase("file-too-many-bytes", size=size, limit=MAXIMUM_FILE_SIZE)
        raise error(name, [Diagnostic("too-large", message)])
    return text


def _document_of(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_document_of(item) for item in value]
    if not isinstance(value, msgspec.Struct):
        return value
    fields = msgspec.structs.fields(value)
    values = ((field, getattr(value, field.name)) for field in fields)
    return {field.name: _document_of(value) for field, value in values if value != _default(field)}


def _default(field: msgspec.structs.FieldInfo) -> Any:
    factory = field.default_factory
    return field.default if factory is msgspec.NODEFAULT else factory()


def locate(kind: str, name_or_path: str | Path, folders: Sequence[Path]) -> Path:
    """Find a file by its path, or by its name in the first of `folders` that has it.

    Raises:
        UnknownNameError: no folder has it, or there is no file at the path.
    """
    path = Path(name_or_path)
    if path.name == str(name_or_path):
        for folder in folders:
            if _is_file(file := Path(folder) / f"{path.name}.toml"):
                return file
    if path.suffix == ".toml" and _is_file(path):
        return path
    raise UnknownNameError(kind, str(name_or_path), names(folders))


def _is_file(path: Path) -> bool:
    # No file has a name that is too long for the system.
    with suppress(OSError):
        return path.is_file()
    return False


def names(folders: Sequence[Path]) -> dict[str, Path]:
    """List the TOML files of `folders` by name without suffix; earlier folders take precedence."""
    files = [file for folder in reversed(folders) for file in sorted(Path(folder).glob("*.toml"))]
    return dict(sorted((file.stem, file) for file in {file.stem: file for file in files}.values()))


_UNKNOWN = re.compile(r"Object contains unknown field `(.+?)`")
_MISSING = re.compile(r"Object missing required field `(.+?)`")
_PLACE = re.compile(r" - at (`key` in )?`\$\.?(.*)`$")
#: An entry of a table that can have any keys: msgspec does not say which.
_ENTRY = "[...]"
_STEP = re.compile(r"\[(\d+)\]|([^.\[\]]+)")
_MSGSPEC = re.compile(r"Expected `|Invalid ")


def _explain(
    refusal: msgspec.ValidationError, document: Mapping[str, Any], root: inspect.Type
) -> FileMistake:
    """Explain an error of msgspec to a person who knows only the file."""
    text = str(refusal)
    place = _PLACE.search(text)
    leading, entry, _ = place[2].partition(_ENTRY) if place else ("", "", "")
    steps = _STEP.findall(leading)
    path: KeyPath = tuple(int(index) if index else key for index, key in steps)
    allowed = type_at(root, path, document)
    if place and (place[1] or entry):
        return _wrong_entry(path, allowed, is_key=bool(place[1]))
    if unknown := _UNKNOWN.match(text):
        return _unknown_key((*path, unknown[1]), allowed)
    if missing := _MISSING.match(text):
        return _missing_key((*path, missing[1]), allowed)
    if not _MSGSPEC.match(text):
        return _refused(path, refusal.__cause__, _PLACE.sub("", text))
    return FileMistake(path, "wrong-value", _wrong_value(path, _value_at(document, path), allowed))


def _wrong_entry(path: KeyPath, allowed: inspect.Type, *, is_key: bool) -> FileMistake:
    keys, values = entry_types(allowed)
    code, kind = ("toml-wrong-key", keys) if is_key else ("toml-wrong-entry", values)
    return FileMistake(
        path, "wrong-value", Phrase(code, place=_place(path), allowed=describe(kind))
    )


def _refused(path: KeyPath, cause: BaseException | None, text: str) -> FileMistake:
    """Return an error raised by the Struct itself; the text of a plain ValueError may be a code."""
    reason = cause.phrase if isinstance(cause, LearnBlockError) else Phrase(text)
    return FileMistake(
        path, "wrong-value", Phrase("file-wrong-value", place=_place(path), reason=reason)
    )


def _unknown_key(path: KeyPath, owner: inspect.Type) -> FileMistake:
    message = unknown_key(str(path[-1]), _spelled(path[:-1]), known_keys(owner))
    return FileMistake(path, "unknown-key", message)


def _missing_key(path: KeyPath, owner: inspect.Type) -> FileMistake:
    key = str(path[-1])
    place, allowed = _place(path[:-1]), describe(type_of_key(owner, key))
    message = Phrase("toml-missing-value", key=key, place=place, allowed=allowed)
    return FileMistake(path[:-1], "missing-key", message)


def _wrong_value(path: KeyPath, value: object, allowed: inspect.Type) -> Phrase:
    if isinstance(value, dict) and len(path) == 1:
        # The header [wall], although there may be many walls.
        return Phrase("toml-single-table", name=str(path[0]))
    values: dict[str, Value] = {
        "place": _place(path),
        "value": _show(value),
        "allowed": describe(allowed),
    }
    options = list(map(str, choices(allowed)))
    suggestion = nearest(value, options) if isinstance(value, str) else None
    if suggestion is None:
        return Phrase("toml-wrong-value", **values)
    return Phrase("toml-wrong-value-like", suggestion=suggestion, **values)


def _value_at(document: Any, path: KeyPath) -> object:
    value = document
    for step in path:
        value = value[step]
    return value


def _show(value: object) -> str | Phrase:
    """The value as TOML writes it, shortened if it is long."""
    if isinstance(value, dict):
        return Phrase("toml-table")
    text = written(value)
    return text if len(text) <= _LONGEST_VALUE else text[: _LONGEST_VALUE - 3] + "..."


def _place(path: KeyPath) -> Phrase:
    return place(_spelled(path))


def _spelled(path: KeyPath) -> str:
    """``wall[2].height``, counted from 1 as a reader of the file counts."""
    text = ""
    for step in path:
        text += f"[{step + 1}]" if isinstance(step, int) else f".{step}"
    return text.removeprefix(".")


def _diagnostic(finding: FileMistake, source: str) -> Diagnostic:
    line, column, end = find_key(finding.path, source)
    return Diagnostic(finding.code, finding.message, line, column, end)
