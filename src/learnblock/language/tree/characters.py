"""Characters that programs do not have, with what to type instead."""

import unicodedata
from collections.abc import Mapping
from types import MappingProxyType

from learnblock.i18n import Phrase

#: The categories of characters without a picture of their own.
_INVISIBLE = frozenset(("Cc", "Cf", "Cn", "Co", "Zs", "Zl", "Zp"))
#: Signs of other keyboards that compatibility does not make plain.
_PLAIN: Mapping[str, str] = MappingProxyType(
    {
        **dict.fromkeys("،、", ","),
        **dict.fromkeys("。।", "."),
        **dict.fromkeys("·∙⋅", "*"),
        **dict.fromkeys("「」『』〝〞", '"'),
        "؛": ";",
        "٪": "%",
        "⁄": "/",
        **{power: f"**{unicodedata.digit(power)}" for power in "²³⁴⁵⁶⁷⁸⁹"},
    }
)


def write_instead(written: str, instead: str) -> Phrase:
    """Advice to write one thing instead of another."""
    return Phrase("blocktext-write-instead", found=written, instead=instead)


def foreign(text: str) -> Phrase | None:
    """The message about a character that programs do not have; None if there is nothing to add."""
    for character in text:
        if unicodedata.category(character) in _INVISIBLE:
            code = "blocktext-odd-space" if character.isspace() else "blocktext-invisible"
            name = unicodedata.name(character, "?").lower()
            return Phrase(code, name=name, number=f"U+{ord(character):04X}")
    plain = _PLAIN.get(text) or _plain(text)
    return None if plain is None else write_instead(text, plain)


def _plain(text: str) -> str | None:
    """The same character or digit as keyboards have it."""
    if len(text) == 1 and (digit := unicodedata.decimal(text, None)) is not None:
        return str(digit)
    plain = unicodedata.normalize("NFKC", text).replace("\N{FRACTION SLASH}", "/")
    return plain if plain != text and plain.isascii() and plain.isprintable() else None
