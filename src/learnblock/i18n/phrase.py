"""A message for a person: a code and named values."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Self, Union

from learnblock.i18n.words import ENGLISH, is_code, is_known, languages, words

#: The values of a phrase. Numbers are formatted for the language, so a number used as a name
#: (a port, an identifier) is passed as a string; a tuple is shown as a list with commas.
Value = Union[str, int, float, "Phrase", tuple[Union[str, "Phrase"], ...]]


class Multilingual(str):
    """A text that is known in several languages, such as the label of a block.

    As a string it is English.

    Args:
        texts: by language, among them English.
    """

    __slots__ = ("texts",)
    texts: Mapping[str, str]

    def __new__(cls, texts: Mapping[str, str]) -> Self:
        text = super().__new__(cls, texts[ENGLISH])
        text.texts = texts
        return text


def with_languages(text: object) -> object:
    """A text that is known in several languages, for the page to choose from."""
    if isinstance(text, Multilingual):
        return {"texts": dict(text.texts)}
    raise NotImplementedError(type(text).__name__)


# Why: docs/decisions.md, "Every message is a phrase"
@dataclass(frozen=True, slots=True, init=False)
class Phrase:
    """A message for a person.

    ``str(phrase)`` is the English text; `learnblock.i18n.translate` gives it in another language.

    Args:
        code: the key of the words, such as ``check-unknown-skill``. Any other text, such as
            the message of a library's exception, is shown as it is.
        values: the values inserted into the words, by name.
    """

    code: str
    values: Mapping[str, Value]

    def __init__(self, code: str, /, **values: Value) -> None:
        object.__setattr__(self, "code", code)
        object.__setattr__(self, "values", values)

    def __hash__(self) -> int:
        # Mappings are not hashable, but diagnostics are compared in sets.
        return hash((self.code, frozenset(self.values.items())))

    def __str__(self) -> str:
        return translate(self, ENGLISH)

    def __reduce__(self) -> tuple[object, ...]:
        return _phrase, (self.code, dict(self.values))


def _phrase(code: str, values: Mapping[str, Value]) -> Phrase:
    return Phrase(code, **values)


def translate(phrase: Phrase, language: str) -> str:
    """A phrase's text in a language; in English where that language has no words for it.

    Text that isn't one of our codes is returned unchanged.

    Raises:
        ValueError: the words of a phrase are invalid, or a value is missing.
    """
    if not is_code(phrase.code):
        return phrase.code
    for candidate in dict.fromkeys((language, ENGLISH)):
        values = {name: _shown(value, candidate) for name, value in phrase.values.items()}
        text = words(phrase.code, values, candidate)
        if text is not None:
            return text
    return phrase.code


def in_each_language(phrase: Phrase) -> dict[str, str]:
    """A phrase's text by language."""
    return {language: translate(phrase, language) for language in languages()}


def can_be_said(phrase: Phrase) -> bool:
    """Whether the words of a phrase are known and have all their values, in every language."""
    codes = (part.code for part in parts(phrase) if isinstance(part, Phrase))
    if not all(is_known(code) for code in codes if is_code(code)):
        return False
    try:
        for language in languages():
            translate(phrase, language)
    except (ValueError, TypeError, ArithmeticError):
        return False
    return True


def parts(value: Value | None, levels: int = 1000) -> Iterator[Value | None]:
    """A phrase, its values and theirs; None for what is nested deeper than that."""
    yield value if levels else None
    if levels and isinstance(value, Phrase | tuple):
        for inner in value.values.values() if isinstance(value, Phrase) else value:
            yield from parts(inner, levels - 1)


def _shown(value: Value, language: str) -> str | int | float:
    if isinstance(value, Phrase):
        return translate(value, language)
    if isinstance(value, Multilingual):
        return value.texts.get(language, str(value))
    if isinstance(value, tuple):
        return ", ".join(str(_shown(item, language)) for item in value)
    return value
