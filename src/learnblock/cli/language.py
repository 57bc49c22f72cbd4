"""The reader's language: ``--language``, or else the system's."""

from contextvars import ContextVar
from functools import partial

import click

from learnblock.i18n import ENGLISH
from learnblock.i18n.reader import system_language

#: What ``--language`` names; a run's own thread sees it too, unlike click's context.
_chosen: ContextVar[str | None] = ContextVar("language", default=None)


def choose(ctx: click.Context, _: click.Parameter, chosen: str | None) -> None:
    """Keep the language that ``--language`` names, for all commands of this call."""
    if chosen is not None:
        ctx.call_on_close(partial(_chosen.reset, _chosen.set(chosen)))


def language() -> str:
    """The code of the reader's language."""
    return _chosen.get() or system_language()


def is_english() -> bool:
    """Whether the reader's language is that of docstrings, options and click's own messages."""
    return language() == ENGLISH
