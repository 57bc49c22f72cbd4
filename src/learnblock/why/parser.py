"""Questions as a person writes them, in any language that has its words: "not turn left at 8.9"."""

import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache, cached_property, lru_cache

from learnblock.blocks.labels import label
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase, languages, translate
from learnblock.i18n.names import goal_phrase
from learnblock.runtime.log.nodes import Kind, Node
from learnblock.why import mentions, wording
from learnblock.why.history import EventHistory
from learnblock.why.meaning import Meaning, SentenceReader, main_part
from learnblock.why.near import nearest
from learnblock.why.places import place_time
from learnblock.why.questions import Question, QuestionKind, askable, questions
from learnblock.why.spans import RunSpan, take_span
from learnblock.why.vocabulary import Concept, concept, corrected, forms, plain, words

_LINE = re.compile(rf"\b{forms('line')}\s+(\d+)\b")
_NOT = re.compile(rf"\b{forms('negation')}\b|n't\b|n’t\b")
_OPENING = re.compile(rf"^{forms('opening')}\b\s*")
_QUOTED = re.compile(r"[\"'“«](.+?)[\"'”»]")
_NOW = re.compile(forms("now"))
_GOALS = re.compile(rf"\b{forms('goal')}\b")
_PRINTS = re.compile(rf"^{forms('prints')}\b\s*")
_SAYS = re.compile(rf"^{forms('says')}\b\s*")
_PRINTED = re.compile(rf"\b{forms('printed')}\b")
_VARIABLES = re.compile(rf"^{forms('variable')}\s+")
#: The names in programs for the state of a `when`, and for how long it has been active.
_STATES = re.compile(r"^(?:state|time)_")
_QUOTES = re.compile(r"[\"'“”«»]")
#: After a name that is also a word, as in "drive backwards", these make it a name.
_ABOUT_WHEN = re.compile(rf"^{forms('about_when')}\b")
_NEGATED = {
    QuestionKind.MOVEMENT: QuestionKind.NOT_MOVEMENT,
    QuestionKind.SKILL: QuestionKind.NOT_SKILL,
    QuestionKind.PRINT: QuestionKind.NOT_PRINT,
    QuestionKind.WHEN: QuestionKind.NOT_WHEN,
    QuestionKind.LINE: QuestionKind.NOT_LINE,
}


def parse(text: str, history: EventHistory) -> Question:
    """The question that a text asks about a run.

    Raises:
        LearnBlockError: it does not match anything in the run.
    """
    return _Parsing(text, history).question()


