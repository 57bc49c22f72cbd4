"""The commands that open the page: `open`, and `dev` for its developers."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.console import text
from learnblock.cli.importing import print_report
from learnblock.cli.page_options import page_options

if TYPE_CHECKING:
    from learnblock.i18n import Phrase
    from learnblock.server.projects.folder import Project, ProjectFolder


@click.command("open")
@click.argument("file", type=click.Path(path_type=Path, exists=True, dir_okay=False))
@page_options
def open_command(file: Path, **choices: Any) -> None:
    """Open a program (.learnblock, .bt or .py) in the page.

    A file from elsewhere becomes a project in the projects folder; the file itself stays unchanged.
    Projects of the original LearnBlock (.blockProject) are imported: see learnblock import.
    """
    open_page(file, **choices)


@click.command()
@click.option("--port", default=5173, show_default=True, help="The port of the Vite server.")
def dev(port: int) -> None:
    """Serve the page with hot reload, for its developers.

    Needs a checkout of the sources and Node.js.
    """
    from learnblock.server.dev import develop  # noqa: PLC0415

    develop(port)


def open_page(
    file: Path | None,
    *,
    projects: Path | None,
    no_browser: bool,
    window: bool,
    **place: Any,
) -> None:
    """Start the server, and show the page.

    Args:
        file: the program to open, if any.
        projects: the projects folder; None for the default.
        no_browser: only print the page's address.
        window: show the page in a separate window.
        place: the address where the server listens.
    """
    from learnblock.server import serve  # noqa: PLC0415
    from learnblock.storage.home import home  # noqa: PLC0415 - `--help` needs none of it

    folder = projects or home() / "projects"
    project = _project(folder, file) if file else None
    chosen = {name: value for name, value in place.items() if value is not None}
    service = serve.Service(folder, project=project, announce=_announce, **chosen)
    if window:
        serve.serve_in_window(service)
    else:
        serve.serve(service, show=None if no_browser else serve.show_in_browser)


def _announce(phrase: "Phrase") -> None:
    click.echo(text(phrase))


def _project(folder: Path, file: Path) -> str:
    """The project of a file; a file from elsewhere is copied into the projects folder."""
    from learnblock import importing, running  # noqa: PLC0415
    from learnblock.server.projects.folder import ProjectFolder  # noqa: PLC0415

    projects = ProjectFolder(folder)
    if file.suffix == ".learnblock" and file.resolve().parent == folder.resolve():
        return projects.read(file.stem).name
    if file.suffix in {importing.ENDING, importing.LIBRARY_ENDING}:
        project = _original(projects, file)
    else:
        project = projects.import_file(file.name, running.read_text(file))
    projects.write(project)
    return project.name


def _original(projects: "ProjectFolder", file: Path) -> "Project":
    """A project of the original LearnBlock; what changed is listed."""
    from learnblock import importing  # noqa: PLC0415

    with file.open("rb") as opened:
        project, report = projects.import_original(file.name, opened.read(importing.LARGEST + 1))
    print_report(report)
    return project
