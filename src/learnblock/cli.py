"""The command line: the page, and the commands that need none, such as `learnblock run`.

Each command imports what it needs when it is called, so that `learnblock --help` answers at once.
"""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import click

from learnblock.commands.blocks import blocks_group
from learnblock.commands.libraries import library_group
from learnblock.commands.new import new_group
from learnblock.commands.perception import component_command, perception_group
from learnblock.commands.robots import emulate_command, robots_group
from learnblock.commands.sets import sets_command
from learnblock.commands.tags import tags_group
from learnblock.console import ExitCode, print_json
from learnblock.errors import Diagnostic, FileError, LearnBlockError
from learnblock.files import save

if TYPE_CHECKING:
    from learnblock.running import Source

_PROGRAM = click.argument("file", type=click.Path(path_type=Path, exists=True, dir_okay=False))
_JSON = click.option("--json", "as_json", is_flag=True, help="Print JSON, for tools.")
_ROBOT = click.option("--robot", metavar="NAME", help="Which robot: see `learnblock robots`.")


class _Commands(click.Group):
    """Our errors become one sentence and an exit code, never a traceback."""

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except FileError as error:
            _report_mistakes(error)
            ctx.exit(ExitCode.MISTAKES)
        except BrokenPipeError:
            # `learnblock skills | head`: click knows how to end quietly.
            raise
        except (LearnBlockError, OSError) as error:
            click.echo(f"learnblock: {error}", err=True)
            ctx.exit(ExitCode.USAGE)
        except KeyboardInterrupt:
            ctx.exit(ExitCode.INTERRUPTED)


def _page_options(command: Callable[..., None]) -> Callable[..., None]:
    """The options of whatever opens the page."""
    for option in reversed(_PAGE_OPTIONS):
        command = option(command)
    return command


_PAGE_OPTIONS = (
    click.option(
        "--port",
        type=click.IntRange(0, 65535),
        help="Listen at this port  [default: 8421, or a free one where that is taken]",
    ),
    click.option("--host", metavar="ADDRESS", help="Listen at this address  [default: 127.0.0.1]"),
    click.option("--no-browser", is_flag=True, help="Only print the address of the page."),
    click.option("--window", is_flag=True, help="Show the page in a window of its own."),
    click.option("--base-url", metavar="/PATH/", help="The path of the page behind a proxy."),
    click.option(
        "--allow-host",
        "allowed_hosts",
        metavar="NAME",
        multiple=True,
        help="A name by which a proxy, or the network, calls this machine.",
    ),
    click.option(
        "--unix-socket",
        type=click.Path(path_type=Path, dir_okay=False),
        help="Listen at this socket instead, for a proxy.",
    ),
    click.option(
        "--projects",
        type=click.Path(path_type=Path, file_okay=False),
        help="The folder of the projects.",
    ),
)


@click.group(
    cls=_Commands,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="Start with: learnblock. Or see what it does without a page: learnblock demo",
)
@click.version_option(package_name="learnblock-studio", prog_name="learnblock")
@_page_options
@click.pass_context
def main(ctx: click.Context, /, **choices: Any) -> None:
    """Program any robot in blocks, Block-Text or Python, and run it in a simulated world.

    Without a command it opens the page, with a token in its address that keeps others out.
    """
    if ctx.invoked_subcommand is None:
        _open_page(None, **choices)


@main.command("open")
@_PROGRAM
@_page_options
def open_command(file: Path, **choices: Any) -> None:
    """Open a program (.learnblock, .bt or .py) in the page.

    A file from elsewhere becomes a project in the folder of projects; the file stays as it is.
    """
    _open_page(file, **choices)


