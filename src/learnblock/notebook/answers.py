"""Answers to questions about a robot in a notebook, in words."""

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase, Value, translate
from learnblock.i18n.reader import system_language
from learnblock.notebook.cell_program import CellProgram
from learnblock.why import EventHistory, Recorded
from learnblock.why.answers import answer
from learnblock.why.parser import parse
from learnblock.why.questions import questions
from learnblock.why.things import seen_in_run

#: The values of phrases that are numbers of lines.
_LINES = frozenset({"line", "inner"})


class CellAnswer(str):
    """An answer, which a notebook shows as it is written."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


def answer_about(recorded: Recorded, cells: CellProgram, question: str) -> CellAnswer:
    """Answer a question about what a robot has done so far.

    Args:
        recorded: its log.
        cells: the cells that made it do so.
        question: what is asked; without one, the answer is what can be asked.
    """
    language = system_language()
    if not cells.nodes:
        return CellAnswer(translate(Phrase("notebook-not-noted"), language))
    history = EventHistory(recorded)
    try:
        phrases = _phrases(history, question)
    except LearnBlockError as error:
        # A question that is not understood is answered, too: by others that can be asked.
        phrases = [error.phrase]
    placed = (translate(_placed(phrase, cells), language) for phrase in phrases)
    return CellAnswer("\n".join(placed))


def _phrases(history: EventHistory, question: str) -> list[Phrase]:
    if not question:
        return [askable.phrase for askable in questions(history)]
    reply = answer(history, parse(question, history), seen_in_run(history.recorded))
    return [sentence.phrase for sentence in reply.sentences]


def _placed(phrase: Phrase, cells: CellProgram) -> Phrase:
    """A phrase whose lines are those of cells."""
    values = {name: _place(name, value, cells) for name, value in phrase.values.items()}
    return Phrase(phrase.code, **values)


def _place(name: str, value: Value, cells: CellProgram) -> Value:
    if isinstance(value, Phrase):
        return _placed(value, cells)
    if isinstance(value, tuple):
        return tuple(_placed(item, cells) if isinstance(item, Phrase) else item for item in value)
    if name in _LINES and isinstance(value, str) and value.isdecimal() and int(value):
        cell, line = cells.place(int(value))
        return Phrase("notebook-line", line=str(line), cell=str(cell))
    return value
