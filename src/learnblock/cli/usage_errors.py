"""click's messages about a wrong call, in languages other than English, from ``help.ftl``.

click formats its messages before it raises them, so the English ones are recognised by their form.
One that is not known, such as one of a newer click, stays English; ours are in the reader's
language already.
"""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import IO, Any

import click

from learnblock.cli.help_texts import words
from learnblock.cli.language import is_english

#: click's messages, the more special forms first, and the codes of our words. A ``{message}`` is
#: one of them, too.
CODES = {
    "{message} Did you mean {names}?": "help-error-did-you-mean",
    "{message} (Did you mean one of: {names}?)": "help-error-did-you-mean-one-of",
    "Invalid value for {name}: {message}": "help-error-value-for",
    "Invalid value: {message}": "help-error-value",
    "Missing argument {name}. Choose from:{choices}": "help-error-missing-choice",
    "Missing option {name}. Choose from:{choices}": "help-error-missing-option-choice",
    "Missing argument {name}.": "help-error-missing",
    "Missing option {name}.": "help-error-missing-option",
    "Missing command.": "help-error-missing-command",
    "No such option {name}.": "help-error-no-option",
    # click 8.2 and 8.3
    "No such option: {name}": "help-error-no-option",
    "No such command {name}.": "help-error-no-command",
    "Option {name} requires an argument.": "help-error-option-needs-value",
    "Option {name} does not take a value.": "help-error-option-takes-no-value",
    "Argument {name} takes {count} values.": "help-error-count",
    "Got unexpected extra argument ({values})": "help-error-extra",
    "Got unexpected extra arguments ({values})": "help-error-extra-several",
    "{value} is not one of {choices}.": "help-error-not-one-of",
    "{value} is not a valid integer.": "help-error-not-integer",
    "{value} is not a valid integer range.": "help-error-not-integer",
    "{value} is not a valid float.": "help-error-not-number",
    "{value} is not a valid float range.": "help-error-not-number",
    "{value} is not in the range {range}.": "help-error-not-in-range",
    "File {name} does not exist.": "help-error-no-file",
    "Directory {name} does not exist.": "help-error-no-folder",
    "Path {name} does not exist.": "help-error-no-path",
    "File {name} is a directory.": "help-error-is-folder",
    "Directory {name} is a file.": "help-error-is-file",
    "{kind} {name} is not readable.": "help-error-not-readable",
    "{kind} {name} is not writable.": "help-error-not-writable",
    "{value} is not {choice}.": "help-error-not",
}
#: What surrounds them.
AROUND = {
    "Error: {message}": "help-error",
    "Try {command} for help.": "help-error-try",
    "Aborted!": "help-error-aborted",
}


class TranslatedUsageError(click.ClickException):
    """A wrong call, whose message already has all that is printed."""

    def __init__(self, error: click.ClickException) -> None:
        self.exit_code = error.exit_code  # type: ignore[misc]  # click has it for a whole class
        super().__init__("\n".join(_lines(error)))

    def show(self, file: IO[Any] | None = None) -> None:
        click.echo(self.message, file=file, err=True)


@contextmanager
def reported_in_own_language() -> Iterator[None]:
    """Turn click's errors into such with words in the reader's language.

    It has to be done while the call's language is known, which click forgets before it prints.
    """
    try:
        yield
    except click.ClickException as error:
        if is_english() or isinstance(error, TranslatedUsageError):
            raise
        raise TranslatedUsageError(error) from error
    except click.Abort as error:
        if is_english():
            raise
        click.echo(_around("Aborted!"), err=True)
        raise click.exceptions.Exit(1) from error


def translated(english: str) -> str:
    """A message of click in the reader's language; any other unchanged."""
    for pattern, code in _PATTERNS:
        if match := pattern.fullmatch(english):
            values = match.groupdict()
            if "message" in values:
                values["message"] = translated(values["message"])
            return words(code, english, **values)
    return english


def _lines(error: click.ClickException) -> Iterator[str]:
    context = getattr(error, "ctx", None)
    if context is not None:
        yield context.get_usage()
        yield _around("Try {command} for help.", command=f"'{context.command_path} --help'")
        yield ""
    yield _around("Error: {message}", message=translated(error.format_message()))


def _around(template: str, **values: str) -> str:
    return words(AROUND[template], template.format(**values), **values)


def _pattern(template: str) -> re.Pattern[str]:
    form = re.sub(r"\\\{(\w+)\\\}", r"(?P<\1>.+?)", re.escape(template))
    return re.compile(form, re.DOTALL)


_PATTERNS = tuple((_pattern(template), code) for template, code in CODES.items())
