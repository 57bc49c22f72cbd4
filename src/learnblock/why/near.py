"""The questions that are most like one that was not understood."""

from dataclasses import replace
from difflib import SequenceMatcher
from itertools import chain

from learnblock.i18n import languages, translate
from learnblock.why.history import History
from learnblock.why.questions import Ask, Question, questions
from learnblock.why.vocabulary import Concept, concept, corrected, plain, words

#: So many questions are offered.
_OFFERED = 3
_VAGUE = frozenset({None, Concept.FILLER, Concept.NOT})
#: A word in common counts more than letters in common.
_OF_LETTERS = 0.5


def nearest(text: str, history: History) -> tuple[Question, ...]:
    """The three questions about a run that are most like a text."""
    asked = [corrected(word) for word in words(plain(text))]
    meant = {concept(word) for word in asked} - _VAGUE
    written = " ".join(asked)

    def likeness(question: Question) -> float:
        texts = [plain(translate(question.phrase, language)) for language in languages()]
        found = {concept(word) for one in texts for word in words(one)} - _VAGUE
        letters = max(SequenceMatcher(None, written, one).ratio() for one in texts)
        return len(meant & found) + _OF_LETTERS * letters

    general = (Question(Ask.NOW, "", round(history.end, 2)), Question(Ask.NOTHING))
    # One about each subject: the first time.
    found: dict[tuple[Ask, str], Question] = {}
    for one in chain(questions(history), general):
        found.setdefault((one.ask, one.subject), one)
    ranked = sorted(found.values(), key=likeness, reverse=True)
    return tuple(replace(one) for one in ranked[:_OFFERED])
