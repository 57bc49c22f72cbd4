"""Reads a TOML file that a person wrote into a Struct, and says precisely what is wrong in it.

Worlds, simulated robots and settings are such files. Whatever msgspec refuses is told again in the
words of the file: its key, its value, what is allowed there (taken from the Struct's own types and
descriptions) and the line where it stands.
"""

import re
import tomllib
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import tomli_w
from msgspec import inspect

from learnblock.errors import Diagnostic, FileError, UnknownNameError, did_you_mean

MAXIMUM_FILE_SIZE = 256 * 1024
"""Bytes; the largest world we ship has 3 % of it."""

KeyPath = tuple[str | int, ...]
"""Where a value stands: ``("wall", 2, "height")`` is the height of the third ``[[wall]]``."""

StructT = TypeVar("StructT", bound=msgspec.Struct)


@dataclass(frozen=True, slots=True)
class Finding:
    """Something wrong that types cannot say, such as two goals with one name."""

    path: KeyPath
    code: str
    message: str


def read(
    file: Path,
    struct: type[StructT],
    error: type[FileError],
    check: Callable[[StructT], Iterable[Finding]],
) -> StructT:
    """The file as a `struct`.

    Args:
        file: a TOML file in UTF-8 of at most `MAXIMUM_FILE_SIZE` bytes.
        struct: what the file must hold.
        error: what to raise, with the diagnostics and the file's text.
        check: finds what `struct`'s types let through.
    """
    source = _text(file, error)
    document = parse(source, file.name, error)
    return convert(document, struct, error, check, name=file.name, source=source)


def parse(source: str, name: str, error: type[FileError]) -> dict[str, Any]:
    """The values of a file's text by their keys.

    Args:
        source: TOML.
        name: of the file.
        error: what to raise, with the diagnostic and the text.
    """
    try:
        return tomllib.loads(source)
    except tomllib.TOMLDecodeError as broken:
        text, _, place = str(broken).partition(" (at line ")
        line, column = map(int, re.findall(r"\d+", place)) if place else (0, 0)
        diagnostic = Diagnostic("invalid-toml", f"this is not TOML: {text}", line, column)
        raise error(name, [diagnostic], source) from None
    except RecursionError:
        diagnostic = Diagnostic("invalid-toml", "brackets stand too deep inside brackets")
        raise error(name, [diagnostic], source) from None
    except ValueError as broken:
        # A number of more digits than Python converts, or a day that no month has.
        diagnostic = Diagnostic("invalid-toml", f"this is not TOML: {broken}")
        raise error(name, [diagnostic], source) from None


def convert(
    document: Mapping[str, Any],
    struct: type[StructT],
    error: type[FileError],
    check: Callable[[StructT], Iterable[Finding]],
    *,
    name: str,
    source: str = "",
) -> StructT:
    """The values of a file as a `struct`.

    Args:
        document: the values by their keys.
        struct: what they must be.
        error: what to raise, with the diagnostics and the text.
        check: finds what `struct`'s types let through.
        name: of the file.
        source: the file's text, in which the lines are counted.
    """
    try:
        described = msgspec.convert(document, struct)
    except msgspec.ValidationError as refusal:
        finding = _explain(str(refusal), document, inspect.type_info(struct))
        raise error(name, [_diagnostic(finding, source)], source) from None
    findings = [_diagnostic(finding, source) for finding in check(described)]
    if findings:
        raise error(name, sorted(findings, key=lambda d: (d.line, d.column)), source)
    return described


def write(struct: msgspec.Struct, name: str, error: type[FileError]) -> str:
    """The text of a file that `read` makes the same `struct` of, without what is as by default.

    Args:
        struct: what the file shall hold.
        name: of the file.
        error: what to raise when the text is larger than `read` accepts.
    """
    text = tomli_w.dumps(_document_of(struct))
    size = len(text.encode())
    if size > MAXIMUM_FILE_SIZE:
        message = f"the file would have {size} bytes; at most {MAXIMUM_FILE_SIZE} are read"
        raise error(name, [Diagnostic("too-large", message)])
    return text


def _document_of(value: Any) -> Any:
    if isinstance(value, tuple):
        return [_document_of(item) for item in value]
    if not isinstance(value, msgspec.Struct):
        return value
    fields = msgspec.structs.fields(value)
    values = ((field, getattr(value, field.name)) for field in fields)
    return {field.name: _document_of(given) for field, given in values if given != _default(field)}


def _default(field: msgspec.structs.FieldInfo) -> Any:
    made = field.default_factory
    return field.default if made is msgspec.NODEFAULT else made()


def locate(kind: str, name_or_path: str | Path, folders: Sequence[Path]) -> Path:
    """The file that is meant: by its path, or by its name in the first of `folders` that has it.

    Raises:
        UnknownNameError: no folder has it, or there is no file at the path.
    """
    known = names(folders)
    if str(name_or_path) in known:
        return known[str(name_or_path)]
    path = Path(name_or_path)
    if path.suffix == ".toml" and path.is_file():
        return path
    raise UnknownNameError(kind, str(name_or_path), known)


