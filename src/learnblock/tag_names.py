"""The dictionary of tags: names that the user gave to AprilTags, in ``tags.toml`` of `home`.

Each line names one tag:

    ball = 3
    "red door" = 12
"""

from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path

from learnblock.errors import Diagnostic, FileError, UnknownNameError
from learnblock.files import save
from learnblock.home import home

#: The highest number of an AprilTag of family 36h11, which has 587 tags.
LAST_TAG = 586
MOST_NAMES = 2000
LONGEST_NAME = 100
#: Bytes of a dictionary.
LARGEST = 256 * 1024


class TagNamesError(FileError):
    """The dictionary of tags is wrong."""


def tag_id(tag: int | str) -> int:
    """The number of a tag given by its number or by its name in the dictionary.

    Raises:
        UnknownNameError: there is no such number, or no tag has this name.
        TagNamesError: ``tags.toml`` is wrong.
    """
    number = _whole(tag)
    if number is None:
        names = tag_names()
        if str(tag) in names:
            return names[str(tag)]
    elif 0 <= number <= LAST_TAG:
        return number
    else:
        names = {}
    raise UnknownNameError(
        "tag", str(tag), (*names, f"numbers 0 to {LAST_TAG}, and names listed in tags.toml")
    )


def file() -> Path:
    """Where the user's dictionary stands; the file need not be there."""
    return home() / "tags.toml"


def tag_names() -> Mapping[str, int]:
    """The user's names with the number of each tag; empty where there is no dictionary.

    Raises:
        TagNamesError: ``tags.toml`` is wrong.
    """
    path = file()
    try:
        changed = path.stat().st_mtime_ns
    except OSError:
        return {}
    return _read(path, changed)


def parse(source: str, filename: str) -> Mapping[str, int]:
    """The names in the text of a dictionary: TOML, or CSV where the file's name ends so.

    Raises:
        TagNamesError: it is wrong; the diagnostics say where.
    """
    if len(source) > LARGEST:
        message = f"the file has {len(source):,} characters; a dictionary has at most {LARGEST:,}"
        raise TagNamesError(filename, [Diagnostic("too-large", message)])
    is_csv = filename.lower().endswith(".csv")
    table = _from_csv(source) if is_csv else _from_toml(source, filename)
    problems = list(_problems(table, source))
    if problems:
        raise TagNamesError(filename, problems, source)
    # No number of the table is anything else by now.
    return table  # type: ignore[return-value]


def write(names: Mapping[str, int], *, as_csv: bool = False) -> str:
    """The text of a dictionary that `parse` reads again.

    Raises:
        TagNamesError: a name or a number is wrong.
    """
    problems = list(_problems(names, ""))
    if problems:
        raise TagNamesError(file().name, problems)
    return _to_csv(names) if as_csv else _to_toml(names)


def save_names(names: Mapping[str, int]) -> None:
    """Put these names in place of all those in the user's dictionary.

    Raises:
        TagNamesError: a name or a number is wrong.
        OSError: the file cannot be written.
    """
    save(file(), write(names).encode())


@lru_cache(maxsize=1)
def _read(path: Path, changed: int) -> Mapping[str, int]:  # noqa: ARG001 - reads anew when changed
    return parse(path.read_text("utf-8-sig", errors="replace"), str(path))


def _from_toml(source: str, filename: str) -> Mapping[str, object]:
    import tomllib  # noqa: PLC0415 - most programs never need it

    try:
        return tomllib.loads(source)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError) as error:
        advice = Diagnostic("not-toml", f"{error}; write lines like `ball = 3`")
        raise TagNamesError(filename, [advice], source) from None


def _to_toml(names: Mapping[str, int]) -> str:
    import tomli_w  # noqa: PLC0415 - as above

    return tomli_w.dumps(names)


def _from_csv(source: str) -> Mapping[str, object]:
    """Lines of a name and a number; a first line that is a heading is passed over."""
    import csv  # noqa: PLC0415 - as above

    rows = [row for row in csv.reader(source.splitlines()) if any(row)]
    if rows and len(rows[0]) == 2 and _whole(rows[0][1]) is None:
        rows = rows[1:]
    found = ((row[0].strip(), row[1] if len(row) == 2 else ",".join(row)) for row in rows)
    return {name: number if (whole := _whole(number)) is None else whole for name, number in found}


def _to_csv(names: Mapping[str, int]) -> str:
    import csv  # noqa: PLC0415 - as above
    from io import StringIO  # noqa: PLC0415 - as above

    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows([("name", "tag"), *names.items()])
    return text.getvalue()


def _whole(tag: object) -> int | None:
    """`tag` as a number, also when it is written as text, or None where it is a name."""
    if isinstance(tag, str) and not tag.strip().isdecimal():
        return None
    try:
        value = float(tag)  # type: ignore[arg-type] # what is no number is caught
    except (TypeError, ValueError):
        return None
    return int(value) if value.is_integer() else None


def _problems(table: Mapping[str, object], source: str) -> Iterator[Diagnostic]:
    if len(table) > MOST_NAMES:
        message = f"the dictionary has {len(table)} names; at most {MOST_NAMES} are kept"
        yield Diagnostic("too-many", message)
    for name, number in table.items():
        if not name.strip() or len(name) > LONGEST_NAME or not name.isprintable():
            message = f"{name!r:.60} is no name of a tag: write 1 to {LONGEST_NAME} characters"
            yield Diagnostic("bad-name", message, _line(source, name))
        elif _whole(name) is not None:
            message = f"`{name}` is a number: a tag's name has a letter in it"
            yield Diagnostic("bad-name", message, _line(source, name))
        if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number <= LAST_TAG:
            yield Diagnostic(
                "bad-tag",
                f"`{name}` is {number!r:.60}; a tag's number is a whole number from 0 to"
                f" {LAST_TAG}",
                _line(source, name),
            )


def _line(source: str, name: str) -> int:
    lines = source.splitlines()
    starts = (name, f'"{name}"', f"'{name}'")
    return next((i for i, line in enumerate(lines, 1) if line.strip().startswith(starts)), 0)
