"""The examples that come with LearnBlock."""

import re
import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from learnblock.errors import UnknownNameError
from learnblock.i18n import languages
from learnblock.running.source import read_text

#: A comment, a text, or a name that belongs to the program: no skill or method.
_WORDS = re.compile(r'# ?(?P<comment>.+)|"(?P<text>[^"\n]*)"|(?<![\w.])(?P<name>[^\W\d]\w*)')


def examples_folder() -> Path:
    """Where the examples are: next to the modules when installed, next to `src` in a checkout."""
    package = Path(__file__).parents[1]
    installed = package / "examples"
    return installed if installed.is_dir() else package.parents[1] / "examples"


def example(name: str) -> Path:
    """Find an example by its file name, with its folder if it is in one: ``several/sumo.bt``.

    Raises:
        UnknownNameError: there is no example with this name.
    """
    folder = examples_folder()
    paths = {path.relative_to(folder).as_posix(): path for path in folder.rglob("*.*")}
    if name in paths:
        return paths[name]
    raise UnknownNameError("example", name, paths)


def example_text(name: str, language: str = "en") -> str:
    """The Block-Text of an example, with its comments, texts and names in a language.

    Args:
        name: its file without the ending, such as ``several/sumo``.
        language: the code of the language; one without words of its own gets English.

    Raises:
        UnknownNameError: there is no example with this name.
    """
    text = read_text(example(f"{name}.bt"))
    words = _words(language).get(name, {})

    def translated(match: re.Match[str]) -> str:
        word = match[match.lastgroup or 0]
        return match[0].replace(word, words.get(word, word)) if word else match[0]

    return _WORDS.sub(translated, text)


@cache
def _words(language: str) -> Mapping[str, Mapping[str, str]]:
    """The words of a language, by example."""
    path = examples_folder() / "words" / f"{language}.toml"
    is_there = language in languages() and path.is_file()
    return tomllib.loads(path.read_text("utf-8")) if is_there else {}