def names(folders: Sequence[Path]) -> dict[str, Path]:
    """Every TOML file of `folders` by its name without the ending; an earlier folder wins."""
    files = [file for folder in reversed(folders) for file in sorted(Path(folder).glob("*.toml"))]
    return dict(sorted((file.stem, file) for file in {file.stem: file for file in files}.values()))


def _text(file: Path, error: type[FileError]) -> str:
    size = file.stat().st_size
    if size > MAXIMUM_FILE_SIZE:
        message = f"the file has {size} bytes; at most {MAXIMUM_FILE_SIZE} are read"
        raise error(file.name, [Diagnostic("too-large", message)])
    try:
        return file.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as broken:
        message = f"byte {broken.start} is not UTF-8; save the file with the encoding UTF-8"
        raise error(file.name, [Diagnostic("not-utf-8", message)]) from None


_UNKNOWN = re.compile(r"Object contains unknown field `(.+?)`")
_MISSING = re.compile(r"Object missing required field `(.+?)`")
_PLACE = re.compile(r" - at `\$\.?(.*)`$")
_STEP = re.compile(r"\[(\d+)\]|([^.\[\]]+)")
_MSGSPEC = re.compile(r"Expected `|Invalid ")


def _explain(refusal: str, document: Mapping[str, Any], root: inspect.Type) -> Finding:
    """The message of msgspec told as a person who knows only the file would want it."""
    place = _PLACE.search(refusal)
    steps = _STEP.findall(place[1]) if place else []
    path: KeyPath = tuple(int(index) if index else key for index, key in steps)
    allowed = _type_at(root, path)
    if unknown := _UNKNOWN.match(refusal):
        return _unknown_key((*path, unknown[1]), allowed)
    if missing := _MISSING.match(refusal):
        return _missing_key((*path, missing[1]), allowed)
    if not _MSGSPEC.match(refusal):
        return Finding(path, "wrong-value", f"{_spell(path)}: {_PLACE.sub('', refusal)}")
    value = _value_at(document, path)
    message = f"{_spell(path)} is {_show(value)}: expected {describe(allowed)}"
    return Finding(path, "wrong-value", message + (_near(value, allowed) or _brackets(value, path)))


def _brackets(value: object, path: KeyPath) -> str:
    """The hint for ``[wall]`` where there may be many walls."""
    is_table_of_many = isinstance(value, dict) and len(path) == 1
    return f"; write its header as [[{path[0]}]]" if is_table_of_many else ""


def _unknown_key(path: KeyPath, owner: inspect.Type) -> Finding:
    known = [field.encode_name for field in _fields(owner)]
    key = str(path[-1])
    complaint = f"{_spell(path[:-1])} has a key `{key}`, which is not known"
    return Finding(path, "unknown-key", unknown(complaint, key, known))


def _missing_key(path: KeyPath, owner: inspect.Type) -> Finding:
    key = str(path[-1])
    field = next(field for field in _fields(owner) if field.encode_name == key)
    message = f"{_spell(path[:-1])} lacks the key `{key}`: expected {describe(field.type)}"
    return Finding(path[:-1], "missing-key", message)


def unknown(complaint: str, name: str, known: Iterable[str]) -> str:
    """The complaint with the nearest of the known names, or with all of them."""
    known = tuple(known)
    return f"{complaint}; {did_you_mean(name, known) or _list_of(known)}"


def _list_of(known: Sequence[str]) -> str:
    return "known are: " + ", ".join(known) if known else "there is none at all"


def _near(value: object, allowed: inspect.Type) -> str:
    known = list(map(str, choices(allowed)))
    hint = did_you_mean(value, known) if isinstance(value, str) else ""
    return f"; {hint}" if hint else ""


def describe(allowed: inspect.Type) -> str:  # noqa: PLR0911 - one line each kind of type
    """What a value of this type looks like, such as ``a number from 0 to 100 (width, mm)``."""
    match allowed:
        case inspect.Metadata(type=inner, extra_json_schema=extra):
            note = (extra or {}).get("description")
            return f"{describe(inner)} ({note})" if note else describe(inner)
        case inspect.UnionType(types=types):
            kinds = [kind for kind in types if not isinstance(kind, inspect.NoneType)]
            return " or ".join(describe(kind) for kind in kinds)
        case inspect.LiteralType(values=values):
            return ("one of " if len(values) > 1 else "") + ", ".join(map(str, values))
        case inspect.FloatType() | inspect.IntType():
            return _describe_number(allowed)
        case inspect.StrType():
            return _describe_text(allowed)
        case inspect.BoolType():
            return "true or false"
        case inspect.TupleType() | inspect.VarTupleType():
            return _describe_list(allowed)
        case _:
            return "a table of keys and values"


