"""The names of our worlds' goals, which files have in English, in the reader's words."""

import re

from learnblock.i18n.phrase import Phrase
from learnblock.i18n.words import is_known


def goal_phrase(name: str) -> str | Phrase:
    """A goal of one of our worlds in the reader's words; other names as they are."""
    word = re.sub(r"[^a-z0-9]+", "-", name.casefold())
    code = f"page-catalog-name-{word}"
    if match := re.fullmatch(r"tag (\d+)", name):
        return Phrase("page-catalog-goal-tag", number=match[1])
    return Phrase(code) if is_known(code) else name
