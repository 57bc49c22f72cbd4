"""The names that people have, in every script.

A name is measured in characters as people see them: a letter with its vowel signs and accents is
one, however many code points it has.
"""

import unicodedata
from typing import NamedTuple

#: The most characters of a first name, and the most signs on one of them: Burmese needs six.
LONGEST, MOST_MARKS = 30, 6
#: The most bytes of a first name, so that it fits into the name of a folder.
MOST_BYTES = 200
#: What names contain in addition to letters, their signs and digits: spaces, hyphens and
#: apostrophes, and the dots of Catalan, Japanese and Tibetan.
_BETWEEN = frozenset(" .-'`´‘’‐‑·・･་׳״")
#: A name can begin with an apostrophe, as in Tongan.
_APOSTROPHES = frozenset("'`´‘’")
#: They change how the letters next to them are joined, as Persian and Sinhala names need.
_JOINERS = frozenset("\u200c\u200d")
#: Unicode calls them letters and signs, but they show nothing.
_FILLERS = frozenset("\u034f\u115f\u1160\u17b4\u17b5\u3164\uffa0")


class Flaw(NamedTuple):
    """Why a text isn't a first name.

    Args:
        hidden: the number of a character that can't be seen, such as ``U+202E``; empty if it has
            none.
    """

    hidden: str = ""


def normalized(text: str) -> str:
    """A name in Unicode's composed form, with single spaces and none around it."""
    return " ".join(unicodedata.normalize("NFC", text).split())


def folded(name: str) -> str:
    """A name without what people type differently the next day: case, accents, joiners, spaces."""
    decomposed = unicodedata.normalize("NFKD", name).casefold()
    # Folding may compose again.
    letters = unicodedata.normalize("NFKD", decomposed)
    return " ".join("".join(c for c in letters if not _is_ornament(c)).split())


def length(text: str) -> int:
    """The number of characters as people see them."""
    return sum(not _is_mark(c) and c not in _JOINERS for c in unicodedata.normalize("NFC", text))


def hidden_character(text: str) -> str | None:
    """The first invisible character: a control, a mark of direction, a filler."""
    return next((c for i, c in enumerate(text) if _is_hidden(text, i)), None)


def flaw_of_first_name(name: str) -> Flaw | None:
    """What is wrong with a normalized first name; None if people can have it."""
    if hidden := hidden_character(name):
        return Flaw(f"U+{ord(hidden):04X}")
    fits = length(name) <= LONGEST and len(name.encode(errors="replace")) <= MOST_BYTES
    return None if fits and _is_written_as_name(name) else Flaw()


def may_have_surname(name: str) -> bool:
    """Whether a name has several words, so that it may be a first name and a surname.

    A single letter is none: it tells pupils of one name apart.
    """
    return sum(sum(map(str.isalpha, word)) > 1 for word in name.split()) > 1


def _is_written_as_name(name: str) -> bool:
    start = name.lstrip("".join(_APOSTROPHES))
    if len(name) - len(start) > 1 or not start or not start[0].isalpha():
        return False
    is_known = all(_is_letter(c) or c in _BETWEEN or c in _JOINERS for c in name)
    return is_known and _most_marks(name) <= MOST_MARKS and name[-1] not in "-‐‑"


def _most_marks(text: str) -> int:
    most = count = 0
    for c in text:
        count = count + 1 if _is_mark(c) else 0
        most = max(most, count)
    return most


def _is_letter(c: str) -> bool:
    return c.isalpha() or _is_mark(c) or unicodedata.category(c) == "Nd"


def _is_mark(c: str) -> bool:
    return unicodedata.category(c).startswith("M")


def _is_ornament(c: str) -> bool:
    return unicodedata.combining(c) != 0 or c in _JOINERS


def _is_hidden(text: str, index: int) -> bool:
    c = text[index]
    if c in _JOINERS:
        before, after = text[:index], text[index + 1 :]
        return not (before and after and _is_letter(before[-1]) and after[0].isalpha())
    return c in _FILLERS or unicodedata.category(c) in {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
