"""The codes of a phrase, for tests that do not depend on its words."""

from learnblock.i18n import Phrase


def codes(phrase):
    """Return the code of a phrase, and those of the phrases in it."""
    inner = [part for part in phrase.values.values() if isinstance(part, Phrase)]
    return [phrase.code, *(code for part in inner for code in codes(part))]
