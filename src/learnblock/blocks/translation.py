"""The words of the basic blocks, the palette and the units, in one file for each language."""

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType

_FOLDER = Path(__file__).parent / "translations"
#: The key of a unit's plural begins with the first; that of its singular also ends with the second.
_UNIT, _AFTER_ONE = "LB_UNIT_", "_ONE"


def languages() -> tuple[str, ...]:
    """The languages with a translation, such as ``en`` and ``es``."""
    return tuple(sorted(path.stem for path in _FOLDER.glob("*.json")))


@cache
def translation(language: str) -> Mapping[str, str]:
    """The words of the built-in blocks of the language, by message name."""
    codes = languages()
    best = next((code for code in (language, language.partition("-")[0]) if code in codes), "en")
    return MappingProxyType({**_words("en"), **_words(best)})


@cache
def units() -> Mapping[str, str]:
    """The units after numbers, each with its singular.

    They are those of all languages, because a block without a translation is shown in English.

    >>> units()["seconds"]
    'second'
    """
    singulars: dict[str, str] = {}
    for language in languages():
        words = _words(language)
        singulars |= {
            word: words.get(key + _AFTER_ONE, word)
            for key, word in words.items()
            if key.startswith(_UNIT) and not key.endswith(_AFTER_ONE)
        }
    return MappingProxyType(singulars)


@cache
def _words(language: str) -> dict[str, str]:
    entries = json.loads((_FOLDER / f"{language}.json").read_text("utf-8"))
    return {str(name): str(text) for name, text in entries.items()}
