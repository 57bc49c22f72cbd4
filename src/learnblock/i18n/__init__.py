"""Messages for people: phrases by code, and their words in each language.

A phrase is a code with named values. Its words are in ``i18n/LANGUAGE/AREA.ftl``, where the area
is the first part of the code: ``check-unknown-skill`` is in ``check.ftl``. The page uses the same
files.

    >>> str(Phrase("file-too-large", name="square.bt", limit=4))
    'square.bt is too large: the limit is 4 MB.'
"""

from learnblock.i18n.phrase import (
    Multilingual,
    Phrase,
    Value,
    can_be_said,
    in_each_language,
    parts,
    translate,
    with_languages,
)
from learnblock.i18n.words import ENGLISH, languages

__all__ = [
    "ENGLISH",
    "Multilingual",
    "Phrase",
    "Value",
    "can_be_said",
    "in_each_language",
    "languages",
    "parts",
    "translate",
    "with_languages",
]
