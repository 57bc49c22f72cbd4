"""The reader's language: ``--language``, or else the system's."""

from contextvars import ContextVar
from functools import partial

import click

from learnblock.i18n import ENGLISH
from learnblock.i18n.reader import system_language

#: What ``--language`` names; a run's own thread sees it too, unlike click's context.
_choice: ContextVar[str | None] = ContextVar("language", default=None)


def choose(ctx: click.Context, _: click.Parameter, code: str | None) -> None:
    """Keep the language that ``--language`` names, for all commands of this call."""
    if code is not None:
        ctx.call_on_close(partial(_choice.reset, _choice.set(code)))


def language() -> str:
    """The code of the reader's language."""
    return _choice.get() or system_language()


def is_english() -> bool:
    """Whether the reader's language is that of docstrings, options and click's own messages."""
    return language() == ENGLISH
