"""What pupils type in their own language instead of English words: ``words/LANGUAGE.toml``."""

import re
import tomllib
from collections import defaultdict
from collections.abc import Mapping
from functools import cache
from pathlib import Path

FOLDER = Path(__file__).parent / "words"
#: Matches nothing: no language has words for this place.
_NOTHING = "(?!)"


def foreign(place: str) -> str:
    """A pattern for the words of all languages for a place in a line, such as ``repeat``.

    Those for ``keys`` are the keys of the keyboard.
    """
    words = foreign_names("keys") if place == "keys" else _tables()["words"].get(place, ())
    forms = sorted(words, key=len, reverse=True)
    return "|".join(re.escape(form).replace(r"\ ", r"\s+") for form in forms) or _NOTHING


def foreign_names(table: str) -> Mapping[str, str]:
    """What pupils name in their own language, and the English of it: a table of the files."""
    return {word: english for english, words in _tables()[table].items() for word in words}


@cache
def _tables() -> Mapping[str, Mapping[str, list[str]]]:
    """The words of all languages, by table and English word."""
    tables: dict[str, dict[str, list[str]]] = defaultdict(lambda: defaultdict(list))
    for file in sorted(FOLDER.glob("*.toml")):
        for table, entries in tomllib.loads(file.read_text("utf-8")).items():
            for english, words in entries.items():
                tables[table][english] += words
    return tables