def _describe_number(allowed: inspect.FloatType | inspect.IntType) -> str:
    noun = "a number" if isinstance(allowed, inspect.FloatType) else "a whole number"
    return f"{noun} from {allowed.ge:g} to {allowed.le:g}"


def _describe_text(allowed: inspect.StrType) -> str:
    return f"a text of {allowed.min_length or 0} to {allowed.max_length} characters"


def _describe_list(allowed: inspect.TupleType | inspect.VarTupleType) -> str:
    if isinstance(allowed, inspect.TupleType):
        items = [describe(item) for item in allowed.item_types]
        alike = f"a list of {len(items)} entries, each {items[0]}"
        return alike if len(set(items)) == 1 else f"[{', '.join(items)}]"
    item = describe(allowed.item_type)
    return f"a list of {allowed.min_length or 0} to {allowed.max_length} entries, each {item}"


def bare(allowed: inspect.Type) -> inspect.Type:
    """A type without what is said of it."""
    return bare(allowed.type) if isinstance(allowed, inspect.Metadata) else allowed


def alternatives(allowed: inspect.Type) -> list[inspect.Type]:
    """The types of which a value may have one."""
    kind = bare(allowed)
    return list(map(bare, kind.types)) if isinstance(kind, inspect.UnionType) else [kind]


def _fields(allowed: inspect.Type) -> tuple[inspect.Field, ...]:
    for kind in alternatives(allowed):
        if isinstance(kind, inspect.StructType):
            return kind.fields
    return ()


def choices(allowed: inspect.Type) -> list[object]:
    """The values that are allowed by themselves."""
    kinds = alternatives(allowed)
    return [
        choice for kind in kinds if isinstance(kind, inspect.LiteralType) for choice in kind.values
    ]


def _type_at(root: inspect.Type, path: KeyPath) -> inspect.Type:
    """The type that stands at `path`, with its description; unions are entered by their list."""
    allowed = root
    for step in path:
        allowed = _entry(allowed, step)
    return allowed


def _entry(allowed: inspect.Type, step: str | int) -> inspect.Type:
    if isinstance(step, str):
        return next(field.type for field in _fields(allowed) if field.encode_name == step)
    for kind in alternatives(allowed):
        if isinstance(kind, inspect.TupleType):
            return kind.item_types[step]
        if isinstance(kind, inspect.VarTupleType):
            return kind.item_type
    return allowed


def _value_at(document: Any, path: KeyPath) -> object:
    value = document
    for step in path:
        value = value[step]
    return value


def _show(value: object) -> str:
    """The value as TOML writes it, cut where it is long."""
    match value:
        case bool():
            text = str(value).lower()
        case str():
            text = f'"{value}"'
        case dict():
            return "a table of keys and values"
        case list():
            text = "[" + ", ".join(_show(item) for item in value[:8]) + "]"
        case _:
            text = str(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _spell(path: KeyPath) -> str:
    """``wall[2].height``, counted from 1 as a reader of the file counts."""
    text = ""
    for step in path:
        text += f"[{step + 1}]" if isinstance(step, int) else f".{step}"
    return f"`{text.removeprefix('.')}`" if text else "the file"


_HEADER = re.compile(r"\s*\[\[?\s*([^\]]+?)\s*\]\]?\s*(#.*)?$")


def _diagnostic(finding: Finding, source: str) -> Diagnostic:
    line, column, end = _find(finding.path, source)
    return Diagnostic(finding.code, finding.message, line, column, end)


def _find(path: KeyPath, source: str) -> tuple[int, int, int]:
    """Line, column and end column of the key that `path` names, or of the header above it."""
    here: KeyPath = ()
    seen: dict[str, int] = {}
    best, best_depth = (0, 0, 0), 0
    for number, text in enumerate(source.splitlines(), start=1):
        header = _HEADER.match(text)
        if header:
            here = _header_path(header[1], seen, is_list=text.lstrip().startswith("[["))
        key = None if header else re.match(r"\s*([\w.-]+)\s*=", text)
        stop = header or key
        if stop is None:
            continue
        full = here if header else (*here, *stop[1].split("."))
        if best_depth == 0 and full[: len(path)] == path and path:
            return number, stop.start(1) + 1, stop.end(1) + 1
        if len(full) > best_depth and path[: len(full)] == full:
            best, best_depth = (number, stop.start(1) + 1, stop.end(1) + 1), len(full)
    return best


def _header_path(header: str, seen: dict[str, int], *, is_list: bool) -> KeyPath:
    """``[[track.part]]`` below the second ``[[track]]`` is ``("track", 1, "part", n)``."""
    path: KeyPath = ()
    parts = [part.strip() for part in header.split(".")]
    for depth, part in enumerate(parts):
        path = (*path, part)
        key = repr(path)
        if is_list and depth == len(parts) - 1:
            seen[key] = seen.get(key, -1) + 1
        if key in seen:
            path = (*path, seen[key])
    return path
