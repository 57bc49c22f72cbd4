"""The reader's language as the system has it: LEARNBLOCK_LANGUAGE, or else that of the locale."""

import locale
import os
from collections.abc import Iterator

VARIABLE = "LEARNBLOCK_LANGUAGE"
#: The languages with words of their own, English first.
LANGUAGES = ("en", "es")
#: Windows names the languages of its locales in English.
_WINDOWS_NAMES = {"english": "en", "spanish": "es"}


def system_language() -> str:
    """The code of the reader's language."""
    codes = (_code(name) for name in _names() if name)
    return next((code for code in codes if code in LANGUAGES), LANGUAGES[0])


def _names() -> Iterator[str]:
    """The locales from the environment, else from the system, the most important first."""
    variables = (VARIABLE, "LC_ALL", "LC_MESSAGES", "LANG")
    named = [value for name in variables if (value := os.environ.get(name, ""))]
    # The first one is used, even if we do not have its language.
    yield from named[:1] or [locale.getlocale()[0] or ""]


def _code(name: str) -> str:
    """``es`` from ``es_ES.UTF-8`` or ``Spanish_Spain``."""
    first = name.replace("-", "_").partition("_")[0].partition(".")[0].lower()
    return _WINDOWS_NAMES.get(first, first)
