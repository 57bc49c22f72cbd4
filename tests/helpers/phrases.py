"""The codes of a phrase, for tests that do not depend on its words."""

from learnblock.i18n import Phrase


def codes(phrase):
    """Return the code of a phrase, and those of the phrases in it."""
    inner = [one for one in phrase.values.values() if isinstance(one, Phrase)]
    return [phrase.code, *(code for one in inner for code in codes(one))]
