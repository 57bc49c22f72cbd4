"""Answers questions about a run with its blocks and moments; slow to load."""

from learnblock.server import messages
from learnblock.server.runs.reading import Reading
from learnblock.why import questions as why
from learnblock.why.questions import Question, QuestionKind
from learnblock.why.sentences import Sentence


def questions(reading: Reading, block: str, time: float | None) -> messages.Questions:
    """What can be asked about the run, about a block, or about the robot at a time in s."""
    history = reading.history
    if block:
        lines = (history.program.written_line(line) for line in reading.blocks.lines(block))
        possible = why.questions_about_lines(history, frozenset(map(str, lines)), time)
    elif time is not None:
        possible = why.questions_about_moment(history, time)
    else:
        possible = why.questions(history)
    return messages.Questions(tuple(_asked(reading, question) for question in possible), block)


def answer(reading: Reading, question: messages.WhyQuestion) -> messages.WhyAnswer:
    """The answer to a question."""
    asked = Question(QuestionKind(question.ask), question.subject, question.time)
    answered = reading.answers.answer(asked)
    return messages.WhyAnswer(
        _asked(reading, why.with_values(reading.history, asked)),
        tuple(_sentence(reading, sentence) for sentence in answered.sentences),
        tuple(_sentence(reading, sentence) for sentence in answered.more),
    )


def _sentence(reading: Reading, sentence: Sentence) -> messages.WhySentence:
    return messages.WhySentence(
        sentence.phrase,
        sentence.time if sentence.event >= 0 else None,
        _block(reading, str(sentence.line)),
        _block(reading, str(sentence.phrase.values.get("inner", ""))),
    )


def _asked(reading: Reading, question: Question) -> messages.Asked:
    asked = messages.WhyQuestion(question.ask.value, question.subject, question.time)
    return messages.Asked(asked, question.phrase, _block(reading, question.subject))


def _block(reading: Reading, line: str) -> str | None:
    """The block of an author's line, given as text; None if it is no line."""
    number = int(line) if line.isdecimal() and len(line) < 10 else 0
    return reading.blocks.at(reading.history.program.python_line(number)) if number else None
