"""The words of codes: Fluent files, one for each language and area, read on first use."""

import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fluent.runtime import FluentBundle

ENGLISH = "en"

#: The area with a folder of its own.
_PAGE = "page"
# Not importlib.resources, whose import would slow the start of every program.
_FOLDER = Path(__file__).parent
_CODE = re.compile(r"[a-z][a-z0-9]*(?:-[a-z0-9]+)+")
#: A message on one line, which no indented line continues.
_ONE_LINE = re.compile(r"^([a-z][a-z0-9-]*) = (\S.*)$(?!\s*^[ ])", re.MULTILINE)
#: A place for a value, and what is left of any other.
_PLACE = re.compile(r"\{ \$([a-z][A-Za-z0-9_-]*) \}")
_BRACE = re.compile(r"[{}]")
_THOUSAND = 1000


@cache
def languages() -> tuple[str, ...]:
    """The codes of the available languages, English first."""
    codes = sorted(folder.name for folder in _FOLDER.iterdir() if _is_language(folder))
    return (ENGLISH, *(name for name in codes if name != ENGLISH))


def is_code(text: str) -> bool:
    """Whether a text has the form of a code, such as ``check-unknown-skill``."""
    return _CODE.fullmatch(text) is not None


def words(code: str, values: dict[str, str | int | float], language: str) -> str | None:
    """The words of a code in exactly that language, or None.

    Raises:
        ValueError: the words are invalid, or a value in them is missing.
    """
    area = _area(code)
    plain = _plain(language, area).get(code)
    if plain is not None and all(_is_plain(values.get(place)) for place in _PLACE.findall(plain)):
        return _PLACE.sub(lambda place: _plain_text(values[place[1]]), plain)
    bundle = _bundle(language, area)
    if bundle is None or not bundle.has_message(code):
        return None
    pattern = bundle.get_message(code).value
    if pattern is None:
        return None
    text, errors = bundle.format_pattern(pattern, values)
    if errors:
        raise ValueError(f"{code} in {language}: {errors[0]}")
    return str(text)


def is_known(code: str) -> bool:
    """Whether there are English words for a code."""
    area = _area(code)
    if code in _plain(ENGLISH, area):
        return True
    bundle = _bundle(ENGLISH, area)
    return bundle is not None and bundle.has_message(code)


def _area(code: str) -> str:
    """The file of a code: its first part; of the page's codes also the second one."""
    first, _, rest = code.partition("-")
    return f"{first}/{rest.partition('-')[0]}" if first == _PAGE else first


@cache
def _text(language: str, area: str) -> str | None:
    """The file of an area's words, or None where the language has none."""
    file = _FOLDER / language / f"{area}.ftl"
    return file.read_text("utf-8") if file.is_file() else None


@cache
def _plain(language: str, area: str) -> dict[str, str]:
    """By code the words that are text and places for values, which need no Fluent."""
    pairs = _ONE_LINE.findall(_text(language, area) or "")
    return {code: text.rstrip() for code, text in pairs if not _BRACE.search(_PLACE.sub("", text))}


def _is_plain(value: str | float | None) -> bool:
    """Whether a value is written alike in every language, unlike parts and thousands.

    Fluent writes the others, and reports a missing one.
    """
    if isinstance(value, int | float) and not isinstance(value, bool):
        return 0 <= value < _THOUSAND and value == int(value)
    return isinstance(value, str)


def _plain_text(value: str | float) -> str:
    return value if isinstance(value, str) else str(int(value))


@cache
def _bundle(language: str, area: str) -> "FluentBundle | None":
    """The words of one area, or None where the language has none."""
    text = _text(language, area)
    if text is None:
        return None
    # Imported late: loading Fluent takes a tenth of a second, and most runs show only plain words.
    from fluent.runtime import FluentBundle, FluentResource  # noqa: PLC0415

    bundle = FluentBundle([language], use_isolating=False)
    bundle.add_resource(FluentResource(text))
    return bundle


def _is_language(folder: Path) -> bool:
    return folder.is_dir() and any(file.name.endswith(".ftl") for file in folder.iterdir())