class _Parsing:
    """Parses one question."""

    def __init__(self, text: str, history: EventHistory) -> None:
        self._text = text
        self._history = history
        plain_text = plain(text)
        self._span, self._without_time = take_span(plain_text)
        if self._span == RunSpan():
            # Perhaps there is a typo in "between".
            corrected_text = " ".join(map(self._corrected, plain_text.split()))
            span, without = take_span(corrected_text)
            if span != RunSpan():
                self._span, self._without_time = span, without
        self._is_negative = bool(_NOT.search(self._without_time))
        self._rest = _without_opening(_QUOTES.sub(" ", _NOT.sub(" ", self._without_time)))

    def question(self) -> Question:
        for reading in (
            self._listed,
            self._goal_by_name,
            self._line,
            self._now,
            self._named,
            self._skill_by_name,
            self._print,
            self._label,
            self._meant,
            self._mentioned,
            self._print_of_unknown,
            self._at_place,
        ):
            parsed = reading()
            if parsed is not None:
                return parsed
        if not self._rest and self._span.time is not None:
            return self._about(QuestionKind.NOW)
        first, second, third = (question.phrase for question in nearest(self._text, self._history))
        raise LearnBlockError(
            "why-not-understood", question=self._text, first=first, second=second, third=third
        )

    def _about(self, ask: QuestionKind, subject: str = "") -> Question:
        return Question(ask, subject, self._span.time, self._span.since)

    def _signed(self, ask: QuestionKind, subject: str) -> Question:
        return self._about(_NEGATED.get(ask, ask) if self._is_negative else ask, subject)

    # In fixed words.

    def _listed(self) -> Question | None:
        """A question in the words of the lists."""
        plain_question = _without_quotes(self._without_time)
        for question in askable(self._history):
            if plain_question in _wordings(question.phrase):
                return replace(question, time=self._span.time, since=self._span.since)
        return None

    def _now(self) -> Question | None:
        if not _NOW.search(self._without_time):
            return None
        return self._question_of(Meaning(QuestionKind.NOW))

    def _line(self) -> Question | None:
        line = _LINE.search(self._rest)
        return self._signed(QuestionKind.LINE, line[1]) if line else None

    def _named(self) -> Question | None:
        """A `when` or a variable."""
        stated = _VARIABLES.match(self._rest)
        parts = [_VARIABLES.sub("", self._rest), *self._rest.split()[:3]]
        whens = {plain(node.name): node.name for node in self._history.nodes if node.is_when}
        # Python's own names end with an underscore.
        variables = [name for name in self._history.writes if name not in ("_", "robot")]
        names = {plain(name.removesuffix("_")): name for name in variables}
        names |= {plain(name): name for name in variables}
        for part in parts:
            name = part.removeprefix("when ").split(" ")[0] if part else ""
            name = part.removeprefix("when ").split(" ")[0] if name != "when" else name
            if not self._is_about(name):
                continue
            when = name if name in whens else _STATES.sub("", name)
            if when in whens and not stated:
                return self._signed(QuestionKind.WHEN, whens[when])
            if name in names:
                return self._about(QuestionKind.VALUE, names[name])
        return None

    def _is_about(self, name: str) -> bool:
        """Whether a name is the subject, and not a word such as in "turn left"."""
        rest = _VARIABLES.sub("", self._rest)
        stated = rest != self._rest or rest.startswith(("when ", "activate "))
        first = rest.removeprefix("when ").removeprefix("activate ")
        if first.split(" ")[0] != name:
            return False
        behind = first.removeprefix(name).strip()
        is_word = concept(name) is not None and any(
            concept(word) not in (None, Concept.FILLER) for word in words(behind)
        )
        return stated or not is_word or bool(_ABOUT_WHEN.match(behind))

    def _skill_by_name(self) -> Question | None:
        called = {plain(node.name): node.name for node in self._calls()}
        skills = {plain(name): name for name in wording.blocks()}
        if self._rest == "turn":
            # A movement, which other skills make as well.
            return None
        first = re.sub(r"\(.*\)", "", self._rest).removeprefix("function.")
        name = called.get(first.removeprefix("robot.")) or skills.get(first.removeprefix("robot."))
        return self._signed(QuestionKind.SKILL, name) if name else None

    def _calls(self) -> list[Node]:
        nodes = self._history.nodes
        return [node for node in nodes if node.kind is Kind.CALL and node.base == "robot"]

    def _print(self) -> Question | None:
        quoted = _QUOTED.search(self._text)
        verb = _PRINTS.match(self._rest) or (quoted and _PRINTED.search(self._rest))
        if not verb or self._is_said(quoted[1] if quoted else self._rest[verb.end() :]):
            return None
        if quoted and quoted[1] in self._printed and not self._is_negative:
            return self._about(QuestionKind.PRINTED, quoted[1])
        subject = quoted[1] if quoted else self._rest[verb.end() :]
        is_known = quoted or not subject or any(plain(subject) in text for text in self._texts())
        return self._signed(QuestionKind.PRINT, subject) if is_known else None

    def _print_of_unknown(self) -> Question | None:
        """A text that no line prints: the answer says so."""
        verb = _PRINTS.match(self._rest)
        return self._signed(QuestionKind.PRINT, self._rest[verb.end() :]) if verb else None

    def _texts(self) -> Iterator[str]:
        """The texts in the lines that print, and what they printed."""
        yield from (plain(node.text) for node in mentions.prints(self._history))
        yield from map(plain, self._printed)

    @cached_property
    def _printed(self) -> frozenset[str]:
        lines = self._history.recorded.lines
        return frozenset(str(line["print"]) for line in lines if "print" in line)

    def _is_said(self, text: str) -> bool:
        """Whether the program speaks or shows a text, and prints no such text."""
        if not text or any(plain(text) in printed for printed in self._texts()):
            return False
        is_elsewhere = any(plain(text) in plain(node.text) for node in self._calls())
        return is_elsewhere or bool(_SAYS.match(self._rest) and self._reader.skills())

    def _goal_by_name(self) -> Question | None:
        """A goal by its name alone, or after the word for goal."""
        rest = " ".join(_GOALS.sub(" ", self._rest).split())
        for goal in self._history.recorded.ending.get("goals") or ():
            name = str(goal["name"])
            phrase = goal_phrase(name)
            names = {name}
            if isinstance(phrase, Phrase):
                names |= {translate(phrase, language) for language in languages()}
            if rest and rest in map(plain, names):
                is_reached = goal.get("state") == "reached" and not self._is_negative
                return self._about(QuestionKind.REACHED if is_reached else QuestionKind.GOAL, name)
        return None

    def _label(self) -> Question | None:
        """A skill in the words of its block."""
        concepts = frozenset(self._reader.concepts) - {Concept.NOT, Concept.KEEP}
        is_movement = concepts and concepts <= {
            Concept.TURN,
            Concept.LEFT,
            Concept.RIGHT,
            Concept.STOP,
            Concept.MOVE,
            Concept.FORWARD,
            Concept.BACK,
        }
        has_side = concepts & {Concept.LEFT, Concept.RIGHT, Concept.BACK, Concept.FORWARD}
        if is_movement and (has_side or len(self._rest.split()) == 1):
            return None
        for text in (self._rest, f"look {self._rest}"):
            if name := _skills_by_words().get(text):
                return self._signed(QuestionKind.SKILL, name)
        return None

    # In plain sentences.

    @cached_property
    def _reader(self) -> SentenceReader:
        text = main_part(self._without_time)
        return SentenceReader(text, self._history, self._corrected)

    def _corrected(self, word: str) -> str:
        if concept(word) is not None or mentions.root(word) in self._program_words:
            return word
        return corrected(word, self._program_words)

    @cached_property
    def _program_words(self) -> frozenset[str]:
        """The program's vocabulary: its names, its texts, and the words of its blocks."""
        names = {*mentions.words_of(" ".join(self._history.writes))}
        for node in self._history.nodes:
            names |= mentions.words_of(f"{node.name} {node.text if node.kind is Kind.CALL else ''}")
        for text in self._printed:
            names |= mentions.words_of(text)
        return frozenset(names)

    def _meant(self) -> Question | None:
        """What the words of a sentence mean."""
        meaning = self._reader.meaning()
        if self._is_about_print(meaning):
            return self._about_print()
        return self._question_of(meaning) if meaning else None

    def _question_of(self, meaning: Meaning) -> Question:
        question = self._about(meaning.ask, meaning.subject)
        if question.time is not None or question.since is not None:
            return question
        if meaning.is_first:
            return self._first(question)
        time = place_time(self._history, self._without_time)
        return (
            question
            if time is None or meaning.ask is QuestionKind.BUMP
            else replace(question, time=time)
        )

    def _first(self, question: Question) -> Question:
        """A question about the first time that something happened."""
        times = [
            candidate.time
            for candidate in questions(self._history)
            if candidate.ask is question.ask
            and candidate.time is not None
            and (
                candidate.subject == question.subject
                or (not question.subject and "-" in candidate.subject)
            )
        ]
        return replace(question, time=min(times)) if times else question

    def _is_about_print(self, meaning: Meaning | None) -> bool:
        concepts = self._reader.concepts
        if not any(True for _ in mentions.prints(self._history)):
            return False
        says = Concept.SAY in concepts or (Concept.SHOW in concepts and meaning is None)
        return Concept.PRINT in concepts or (
            says and (meaning is None or meaning.ask is not QuestionKind.BUMP)
        )

    def _about_print(self) -> Question | None:
        keywords = mentions.content(self._reader.tokens)
        if self._reader.is_negative:
            return self._about(
                QuestionKind.NOT_PRINT, mentions.print_with(self._history, keywords) or ""
            )
        printed = mentions.printed_text(self._history, keywords)
        if printed is not None:
            return self._about(QuestionKind.PRINTED, printed)
        return self._about(QuestionKind.PRINT, mentions.print_with(self._history, keywords) or "")

    def _mentioned(self) -> Question | None:
        """The parts of the program that the words mention."""
        reader = self._reader
        name = mentions.variable_with(self._history, reader.tokens)
        if name is not None:
            return self._about(QuestionKind.VALUE, name)
        if (when := mentions.when_with(self._history, reader.tokens)) is not None:
            return self._about(
                QuestionKind.NOT_WHEN if reader.is_negative else QuestionKind.WHEN, when
            )
        printed = mentions.printed_text(self._history, mentions.names_in(reader.tokens))
        if printed is not None and not reader.is_negative:
            return self._about(QuestionKind.PRINTED, printed)
        number = mentions.line_with(self._history, mentions.names_in(reader.tokens))
        if number is not None:
            ask = QuestionKind.NOT_LINE if reader.is_negative else QuestionKind.LINE
            return self._about(ask, str(self._history.line(number)))
        is_endless = Concept.KEEP in reader.concepts and not reader.unknown
        return self._about(QuestionKind.NOT_END) if is_endless else None

    def _at_place(self) -> Question | None:
        """A place alone: what the robot did when it was there."""
        time = place_time(self._history, self._without_time)
        return None if time is None else replace(self._about(QuestionKind.NOW), time=time)


@lru_cache(maxsize=4096)
def _wordings(phrase: Phrase) -> frozenset[str]:
    """A question's plain text in each language; kept, since each question asked is compared."""
    texts = (translate(phrase, language) for language in languages())
    return frozenset(_without_quotes(plain(text)) for text in texts)


@cache
def _skills_by_words() -> dict[str, str]:
    return {text: name for name in wording.blocks() for text in _words_of(name)}


def _words_of(name: str) -> Iterator[str]:
    """The words of a skill's block in each language, without its numbers and units."""
    block = wording.blocks().get(name)
    for language in languages() if block else ():
        text = re.sub(r"\(.*?\)\S*|mm/s|°/s", " ", label(block, language))  # type: ignore[arg-type] # there is one
        yield re.sub(r"\s+(?:at|by|to|a)$", "", " ".join(plain(text).replace(",", " ").split()))


def _without_quotes(text: str) -> str:
    return " ".join(_QUOTES.sub(" ", text).split())


def _without_opening(text: str) -> str:
    while opening := _OPENING.match(text):
        if opening.end() == len(text):
            return ""
        text = text[opening.end() :]
    return text.strip()
