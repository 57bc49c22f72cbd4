"""Completion and help in both texts, also while these have mistakes."""

from learnblock.server.help.completing import Completer
from learnblock.server.help.cursor import Cursor
from learnblock.server.help.describing import Describer
from learnblock.server.help.vocabulary import Vocabulary
from learnblock.server.help.words import Words
from learnblock.server.messages import Completions, Description, Notation
from learnblock.server.program.document import Document


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
