"""Errors as phrases for the page."""

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase


def phrase_of(error: Exception) -> Phrase:
    """The phrase of an error; of another library's exception, its text."""
    if isinstance(error, LearnBlockError):
        return error.phrase
    return Phrase(str(error) or type(error).__name__)
