"""The reader's language as the system has it: LEARNBLOCK_LANGUAGE, or else that of the locale."""

import locale
import os
from collections.abc import Iterator

from learnblock.i18n.words import ENGLISH, languages

VARIABLE = "LEARNBLOCK_LANGUAGE"


def system_language() -> str:
    """The code of the reader's language."""
    codes = (_code(name) for name in _names() if name)
    return next((code for code in codes if code in languages()), ENGLISH)


def _names() -> Iterator[str]:
    """The locales from the environment, else from the system, the most important first."""
    variables = (VARIABLE, "LC_ALL", "LC_MESSAGES", "LANG")
    locales = [value for name in variables if (value := os.environ.get(name, ""))]
    # The first one is used, even if we do not have its language.
    yield from locales[:1] or [locale.getlocale()[0] or ""]


def _code(name: str) -> str:
    """``es`` from ``es_ES.UTF-8`` or ``Spanish_Spain``."""
    first = name.replace("-", "_").partition("_")[0].partition(".")[0].lower()
    # Windows names the languages of its locales in English, as X11 did.
    return locale.normalize(first).partition("_")[0].lower()
