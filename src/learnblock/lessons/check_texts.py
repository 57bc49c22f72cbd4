"""The texts of a lesson's checks in Python, in a file for each language: ``checks.es.toml``.

A check names a text and gives its values, so another language is another file and no Python:

    [texts]
    backed_off = "El robot ha ido {mm:.0f} mm hacia atrás."
"""

from collections.abc import Iterator, Mapping
from string import Formatter
from typing import Annotated

from msgspec import Meta, Struct

from learnblock.errors import LessonError
from learnblock.i18n import ENGLISH, Phrase
from learnblock.lessons.opened import TEXTS_OF_CHECKS, OpenLesson
from learnblock.lessons.texts import Line
from learnblock.storage import toml_source

TextName = Annotated[str, Meta(pattern=r"^[A-Za-z]\w{0,59}$", description="a name, such as late")]
Texts = Mapping[str, str]


class TextsFile(Struct, frozen=True, forbid_unknown_fields=True):
    """The content of a file of texts.

    Args:
        texts: by their names. The values in them are as in Python's ``str.format``.
    """

    texts: Annotated[dict[TextName, Line], Meta(max_length=100)]


def check_texts(opened: OpenLesson) -> dict[str, Texts]:
    """The texts of a lesson's checks by language; one that a language lacks is taken from another.

    Raises:
        LessonError: one of the files has mistakes, or uses other values than another language.
    """
    own = own_texts(opened)
    usual: dict[str, str] = {}
    for texts in (*own.values(), own.get(ENGLISH, {})):
        usual |= texts
    return {language: {**usual, **texts} for language, texts in own.items()}


def own_texts(opened: OpenLesson) -> dict[str, Texts]:
    """The texts of a lesson's checks by language, each language with only what its file has.

    Raises:
        LessonError: as `check_texts`.
    """
    own: dict[str, Texts] = {}
    for path in sorted(opened.files):
        if match := TEXTS_OF_CHECKS.fullmatch(path):
            own[match[1]] = _read(opened, path, own)
    return own


def _read(opened: OpenLesson, path: str, others: Mapping[str, Texts]) -> Texts:
    filename, source = f"{opened.name}/{path}", opened.text(path)
    document = toml_source.parse(source, filename, LessonError)

    def findings(file: TextsFile) -> Iterator[toml_source.FileMistake]:
        return _findings(file.texts, others)

    return toml_source.convert(
        document, TextsFile, LessonError, findings, name=filename, source=source
    ).texts


def _findings(texts: Texts, others: Mapping[str, Texts]) -> Iterator[toml_source.FileMistake]:
    for name, text in texts.items():
        try:
            values = _values(text)
        except ValueError as error:
            message = Phrase("lesson-text-braces", reason=str(error))
            yield toml_source.FileMistake(("texts", name), "wrong-text", message)
            continue
        for language, translated in others.items():
            if name in translated and _values(translated[name]) != values:
                message = Phrase("lesson-text-values", name=name, language=language)
                yield toml_source.FileMistake(("texts", name), "other-values", message)
                break


def _values(text: str) -> set[str]:
    """The names of the values in a text.

    Raises:
        ValueError: its braces don't match.
    """
    return {name for _, name, _, _ in Formatter().parse(text) if name is not None}
