"""The reader's language: ``--language``, LEARNBLOCK_LANGUAGE, or else the system's."""

import locale
import os
from collections.abc import Iterator
from contextvars import ContextVar
from functools import partial

import click

#: The languages of the command line, English first.
LANGUAGES = ("en", "es")
VARIABLE = "LEARNBLOCK_LANGUAGE"

#: What ``--language`` names; a run's own thread sees it too, unlike click's context.
_chosen: ContextVar[str | None] = ContextVar("language", default=None)
#: Windows names the languages of its locales in English.
_WINDOWS_NAMES = {"english": "en", "spanish": "es"}


def choose(ctx: click.Context, _: click.Parameter, chosen: str | None) -> None:
    """Keep the language that ``--language`` names, for all commands of this call."""
    if chosen is not None:
        ctx.call_on_close(partial(_chosen.reset, _chosen.set(chosen)))


def language() -> str:
    """The code of the reader's language."""
    return _chosen.get() or _of_system()


def _of_system() -> str:
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
