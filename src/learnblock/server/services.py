"""Completion and help in both texts, also while these have mistakes."""

from learnblock.server.completing import Completer
from learnblock.server.cursor import Cursor
from learnblock.server.describing import Describer
from learnblock.server.document import Document
from learnblock.server.messages import Completions, Description, Notation
from learnblock.server.vocabulary import Vocabulary
from learnblock.server.words import Words


def complete(
    document: Document,
    notation: Notation,
    line: int,
    column: int,
    *,
    language: str = "en",
    request: int = 0,
) -> Completions:
    """What could stand at a place of a text.

    Args:
        document: the program.
        notation: which text.
        line: from 1.
        column: from 1.
        language: of what is said about it.
        request: of the message that asked.
    """
    vocabulary = Vocabulary(document, notation, line)
    cursor = Cursor.at(vocabulary.text, line, column)
    options = Completer(vocabulary, cursor, Words(language)).options()
    return Completions(request, cursor.start + 1, tuple(options))


def describe(
    document: Document,
    notation: Notation,
    line: int,
    column: int,
    *,
    language: str = "en",
    request: int = 0,
) -> Description:
    """What stands at a place of a text; see `complete`."""
    vocabulary = Vocabulary(document, notation, line)
    cursor = Cursor.at(vocabulary.text, line, column)
    return Describer(vocabulary, cursor, Words(language)).description(request)