@main.command()
@_PROGRAM
@_ROBOT
@click.option("--world", metavar="NAME", help="Which world, or a world's file.")
@click.option("--seed", type=int, help="Seeds all noise; the same seed gives the same run.")
@click.option(
    "--pace",
    metavar="free|real|FACTOR",
    help="How fast: as fast as it goes (default), as in life, or so many times that.",
)
@click.option(
    "--for",
    "seconds",
    type=click.FloatRange(min=0, min_open=True),
    help="End after so many seconds of the robot's time  [default: 300 at pace free]",
)
@click.option(
    "--trace", type=click.Path(path_type=Path, dir_okay=False), help="Write the trace: JSON Lines."
)
@click.option(
    "--picture",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Draw world and path, as .png or .svg.",
)
@click.option("--anyway", is_flag=True, help="Run it although the robot lacks a device it asks.")
@_JSON
def run(file: Path, as_json: bool, **choices: Any) -> None:  # noqa: FBT001 - a flag of click
    """Run a program (.bt or .py) on a robot.

    \b
    learnblock run examples/square.bt --robot sim-ev3 --picture square.png
    learnblock run examples/line.bt --world line --for 60 --pace 5
    """  # noqa: D301 - click wants the character itself
    from learnblock.reporting import run_and_report  # noqa: PLC0415 - `--help` needs none of it

    sys.exit(run_and_report(file, as_json=as_json, **choices))


@main.command()
@click.option(
    "--picture", type=click.Path(path_type=Path, dir_okay=False), help="Where to draw it."
)
def demo(picture: Path | None) -> None:
    """Run the paper's reaction to tags on EBO's twin, and draw what it did."""
    from learnblock.reporting import demonstrate  # noqa: PLC0415

    sys.exit(demonstrate(picture or Path("learnblock-demo.png")))


@main.command()
@click.argument(
    "files",
    nargs=-1,
    required=True,
    type=click.Path(path_type=Path, exists=True, dir_okay=False),
    metavar="FILE...",
)
@_ROBOT
@_JSON
def check(files: tuple[Path, ...], robot: str | None, as_json: bool) -> None:  # noqa: FBT001
    """Say what is wrong or doubtful in programs, without running them.

    With --robot also what that robot lacks. Exits with 1 when there are errors; warnings alone are
    no failure.
    """
    found = {file: _diagnose(file, robot) for file in files}
    if as_json:
        print_json([_as_object(file, one) for file, (all_, _) in found.items() for one in all_])
    else:
        for file, (diagnostics, text) in found.items():
            _print_diagnostics(str(file), diagnostics, text)
    errors = [one for all_, _ in found.values() for one in all_ if one.severity == "error"]
    sys.exit(ExitCode.MISTAKES if errors else 0)


@main.command("format")
@click.argument(
    "files",
    nargs=-1,
    required=True,
    type=click.Path(path_type=Path, exists=True, dir_okay=False),
    metavar="FILE.bt...",
)
@click.option("--check", "only_check", is_flag=True, help="Change nothing; exit 1 if it would.")
@click.option("--stdout", "to_stdout", is_flag=True, help="Print the result, change nothing.")
@_JSON
def format_command(
    files: tuple[Path, ...],
    only_check: bool,  # noqa: FBT001 - a flag of click
    to_stdout: bool,  # noqa: FBT001
    as_json: bool,  # noqa: FBT001
) -> None:
    """Give Block-Text programs their canonical form: four spaces, one blank where one belongs."""
    changed = [file for file in files if _format(file, only_check=only_check, to_stdout=to_stdout)]
    if as_json:
        print_json({"changed": [str(file) for file in changed]})
    elif not to_stdout:
        for file in changed:
            click.echo(f"{'would change' if only_check else 'formatted'} {file}")
    sys.exit(ExitCode.MISTAKES if only_check and changed else 0)


@main.command()
@_PROGRAM
@click.option(
    "--to",
    "notation",
    required=True,
    type=click.Choice(["python", "block-text"]),
    help="The notation to convert to.",
)
@_ROBOT
@_JSON
def convert(file: Path, notation: str, robot: str | None, as_json: bool) -> None:  # noqa: FBT001
    """Translate a program between Block-Text and Python, to standard output.

    \b
    learnblock convert square.bt --to python --robot ev3 > square.py
    """  # noqa: D301 - click wants the character itself
    from learnblock import language, robots, running  # noqa: PLC0415

    source = running.read(file)
    if notation == "block-text":
        text = language.format(source.tree)
    else:
        chosen = robots.module_of(robot or running.DEFAULT_ROBOT)
        module = None if source.is_python and not robot else chosen
        text = language.to_python(source.tree, module).text
    if as_json:
        print_json({"file": str(file), "to": notation, "text": text})
    else:
        click.echo(text, nl=False)


