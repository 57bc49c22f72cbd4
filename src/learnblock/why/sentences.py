"""Answers: sentences of one fact each, with the line and the moment that it is about."""

from dataclasses import dataclass

from learnblock.i18n import Phrase, Value, translate
from learnblock.why.history import EventHistory

#: The number of sentences that come first; the others are under "more".
FIRST = 4
#: The number of sentences of a part that come before those of the next.
_HEAD = 2


@dataclass(frozen=True, slots=True)
class Sentence:
    """One fact.

    Args:
        phrase: the fact in words.
        line: the author's line that it is about; 0 for none.
        event: the event that it is about; -1 for none.
        time: when that was, in s.
    """

    phrase: Phrase
    line: int
    event: int
    time: float


@dataclass(frozen=True, slots=True)
class Explanation:
    """The answer to a question.

    Args:
        sentences: the most important ones, at most `FIRST`.
        more: the others.
    """

    sentences: tuple[Sentence, ...]
    more: tuple[Sentence, ...] = ()

    @property
    def lines(self) -> tuple[int, ...]:
        """The author's lines that the first sentences are about, in order, each of them once."""
        lines = (sentence.line for sentence in self.sentences if sentence.line)
        return tuple(dict.fromkeys(lines))

    def words(self, language: str) -> tuple[str, ...]:
        """The first sentences in a language."""
        return tuple(translate(sentence.phrase, language) for sentence in self.sentences)


class Draft:
    """The sentences of an answer as they are found; a fact is told once.

    Args:
        history: of the run.
    """

    def __init__(self, history: EventHistory) -> None:
        self._history = history
        self._facts: dict[tuple[str, int, str], Sentence] = {}
        #: How many sentences were told before each part but the first.
        self._parts: list[int] = []

    def __len__(self) -> int:
        return len(self._facts)

    def has(self, code: str, line: int) -> bool:
        """Whether a sentence has told something about a line."""
        return any((known_code, of) == (code, line) for known_code, of, _ in self._facts)

    def begin_part(self) -> None:
        """Begin another answer to the same question: the heads of all parts come first."""
        if self._facts:
            self._parts.append(len(self._facts))

    def say(self, code: str, node: int = -1, event: int = -1, **values: Value) -> None:
        """Add a sentence about a place in the program.

        Args:
            code: of its phrase, which may use ``$line``, ``$code`` and ``$time``.
            node: the place; -1 for none.
            event: when; -1 for no moment.
            values: of the phrase; ``time`` if it is not that of the event.
        """
        line = self._history.line(node) if node >= 0 else 0
        self.say_of_line(code, line, event, **values)

    def say_of_line(self, code: str, line: int, event: int = -1, **values: Value) -> None:
        """Add a sentence about a line of its author."""
        history = self._history
        time = history.time(event) if event >= 0 else history.end
        if isinstance(moment := values.get("time"), int | float):
            # What is told need not be an event of the program.
            time = moment
        details = {
            "line": str(line),
            "code": quoted(history, line),
            "time": round(time, 2),
            **values,
        }
        name = values.get("name")
        if isinstance(name, str) and name.endswith("_") and name not in history.program.written:
            # Python has the author's name for itself.
            details["name"] = name.removesuffix("_")
        phrase = Phrase(code, **details)
        fact = (code, line, str(values.get("name", "")) + str(values.get("inner", "")))
        self._facts.setdefault(fact, Sentence(phrase, line, event, time))

    def answer(self) -> Explanation:
        """The sentences so far."""
        sentences = self._in_order(tuple(self._facts.values()))
        return Explanation(sentences[:FIRST], sentences[FIRST:])

    def _in_order(self, sentences: tuple[Sentence, ...]) -> tuple[Sentence, ...]:
        ends = [*self._parts, len(sentences)]
        parts = [sentences[start:end] for start, end in zip([0, *self._parts], ends, strict=True)]
        heads = [sentence for part in parts for sentence in part[:_HEAD]]
        return (*heads, *(sentence for part in parts for sentence in part[_HEAD:]))


def quoted(history: EventHistory, line: int) -> str:
    """A line as its author wrote it, without what every such line has."""
    text = history.program.quote(line).partition("#")[0].strip().removesuffix(":")
    return text.replace("function.", "").replace("robot.", "")
