"""Help in languages other than English, from ``help.ftl``.

English help is in the docstrings and options, so that English `--help` reads no Fluent file. In
``help.ftl`` a command has the code ``help-robots-set``, and its option ``--json`` the code
``help-robots-set-with-json``. The examples of a command are those of its docstring.
What has no words there stays English.
"""

import copy
import inspect
from collections.abc import Iterator

import click

from learnblock.cli.language import is_english, language
from learnblock.i18n import words as catalogue

#: The codes of the words that appear in the help of every command.
COMMON_CODES = {
    "Usage": "help-word-usage",
    "Options": "help-word-options",
    "Commands": "help-word-commands",
    "[OPTIONS]": "help-word-options-metavar",
    "COMMAND [ARGS]...": "help-word-command-metavar",
    "Show this message and exit.": "help-word-help",
}
_EPILOG = "help-word-epilog"
#: click's mark before a paragraph that is not wrapped; ours hold examples.
_EXAMPLES = "\b"


def english(command: click.Command, path: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    """Every code of the help of a command and of the commands in it, with its English words."""
    yield _command_code(path), _parts(command.help)[0]
    if command.epilog:
        yield _EPILOG, command.epilog
    for option in _options(command):
        yield _option_code(path, option), option.help or ""
    if isinstance(command, click.Group):
        for name, inner in command.commands.items():
            yield from english(inner, (*path, name))


def translated(command: click.Command, path: tuple[str, ...]) -> click.Command:
    """A copy of a command with help in the reader's language."""
    translated_command = copy.copy(command)
    translated_command.context_class = Context
    translated_command.help = _help(command.help, _command_code(path))
    translated_command.short_help = " ".join(
        translated_command.help.partition("\n\n")[0].split()
    ).rstrip(".")
    translated_command.options_metavar = _common("[OPTIONS]")
    translated_command.params = [_parameter(parameter, path) for parameter in command.params]
    translated_command.params.append(_help_option())
    if command.epilog:
        translated_command.epilog = words(_EPILOG, command.epilog)
    if isinstance(translated_command, click.Group):
        translated_command.subcommand_metavar = _common("COMMAND [ARGS]...")
        translated_command.commands = {
            name: translated(inner, (*path, name))
            for name, inner in translated_command.commands.items()
        }
    return translated_command


class _Formatter(click.HelpFormatter):
    """Help with headings in the reader's language."""

    def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
        if not is_english():
            prefix = f"{_common('Usage')}: "
        super().write_usage(prog, args, prefix)

    def write_heading(self, heading: str) -> None:
        is_common = heading in COMMON_CODES and not is_english()
        super().write_heading(_common(heading) if is_common else heading)


class Context(click.Context):
    """The context of a command whose help may be in a language other than English."""

    formatter_class = _Formatter


def _help(text: str | None, code: str) -> str:
    """The help of a command: its words in the reader's language, and its examples."""
    sentences, examples = _parts(text)
    return words(code, sentences) + examples


def _parts(text: str | None) -> tuple[str, str]:
    """The sentences of a command's help, and its examples, if there are any."""
    sentences, mark, examples = inspect.cleandoc(text or "").partition(_EXAMPLES)
    return sentences.rstrip(), f"\n\n{mark}{examples}" if mark else ""


def _parameter(parameter: click.Parameter, path: tuple[str, ...]) -> click.Parameter:
    translated_parameter = copy.copy(parameter)
    if isinstance(translated_parameter, click.Option):
        code = _option_code(path, translated_parameter)
        translated_parameter.help = words(code, translated_parameter.help or "")
    return translated_parameter


def _help_option() -> click.Option:
    def show(ctx: click.Context, _: click.Parameter, is_wanted: bool) -> None:  # noqa: FBT001
        if is_wanted and not ctx.resilient_parsing:
            click.echo(ctx.get_help(), color=ctx.color)
            ctx.exit()

    return click.Option(
        ["-h", "--help"],
        is_flag=True,
        expose_value=False,
        is_eager=True,
        help=_common("Show this message and exit."),
        callback=show,
    )


def _options(command: click.Command) -> Iterator[click.Option]:
    return (parameter for parameter in command.params if isinstance(parameter, click.Option))


def _command_code(path: tuple[str, ...]) -> str:
    return "-".join(("help", *(path or ("learnblock",))))


def _option_code(path: tuple[str, ...], option: click.Option) -> str:
    return f"{_command_code(path)}-with-{option.opts[0].removeprefix('--')}"


def _common(text: str) -> str:
    return words(COMMON_CODES[text], text)


def words(code: str, otherwise: str, **values: str) -> str:
    """The words of a code of ``help.ftl`` in the reader's language, or else English ones."""
    translation = catalogue.words(code, {**values}, language())
    return otherwise if translation is None else translation