@main.command()
@_JSON
def worlds(as_json: bool) -> None:  # noqa: FBT001
    """List the worlds of the simulator."""
    from learnblock.listing import world_list  # noqa: PLC0415

    world_list(as_json=as_json)


@main.command()
@click.argument("name", required=False)
@_JSON
def skills(name: str | None, as_json: bool) -> None:  # noqa: FBT001
    """List the skills: what each needs, says and does. NAME shows one of them."""
    from learnblock.listing import skill_list  # noqa: PLC0415

    skill_list(name, as_json=as_json)


main.add_command(robots_group)
main.add_command(emulate_command)
main.add_command(library_group)
main.add_command(new_group)
main.add_command(perception_group)
main.add_command(component_command)
main.add_command(tags_group)
main.add_command(sets_command)
main.add_command(blocks_group)


@main.command()
@click.option("--port", default=5173, show_default=True, help="Where Vite serves the page.")
def dev(port: int) -> None:
    """Serve the page with hot reload, for those who build it; it needs a checkout and Node.js."""
    from learnblock.server.dev import develop  # noqa: PLC0415

    develop(port)


def _open_page(
    file: Path | None,
    *,
    projects: Path | None,
    no_browser: bool,
    window: bool,
    **place: Any,
) -> None:
    from learnblock.home import home  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.server import serve  # noqa: PLC0415

    folder = projects or home() / "projects"
    project = _project(folder, file) if file else None
    chosen = {name: value for name, value in place.items() if value is not None}
    service = serve.Service(folder, project=project, **chosen)
    if window:
        serve.serve_in_window(service)
    else:
        serve.serve(service, show=None if no_browser else serve.show_in_browser)


def _project(folder: Path, file: Path) -> str:
    """The project of a file; one from elsewhere is copied."""
    from learnblock import running  # noqa: PLC0415
    from learnblock.server.projects.folder import ProjectFolder  # noqa: PLC0415

    projects = ProjectFolder(folder)
    if file.suffix == ".learnblock" and file.resolve().parent == folder.resolve():
        return projects.read(file.stem).name
    project = projects.import_file(file.name, running.read_text(file))
    projects.write(project)
    return project.name


def _diagnose(file: Path, robot: str | None) -> tuple[list[Diagnostic], str]:
    """A program's diagnostics, and its text for the caret."""
    from learnblock import robots, running  # noqa: PLC0415

    entry = robots.find(robot) if robot else None
    try:
        source: Source = running.read(file)
    except FileError as error:
        return list(error.diagnostics), error.source
    return running.check(source, entry), source.text


def _format(file: Path, *, only_check: bool, to_stdout: bool) -> bool:
    """Format one file; say whether that changes it."""
    from learnblock import language, running  # noqa: PLC0415

    if file.suffix != ".bt":
        _fail(f"{file}: format is for Block-Text (.bt); for Python use a Python formatter")
    source = running.read(file)
    text = language.format(source.tree)
    changed = text != source.text
    if to_stdout:
        click.echo(text, nl=False)
    elif changed and not only_check:
        save(file, text.encode())
    return changed


def _report_mistakes(error: FileError) -> None:
    _print_diagnostics(error.filename, list(error.diagnostics), error.source, err=True)


def _print_diagnostics(
    filename: str, diagnostics: list[Diagnostic], text: str, *, err: bool = False
) -> None:
    for diagnostic in diagnostics:
        click.echo(diagnostic.located(filename), err=err)
        if pointed := diagnostic.pointed(text):
            click.echo("    " + pointed.replace("\n", "\n    "), err=err)


def _as_object(file: Path, diagnostic: Diagnostic) -> dict[str, object]:
    return {
        "file": str(file),
        "line": diagnostic.line,
        "column": diagnostic.column,
        "end_column": diagnostic.end_column,
        "severity": diagnostic.severity,
        "code": diagnostic.code,
        "message": diagnostic.message,
    }


def _fail(message: str) -> NoReturn:
    click.echo(f"learnblock: {message}", err=True)
    sys.exit(ExitCode.USAGE)
