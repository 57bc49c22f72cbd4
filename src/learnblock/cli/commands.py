"""The group of all commands: each is imported when it is called, and its errors are reported."""

import importlib
from typing import Any, NamedTuple

import click

from learnblock.cli.console import ExitCode, print_diagnostics, say, text
from learnblock.cli.help_texts import Context, translated
from learnblock.cli.language import is_english
from learnblock.cli.usage_errors import reported_in_own_language


class CommandLocation(NamedTuple):
    """The location of a command.

    Args:
        module: in this package.
        name: of the command in its module.
        summary: the first sentence of its help, so that the list of all commands imports none.
    """

    module: str
    name: str
    summary: str


COMMANDS = {
    "blocks": CommandLocation(
        "blocks", "blocks_group", "List, check, export or import custom blocks"
    ),
    "calls": CommandLocation(
        "calls", "calls_command", "Show what called what in a run, and for how long"
    ),
    "class": CommandLocation(
        "classroom",
        "class_command",
        "Open a class: pupils join it by a word, from any device in the room",
    ),
    "check": CommandLocation(
        "programs", "check", "Check programs for mistakes without running them"
    ),
    "compare": CommandLocation("compare", "compare_command", "Show where two runs parted, and why"),
    "component": CommandLocation("perception", "component_command", "Serve a detector to RoboComp"),
    "convert": CommandLocation(
        "programs", "convert", "Convert a program between Block-Text and Python"
    ),
    "demo": CommandLocation(
        "programs", "demo", "Run a demonstration in the simulator, and draw it"
    ),
    "dev": CommandLocation("page", "dev", "Serve the page with hot reload, for its developers"),
    "doctor": CommandLocation(
        "doctor", "doctor_command", "Show what contains programs on this computer"
    ),
    "emulate": CommandLocation("robots", "emulate_command", "Emulate a robot to try its driver"),
    "format": CommandLocation("programs", "format_command", "Format Block-Text programs"),
    "grade": CommandLocation(
        "grade", "grade_command", "Grade a class's programs by a lesson's checks"
    ),
    "import": CommandLocation(
        "importing", "import_command", "Import programs of the original LearnBlock"
    ),
    "lesson": CommandLocation(
        "lessons", "lesson_group", "List, show, check, try, pack or print lessons"
    ),
    "library": CommandLocation(
        "libraries", "library_group", "Make, install or remove libraries of skills"
    ),
    "new": CommandLocation("new", "new_group", "Create the files of a new robot, skill or world"),
    "open": CommandLocation(
        "page",
        "open_command",
        "Open a program (.learnblock, .bt or .py), or a shared link, in the page",
    ),
    "perception": CommandLocation(
        "perception", "perception_group", "Show or change camera recognition"
    ),
    "picture": CommandLocation(
        "picture", "picture_command", "Draw a program's blocks as SVG or PNG"
    ),
    "replay": CommandLocation(
        "replay", "replay_command", "Check a trace's poses and goals by repeating it"
    ),
    "robots": CommandLocation(
        "robots", "robots_group", "List robots; configure, find or test real ones"
    ),
    "run": CommandLocation("programs", "run", "Run programs (.bt, .py or .learnblock) on robots"),
    "sets": CommandLocation("sets", "sets_command", "List the block sets"),
    "skills": CommandLocation("listing", "skills", "List the skills, or describe one"),
    "stubs": CommandLocation(
        "stubs", "stubs_command", "Tell editors about your own robots and skills"
    ),
    "tags": CommandLocation(
        "tags", "tags_group", "List, change, import, export or print tag names"
    ),
    "why": CommandLocation("why", "why_command", "Answer a question about a run"),
    "worlds": CommandLocation("listing", "worlds", "List the worlds of the simulator"),
}


class Commands(click.Group):
    """All commands; our errors become a message and an exit code, never a traceback."""

    context_class = Context

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002 - as click calls it
        return sorted(COMMANDS)

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:  # noqa: ARG002
        command = load(name)
        if command is None or is_english():
            return command
        return translated(command, (name,))

    def format_help(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        click.Group.format_help(self._shown(), ctx, formatter)

    def get_usage(self, ctx: click.Context) -> str:
        return click.Group.get_usage(self._shown(), ctx)

    def _shown(self) -> click.Command:
        return self if is_english() else translated(self, ())

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        if not is_english():
            super().format_commands(ctx, formatter)
            return
        with formatter.section("Commands"):
            formatter.write_dl([(name, COMMANDS[name].summary) for name in sorted(COMMANDS)])

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        with reported_in_own_language():
            return super().parse_args(ctx, args)

    def invoke(self, ctx: click.Context) -> Any:
        from learnblock.errors import FileError, LearnBlockError  # noqa: PLC0415 - `--help`

        try:
            with reported_in_own_language():
                return super().invoke(ctx)
        except FileError as error:
            print_diagnostics(error.filename, error.diagnostics, error.source, err=True)
            ctx.exit(ExitCode.MISTAKES)
        except BrokenPipeError:
            # `learnblock skills | head`: click knows how to end quietly.
            raise
        except LearnBlockError as error:
            click.echo(f"learnblock: {text(error.phrase)}", err=True)
            ctx.exit(ExitCode.USAGE)
        except OSError as error:
            _report_system_error(error)
            ctx.exit(ExitCode.USAGE)
        except KeyboardInterrupt:
            ctx.exit(ExitCode.INTERRUPTED)


def load(name: str) -> click.Command | None:
    """A command by its name, or None if there is no such command."""
    if name not in COMMANDS:
        return None
    place = COMMANDS[name]
    module = importlib.import_module(f"learnblock.cli.{place.module}")
    command: click.Command = getattr(module, place.name)
    return command


def _report_system_error(error: OSError) -> None:
    from learnblock.errors import shortage  # noqa: PLC0415 - `--help` needs none of it

    reason = shortage(error) or error.strerror or str(error)
    if error.filename is None:
        say("cli-system-error", reason=reason, err=True)
    else:
        say("cli-file-error", file=str(error.filename), reason=reason, err=True)
