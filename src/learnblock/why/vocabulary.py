"""The words of questions, and what they mean: each language is a file in ``words``."""

import re
import unicodedata
from collections.abc import Collection, Iterator, Mapping
from difflib import get_close_matches
from enum import StrEnum
from functools import cache
from importlib import resources
from itertools import chain
from string import ascii_lowercase

import msgspec


class Concept(StrEnum):
    """What a word of a question means."""

    NOT = "not"
    NOTHING = "nothing"
    KEEP = "keep"
    LONG = "long"
    FIRST = "first"
    AGAIN = "again"
    STOP = "stop"
    TURN = "turn"
    CURVE = "curve"
    LEFT = "left"
    RIGHT = "right"
    BACK = "back"
    FORWARD = "forward"
    MOVE = "move"
    AVOID = "avoid"
    CRASH = "crash"
    FALL = "fall"
    SLOW = "slow"
    FAST = "fast"
    LEAVE = "leave"
    FOLLOW = "follow"
    SEARCH = "search"
    SEE = "see"
    TRACK = "track"
    WALL = "wall"
    EDGE = "edge"
    TAG = "tag"
    END = "end"
    ERROR = "error"
    PROGRAM = "program"
    GOAL = "goal"
    PRINT = "print"
    SAY = "say"
    SHOW = "show"
    FACE = "face"
    JOY = "joy"
    SADNESS = "sadness"
    ANGER = "anger"
    FEAR = "fear"
    DISGUST = "disgust"
    SURPRISE = "surprise"
    NEUTRAL = "neutral"
    LAMP = "lamp"
    SOUND = "sound"
    SCREEN = "screen"
    CAMERA = "camera"
    PEN = "pen"
    COLOUR = "colour"
    #: Only a part of a sentence.
    FILLER = "filler"


EMOTIONS = (
    Concept.JOY,
    Concept.SADNESS,
    Concept.ANGER,
    Concept.FEAR,
    Concept.DISGUST,
    Concept.SURPRISE,
    Concept.NEUTRAL,
)

#: The words of a language, and its ways to ask: one file each.
_FOLDER = resources.files(__package__) / "words"


class Together(msgspec.Struct, frozen=True):
    """Words that mean something else together.

    Args:
        pattern: a regular expression.
        word: what is read instead.
    """

    pattern: str
    word: str


class LanguageOfQuestions(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How people ask in one language.

    Args:
        words: the words of each concept.
        forms: regular expressions of what may stand at one place of a question.
        translated: words of programs, which are in English there.
        together: words that mean something else together.
    """

    words: dict[Concept, str]
    forms: dict[str, list[str]]
    translated: dict[str, str] = {}
    together: list[Together] = []


@cache
def languages_of_questions() -> tuple[LanguageOfQuestions, ...]:
    """Every language in which one can ask, by its code."""
    files = sorted(
        (file for file in _FOLDER.iterdir() if file.name.endswith(".toml")),
        key=lambda file: file.name,
    )
    return tuple(msgspec.toml.decode(file.read_bytes(), type=LanguageOfQuestions) for file in files)


def forms(name: str) -> str:
    """A regular expression of the forms with a name, in any language."""
    every = (form for language in languages_of_questions() for form in language.forms.get(name, ()))
    return f"(?:{'|'.join(every)})"


@cache
def translated() -> Mapping[str, str]:
    """Words of other languages for those that programs have in English."""
    return {
        word: english
        for language in languages_of_questions()
        for word, english in language.translated.items()
    }


@cache
def _together() -> tuple[tuple[re.Pattern[str], str], ...]:
    return tuple(
        (re.compile(rule.pattern), rule.word)
        for language in languages_of_questions()
        for rule in language.together
    )


_MADE_WORDS = {"firsttime": Concept.FIRST, "longtime": Concept.LONG, "oncemore": Concept.AGAIN}

#: Shorter words are taken as they are written.
_SHORTEST_SLIP = 4
#: The same for a word that begins like a known one, and has a typo as well.
_LONGEST_END = 4
#: How similar a word has to be to one that is known.
_ALIKE = 0.8


def plain(text: str) -> str:
    """A text in small letters without accents, question marks and double spaces."""
    apart = unicodedata.normalize("NFKD", text.casefold())
    bare = "".join(character for character in apart if not unicodedata.combining(character))
    return " ".join(re.sub(r"[¿?!¡:]", " ", bare).split())


def words(text: str) -> list[str]:
    """The words of a plain text, those that belong together as one."""
    text = re.sub(r"['’`´]", "", text)
    text = " ".join(re.sub(r"[^\w.]", " ", text).replace(". ", " ").strip(".").split())
    for pattern, together in _together():
        text = pattern.sub(together, text)
    return text.split()


def concept(word: str) -> Concept | None:
    """What a word means; None if it is unknown."""
    exact, stems = _table()
    if word in exact:
        return exact[word]
    return next(
        (stems[word[:size]] for size in range(len(word), 2, -1) if word[:size] in stems), None
    )


def corrected(word: str, others: Collection[str] = ()) -> str:
    """An unknown word without its typo, if it is similar to a known one.

    Args:
        word: as it was written.
        others: other known words, such as names of the program.
    """
    if len(word) < _SHORTEST_SLIP or not word.isalpha():
        return word
    exact, _ = _table()
    slips, exchanged = dict.fromkeys(_slips(word)), dict.fromkeys(_exchanged(word))
    for is_known, candidates in (
        (others.__contains__, slips),
        (exact.__contains__, slips),
        (_is_nearly_whole, slips),
        (others.__contains__, exchanged),
        (exact.__contains__, exchanged),
    ):
        if likely := next((candidate for candidate in candidates if is_known(candidate)), None):
            return likely
    known_words = [
        known_word for known_word in (*others, *exact) if len(known_word) >= _SHORTEST_SLIP
    ]
    near = get_close_matches(word, known_words, n=1, cutoff=_ALIKE)
    return near[0] if near else word


def _is_nearly_whole(word: str) -> bool:
    """Whether little is left of a word after a known beginning."""
    _, stems = _table()
    return any(
        word[:size] in stems for size in range(max(3, len(word) - _LONGEST_END), len(word) + 1)
    )


def _slips(word: str) -> Iterator[str]:
    """The candidates for a word with an extra letter, a missing one, or two swapped ones."""
    parts = [(word[:index], word[index:]) for index in range(len(word) + 1)]
    yield from (left + right[1] + right[0] + right[2:] for left, right in parts if len(right) > 1)
    yield from (left + right[1:] for left, right in parts if right)
    yield from (left + letter + right for left, right in parts for letter in ascii_lowercase)


def _exchanged(word: str) -> Iterator[str]:
    """The candidates for a word with one letter replaced; a short one is another word."""
    for index in range(len(word)) if len(word) > _SHORTEST_SLIP else ():
        yield from (word[:index] + letter + word[index + 1 :] for letter in ascii_lowercase)


@cache
def _table() -> tuple[dict[str, Concept], dict[str, Concept]]:
    """Whole words, and the beginnings of words, with their concepts."""
    exact: dict[str, Concept] = dict(_MADE_WORDS)
    stems: dict[str, Concept] = {}
    for meaning in Concept:
        for word in chain.from_iterable(
            language.words.get(meaning, "").split() for language in languages_of_questions()
        ):
            table = stems if word.endswith("*") else exact
            table.setdefault(word.removesuffix("*"), meaning)
    return exact, stems
