"""Helpers of all commands: exit codes, words in the reader's language, and JSON for tools."""

from collections.abc import Iterable, Sequence
from dataclasses import fields, is_dataclass
from enum import IntEnum
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.language import language
from learnblock.shell import command_line

if TYPE_CHECKING:
    from learnblock.errors import Diagnostic
    from learnblock.i18n import Phrase
    from learnblock.storage.settings import Described

#: A symbol for each control character; those from 0x80 on are an Esc and a letter.
_SYMBOLS = {
    **{code: chr(0x2400 + code) for code in range(0x20) if chr(code) not in "\n\t"},
    0x7F: "\u2421",
    **{code: "\u241b" + chr(code - 0x40) for code in range(0x80, 0xA0)},
}
#: The same in JSON, where those below 0x20 are escaped already.
_ESCAPES = {code: f"\\u{code:04x}" for code in range(0x7F, 0xA0)}

EXISTING_FILE = click.Path(exists=True, dir_okay=False, path_type=Path)
json_option = click.option("--json", "as_json", is_flag=True, help="Print JSON, for tools.")


class ExitCode(IntEnum):
    """The exit code of a command, for scripts."""

    WELL = 0
    #: A file has mistakes, or a check failed.
    MISTAKES = 1
    #: The command was invalid: an option, or a missing file, robot or world.
    USAGE = 2
    #: The program ended with an error.
    PROGRAM_FAILED = 3
    #: The program had to be stopped, or was killed.
    PROGRAM_STOPPED = 4
    #: Ctrl-C.
    INTERRUPTED = 130


def text(phrase: "Phrase | str") -> str:
    """A phrase in the reader's language, or other text; both as `visible`."""
    from learnblock.i18n import Phrase, translate  # noqa: PLC0415 - `--help` needs none of it

    return visible(translate(phrase, language()) if isinstance(phrase, Phrase) else phrase)


def visible(text: str) -> str:
    r"""A text whose control characters are symbols, so that a program can't command a terminal.

    New lines and tabs stay.

    >>> visible("red \x1b[31m alarm \x07")
    'red ␛[31m alarm ␇'
    """
    return text if text.isprintable() else text.translate(_SYMBOLS)


def say(code: str, /, *, err: bool = False, **values: Any) -> None:
    """Print a phrase in the reader's language.

    Args:
        code: the code of the phrase.
        err: print it to standard error.
        values: the values of the phrase, by name.
    """
    from learnblock.i18n import Phrase  # noqa: PLC0415 - `--help` needs none of it

    click.echo(text(Phrase(code, **values)), err=err)


def warn(phrase: "Phrase") -> None:
    """Print a phrase to stderr."""
    click.echo(text(phrase), err=True)


def usage_error(code: str, /, **values: Any) -> click.UsageError:
    """Create the error for a wrong call of a command."""
    from learnblock.i18n import Phrase  # noqa: PLC0415 - `--help` needs none of it

    return click.UsageError(text(Phrase(code, **values)))


def print_json(value: object) -> None:
    """Print a value as indented JSON; phrases in it are English."""
    import msgspec  # noqa: PLC0415 - `--help` needs none of it

    # Below 0x20 they are escaped in JSON.
    formatted = msgspec.json.format(msgspec.json.encode(_with_texts(value)), indent=2).decode()
    click.echo(formatted if formatted.isascii() else formatted.translate(_ESCAPES))


def _with_texts(value: object) -> object:
    """A value in which each phrase is its English text."""
    from learnblock.i18n import Phrase  # noqa: PLC0415 - as above

    match value:
        case Phrase():
            return str(value)
        case dict():
            return {name: _with_texts(item) for name, item in value.items()}
        case list() | tuple():
            return [_with_texts(item) for item in value]
        case _ if is_dataclass(value):
            return {field.name: _with_texts(getattr(value, field.name)) for field in fields(value)}
    return value


def print_settings(settings: "Sequence[Described]", *, as_json: bool) -> None:
    """Print settings, one per line, with the values that each accepts."""
    from learnblock.i18n import Phrase  # noqa: PLC0415 - `--help` needs none of it

    if as_json:
        print_json(settings)
        return
    width = max(len(setting.name) for setting in settings) + 1
    for setting in settings:
        default = text(Phrase("cli-default", value=typed(setting.default)))
        mark = "" if setting.value == setting.default else f"  [{default}]"
        click.echo(
            f"{setting.name:<{width}} {typed(setting.value):<22} {text(setting.allowed)}{mark}"
        )


def print_diagnostics(
    filename: str, diagnostics: "Iterable[Diagnostic]", source: str, *, err: bool = False
) -> None:
    """Print diagnostics, each with its line and a caret."""
    for diagnostic in diagnostics:
        click.echo(located(filename, diagnostic), err=err)
        if pointed := diagnostic.pointed(source):
            click.echo("    " + visible(pointed).replace("\n", "\n    "), err=err)


def located(filename: str, diagnostic: "Diagnostic") -> str:
    """``FILE:LINE:COLUMN: code message``, the message in the reader's language."""
    place = f"{filename}:{diagnostic.line}:{diagnostic.column}"
    return f"{place}: {diagnostic.code} {text(diagnostic.message)}"


def print_command(*words: object) -> None:
    """Print a command to type, as a shell takes it."""
    click.echo(f"    {command_line(*words)}")


def typed(value: Any) -> str:
    """A setting's value as the user types it."""
    return value if isinstance(value, str) and value else repr(value)
