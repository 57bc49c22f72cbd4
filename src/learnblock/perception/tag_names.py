"""The dictionary of tags: the user's names for AprilTags, in ``tags.toml`` of `home`.

Each line names one tag:

    ball = 3
    "red door" = 12
"""

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path

from greenlet import getcurrent, greenlet

from learnblock.errors import Diagnostic, TagNamesError, TagNumberError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.storage.files import save
from learnblock.storage.home import home

#: The highest number of an AprilTag of family 36h11, which has 587 tags.
LAST_TAG = 586
MOST_NAMES = 2000
LONGEST_NAME = 100
#: The maximum size of a dictionary, in bytes.
LARGEST = 256 * 1024
#: The name in a line of TOML or CSV.
_NAME = re.compile(r"""(?:"([^"]*)"|'([^']*)'|([^=,]*))""")

#: The numbers that a running program uses instead of the user's.
_preferred: dict[greenlet | None, Mapping[str, int]] = {}


@contextmanager
def preferring(names: Mapping[str, int], *, alone: bool = True) -> Iterator[None]:
    """Let a program look up these names before the user's.

    Args:
        names: the tags' numbers by name.
        alone: whether it is the only program in this process; if not, its own threads use the
            user's names.
    """
    program = None if alone else getcurrent()
    _preferred[program] = names
    try:
        yield
    finally:
        del _preferred[program]


def tag_id(tag: int | str) -> int:
    """Find the number of a tag by its number or by its name in the dictionary.

    Raises:
        TagNumberError: there is no tag with this number.
        UnknownNameError: no tag has this name.
        TagNamesError: ``tags.toml`` is invalid.
    """
    number = _whole(tag)
    if number is None:
        preferred = _preferred.get(getcurrent()) or _preferred.get(None, {})
        if str(tag) in preferred:
            return preferred[str(tag)]
        names = tag_names()
        if str(tag) not in names:
            raise UnknownNameError("tag", str(tag), names)
        return names[str(tag)]
    if not 0 <= number <= LAST_TAG:
        raise TagNumberError("world-no-tag", number=str(number), last=str(LAST_TAG))
    return number


def file() -> Path:
    """The path of the user's dictionary, which need not exist."""
    return home() / "tags.toml"


def tag_names() -> Mapping[str, int]:
    """The user's names with the number of each tag; empty without a dictionary.

    Raises:
        TagNamesError: ``tags.toml`` is invalid.
    """
    path = file()
    try:
        changed = path.stat().st_mtime_ns
    except OSError:
        return {}
    return _read(path, changed)


def read(path: Path) -> Mapping[str, int]:
    """Read the file of a dictionary, as `parse` does.

    Raises:
        TagNamesError: it is invalid, or not UTF-8.
        OSError: it cannot be read.
    """
    try:
        source = path.read_text("utf-8-sig")
    except UnicodeDecodeError as error:
        message = Phrase("file-not-utf-8", position=str(error.start))
        raise TagNamesError(str(path), [Diagnostic("not-utf-8", message)]) from error
    return parse(source, str(path))


def parse(source: str, filename: str) -> Mapping[str, int]:
    """Parse the text of a dictionary: TOML, or CSV if the file's name ends in .csv.

    Raises:
        TagNamesError: it is invalid; the diagnostics say where.
    """
    if len(source) > LARGEST:
        message = Phrase("perception-tags-too-large", size=len(source), limit=LARGEST)
        raise TagNamesError(filename, [Diagnostic("too-large", message)])
    is_csv = filename.lower().endswith(".csv")
    table = _from_csv(source) if is_csv else _from_toml(source, filename)
    problems = list(_problems(table, source))
    if problems:
        raise TagNamesError(filename, problems, source)
    # The check ensures that all values are whole numbers.
    return table  # type: ignore[return-value]


def write(names: Mapping[str, int], *, as_csv: bool = False) -> str:
    """Format a dictionary as text that `parse` can read.

    Raises:
        TagNamesError: a name or a number is invalid.
    """
    problems = list(_problems(names, ""))
    if problems:
        raise TagNamesError(file().name, problems)
    return _to_csv(names) if as_csv else _to_toml(names)


def save_names(names: Mapping[str, int]) -> None:
    """Replace all names in the user's dictionary with these.

    Raises:
        TagNamesError: a name or a number is invalid.
        OSError: the file cannot be written.
    """
    save(file(), write(names).encode())


@lru_cache(maxsize=1)
def _read(path: Path, changed: int) -> Mapping[str, int]:  # noqa: ARG001 - the cache's key
    return read(path)


def _from_toml(source: str, filename: str) -> Mapping[str, object]:
    import tomllib  # noqa: PLC0415 - most programs never need it

    from learnblock.storage.toml_values import loads  # noqa: PLC0415 - as above

    try:
        return loads(source)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError) as error:
        advice = Diagnostic("not-toml", Phrase("perception-tags-not-toml", reason=str(error)))
        raise TagNamesError(filename, [advice], source) from None


def _to_toml(names: Mapping[str, int]) -> str:
    import tomli_w  # noqa: PLC0415 - as above

    return tomli_w.dumps(names)


def _from_csv(source: str) -> Mapping[str, object]:
    """Lines of a name and a number; a header in the first line is skipped."""
    import csv  # noqa: PLC0415 - as above

    rows = [row for row in csv.reader(source.splitlines()) if any(row)]
    if rows and len(rows[0]) == 2 and _whole(rows[0][1]) is None:
        rows = rows[1:]
    pairs = ((row[0].strip(), row[1] if len(row) == 2 else ",".join(row)) for row in rows)
    return {name: number if (whole := _whole(number)) is None else whole for name, number in pairs}


def _to_csv(names: Mapping[str, int]) -> str:
    import csv  # noqa: PLC0415 - as above
    from io import StringIO  # noqa: PLC0415 - as above

    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows([("name", "tag"), *names.items()])
    return text.getvalue()


def _whole(tag: object) -> int | None:
    """A tag given as a number or as digits, as a number; None for a name."""
    if isinstance(tag, str) and not tag.strip().isdecimal():
        return None
    try:
        value = float(tag)  # type: ignore[arg-type] # other types are caught
    except (TypeError, ValueError):
        return None
    return int(value) if value.is_integer() else None


def _problems(table: Mapping[str, object], source: str) -> Iterator[Diagnostic]:
    if len(table) > MOST_NAMES:
        message = Phrase("perception-tags-too-many", count=len(table), limit=MOST_NAMES)
        yield Diagnostic("too-many", message)
        return
    lines = _lines(source)
    for name, number in table.items():
        line = lines.get(name, 0)
        if not name.strip() or len(name) > LONGEST_NAME or not name.isprintable():
            message = Phrase("perception-tags-bad-name", name=name[:60], limit=LONGEST_NAME)
            yield Diagnostic("bad-name", message, line)
        elif _whole(name) is not None:
            message = Phrase("perception-tags-number-as-name", name=name)
            yield Diagnostic("bad-name", message, line)
        if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number <= LAST_TAG:
            values = {"name": name, "value": f"{number!r:.60}", "last": str(LAST_TAG)}
            message = Phrase("perception-tags-bad-number", **values)
            yield Diagnostic("bad-tag", message, line)


def _lines(source: str) -> Mapping[str, int]:
    """The line of each name."""
    numbers: dict[str, int] = {}
    for number, line in enumerate(source.splitlines(), 1):
        if name := _NAME.match(line.strip()):
            numbers.setdefault(name[name.lastindex or 0].strip(), number)
    return numbers
