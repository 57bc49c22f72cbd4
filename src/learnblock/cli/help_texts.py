"""Help in languages other than English, from ``help.ftl``.

English help is in the docstrings and options, so that English `--help` reads no Fluent file. In
``help.ftl`` a command has the code ``help-robots-set``, and its option ``--json`` the code
``help-robots-set-with-json``. The examples of a command are those of its docstring.
"""

import copy
import inspect
from collections.abc import Iterator

import click

from learnblock.cli.language import LANGUAGES, language

#: The codes of the words that appear in the help of every command.
COMMON_CODES = {
    "Usage": "help-word-usage",
    "Options": "help-word-options",
    "Commands": "help-word-commands",
    "[OPTIONS]": "help-word-options-metavar",
    "COMMAND [ARGS]...": "help-word-command-metavar",
    "epilog": "help-word-epilog",
    "help": "help-word-help",
}
#: click's mark before a paragraph that is not wrapped; ours hold examples.
_EXAMPLES = "\b"


def codes(command: click.Command, path: tuple[str, ...]) -> Iterator[str]:
    """Every code of the help of a command and of the commands in it."""
    yield _command_code(path)
    for option in _options(command):
        yield _option_code(path, option)
    if isinstance(command, click.Group):
        for name, inner in command.commands.items():
            yield from codes(inner, (*path, name))


def translated(command: click.Command, path: tuple[str, ...]) -> click.Command:
    """A copy of a command with help in the reader's language."""
    found = copy.copy(command)
    found.context_class = Context
    found.help = _help(command.help or "", _command_code(path))
    found.short_help = found.help.partition("\n")[0].rstrip(".")
    found.options_metavar = _common("[OPTIONS]")
    found.params = [_parameter(parameter, path) for parameter in command.params]
    found.params.append(_help_option())
    if command.epilog:
        found.epilog = _common("epilog")
    if isinstance(found, click.Group):
        found.subcommand_metavar = _common("COMMAND [ARGS]...")
        found.commands = {
            name: translated(inner, (*path, name)) for name, inner in found.commands.items()
        }
    return found


class _Formatter(click.HelpFormatter):
    """Help with headings in the reader's language."""

    def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
        if language() != LANGUAGES[0]:
            prefix = f"{_common('Usage')}: "
        super().write_usage(prog, args, prefix)

    def write_heading(self, heading: str) -> None:
        known = heading in COMMON_CODES and language() != LANGUAGES[0]
        super().write_heading(_common(heading) if known else heading)


class Context(click.Context):
    """The context of a command whose help may be in a language other than English."""

    formatter_class = _Formatter


def _help(english: str, code: str) -> str:
    """The help of a command: its words in the reader's language, and its examples."""
    _, mark, examples = inspect.cleandoc(english).partition(_EXAMPLES)
    return words(code) + (f"\n\n{mark}{examples}" if mark else "")


def _parameter(parameter: click.Parameter, path: tuple[str, ...]) -> click.Parameter:
    found = copy.copy(parameter)
    if isinstance(found, click.Option):
        found.help = words(_option_code(path, found))
    return found


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
        help=_common("help"),
        callback=show,
    )


def _options(command: click.Command) -> Iterator[click.Option]:
    return (parameter for parameter in command.params if isinstance(parameter, click.Option))


def _command_code(path: tuple[str, ...]) -> str:
    return "-".join(("help", *(path or ("learnblock",))))


def _option_code(path: tuple[str, ...], option: click.Option) -> str:
    return f"{_command_code(path)}-with-{option.opts[0].removeprefix('--')}"


def _common(english: str) -> str:
    return words(COMMON_CODES[english])


def words(code: str, **values: str) -> str:
    """The words of a code of ``help.ftl`` in the reader's language."""
    from learnblock.i18n import Phrase, translate  # noqa: PLC0415 - English `--help` needs none

    return translate(Phrase(code, **values), language())
