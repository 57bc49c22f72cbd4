"""Completion and help in both notations, even in programs with errors."""

from learnblock.project.document.document import Document
from learnblock.project.document.views import Notation
from learnblock.project.help.completing import Completer
from learnblock.project.help.completion import Completions
from learnblock.project.help.cursor import Cursor
from learnblock.project.help.describing import Describer, Description
from learnblock.project.help.vocabulary import Vocabulary
from learnblock.project.help.words import Words


def complete(
    document: Document,
    notation: Notation,
    line: int,
    column: int,
    *,
    language: str = "en",
) -> Completions:
    """Find the completions at a position.

    Args:
        document: the program.
        notation: the notation of the text.
        line: the line, from 1.
        column: the column, from 1.
        language: the language of the descriptions.
    """
    vocabulary = Vocabulary(document, notation, line)
    cursor = Cursor.at(vocabulary.text, line, column)
    options = Completer(vocabulary, cursor, Words(language)).options()
    return Completions(cursor.start + 1, tuple(options))


def describe(
    document: Document,
    notation: Notation,
    line: int,
    column: int,
    *,
    language: str = "en",
) -> Description:
    """Describe the word at a position; see `complete`."""
    vocabulary = Vocabulary(document, notation, line)
    cursor = Cursor.at(vocabulary.text, line, column)
    return Describer(vocabulary, cursor, Words(language)).description()
