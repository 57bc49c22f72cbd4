"""Words to join a class with: short, easy to spell, known in English and Spanish alike."""

import secrets
import unicodedata

#: Words that are spelt the same in both languages, or nearly.
WORDS = (
    "animal", "banana", "canal", "coral", "cometa", "delta", "dragon", "festival",
    "final", "gorila", "hotel", "idea", "jaguar", "kiwi", "koala", "limon", "mango", "metal",
    "mosaico", "musical", "natural", "opera", "panda", "papaya", "piano", "planeta",
    "polen", "puma", "radio", "robot", "rumba", "safari", "solar", "taxi", "tropical", "tuba",
    "vapor", "vocal", "volcan", "zebra",
)  # fmt: skip


def new_join_word() -> str:
    """A random word and number, such as ``koala 47``."""
    return f"{secrets.choice(WORDS)} {secrets.randbelow(90) + 10}"


def is_join_word(typed: str, word: str) -> bool:
    """Whether a child has typed the word; case, spaces and accents are ignored."""
    return secrets.compare_digest(_plain(typed), _plain(word))


def _plain(text: str) -> bytes:
    letters = unicodedata.normalize("NFKD", text.casefold())
    return "".join(filter(str.isalnum, letters)).encode()
