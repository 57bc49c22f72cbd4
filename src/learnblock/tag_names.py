"""The dictionary of tags: names that the user gave to AprilTags, in ``tags.toml`` of `home`.

Each line names one tag:

    ball = 3
    "red door" = 12
"""

from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path

from learnblock.errors import Diagnostic, FileError, UnknownNameError
from learnblock.home import home

#: The highest number of an AprilTag of family 36h11, which has 587 tags.
LAST_TAG = 586


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


def tag_names() -> Mapping[str, int]:
    """The user's names with the number of each tag; empty where there is no dictionary.

    Raises:
        TagNamesError: ``tags.toml`` is wrong.
    """
    path = home() / "tags.toml"
    try:
        changed = path.stat().st_mtime_ns
    except OSError:
        return {}
    return _read(path, changed)


@lru_cache(maxsize=1)
def _read(path: Path, changed: int) -> Mapping[str, int]:  # noqa: ARG001 - reads anew when changed
    import tomllib  # noqa: PLC0415 - most programs never need it

    source = path.read_text("utf-8-sig", errors="replace")
    try:
        table = tomllib.loads(source)
    except tomllib.TOMLDecodeError as error:
        raise TagNamesError(
            str(path), [Diagnostic("not-toml", f"{error}; write lines like `ball = 3`")], source
        ) from None
    problems = list(_problems(table, source))
    if problems:
        raise TagNamesError(str(path), problems, source)
    return table


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
    for name, number in table.items():
        if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number <= LAST_TAG:
            yield Diagnostic(
                "bad-tag",
                f"`{name}` is {number!r}; a tag's number is a whole number from 0 to {LAST_TAG}",
                _line(source, name),
            )


def _line(source: str, name: str) -> int:
    lines = source.splitlines()
    starts = (name, f'"{name}"', f"'{name}'")
    return next((i for i, line in enumerate(lines, 1) if line.strip().startswith(starts)), 0)
