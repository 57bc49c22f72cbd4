"""The questions most similar to one that was not understood."""

from dataclasses import replace
from difflib import SequenceMatcher
from itertools import chain

from learnblock.i18n import languages, translate
from learnblock.why.history import EventHistory
from learnblock.why.questions import Question, QuestionKind, questions
from learnblock.why.vocabulary import Concept, concept, corrected, plain, words

#: The number of questions offered.
_OFFERED = 3
_VAGUE = frozenset({None, Concept.FILLER, Concept.NOT})
#: A word in common counts more than letters in common.
_OF_LETTERS = 0.5


def nearest(text: str, history: EventHistory) -> tuple[Question, ...]:
    """The three questions about a run most similar to a text."""
    question_words = [corrected(word) for word in words(plain(text))]
    question_concepts = {concept(word) for word in question_words} - _VAGUE
    question_text = " ".join(question_words)

    def likeness(question: Question) -> float:
        texts = [plain(translate(question.phrase, language)) for language in languages()]
        concepts = {concept(word) for wording in texts for word in words(wording)} - _VAGUE
        letters = max(SequenceMatcher(None, question_text, wording).ratio() for wording in texts)
        return len(question_concepts & concepts) + _OF_LETTERS * letters

    general = (
        Question(QuestionKind.NOW, "", round(history.end, 2)),
        Question(QuestionKind.NOTHING),
    )
    # One about each subject: the first time.
    by_subject: dict[tuple[QuestionKind, str], Question] = {}
    for question in chain(questions(history), general):
        by_subject.setdefault((question.ask, question.subject), question)
    ranked = sorted(by_subject.values(), key=likeness, reverse=True)
    return tuple(replace(question) for question in ranked[:_OFFERED])
