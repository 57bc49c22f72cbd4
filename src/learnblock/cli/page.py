"""The commands that open the page: `open`, and `dev` for its developers."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.console import say, text
from learnblock.cli.importing import print_report
from learnblock.cli.page_options import page_options
from learnblock.errors import LearnBlockError

if TYPE_CHECKING:
    from learnblock.cli.running_server import RunningServer
    from learnblock.i18n import Phrase
    from learnblock.project.files.folder import Project, ProjectFolder
    from learnblock.server.catalog.classes import ClassShelf


class FileOrLink(click.Path):
    """A file that exists, or a link that holds a project."""

    def __init__(self) -> None:
        super().__init__(path_type=Path, exists=True, dir_okay=False)

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> Path | str:
        """The path of a file, or a link without its address."""
        from learnblock.project.files import share_link  # noqa: PLC0415 - `--help` needs none of it

        if not share_link.is_link(value):
            return Path(str(super().convert(value, param, ctx)))
        share_link.read_link(value)
        return share_link.bare(value)


@click.command("open")
@click.argument("file", type=FileOrLink(), metavar="FILE|LINK")
@page_options
def open_command(file: Path | str, **choices: Any) -> None:
    """Open a program (.learnblock, .bt or .py), or a shared link, in the page.

    A file from elsewhere becomes a project in the projects folder; the file itself stays unchanged.
    Projects of the original LearnBlock (.blockProject) are imported: see learnblock import.
    """
    if isinstance(file, Path):
        open_page(file, **choices)
    else:
        open_page(None, link=file, **choices)


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
    link: str | None = None,
    projects: Path | None,
    no_browser: bool,
    window: bool,
    take_over: bool,
    read_only: bool,
    **place: Any,
) -> None:
    """Show the page: of this user's server if one uses the folder, else of a new one.

    Args:
        file: the program to open, if any.
        link: the link of a project to open instead.
        projects: the projects folder; None for the default.
        no_browser: only print the page's address.
        window: show the page in a separate window.
        take_over: let another server that uses the folder end.
        read_only: save nothing.
        place: the address where the server listens.
    """
    from learnblock.cli.claiming import claimed  # noqa: PLC0415
    from learnblock.project.files.writer import Access  # noqa: PLC0415
    from learnblock.server import serve  # noqa: PLC0415
    from learnblock.storage.home import home  # noqa: PLC0415 - `--help` needs none of it

    folder = projects or home() / "projects"
    options = {name: value for name, value in place.items() if value is not None}
    joins = not any(value for name, value in options.items() if name != "port")
    with claimed(folder, take_over=take_over, read_only=read_only, joins=joins) as access:
        if not isinstance(access, Access):
            _join(access, folder, file or link, no_browser=no_browser, window=window)
            return
        project = _project(folder, file, read_only=access.read_only is not None) if file else None
        service = serve.Service(
            folder,
            project=project,
            link=link,
            announce=_announce,
            access=access,
            classes=_own_classes,
            **options,
        )
        if window:
            serve.serve_in_window(service)
        else:
            serve.serve(service, show=None if no_browser else serve.show_in_browser)


def _join(
    running: "RunningServer",
    folder: Path,
    file: Path | str | None,
    *,
    no_browser: bool,
    window: bool,
) -> None:
    """Show the page of a server that is already running, and let it take in a file or a link."""
    from learnblock.server import serve  # noqa: PLC0415 - `--help` needs none of it

    if isinstance(file, Path):
        address = running.page(_opened(folder, file, running.add))
    else:
        address = running.page(link=file)
    say("server-running", address=address)
    if window:
        serve.show_in_window(address)
    elif not no_browser:
        serve.show_in_browser(address)


def _own_classes() -> "ClassShelf":
    from learnblock.classroom.own_classes import OwnClasses  # noqa: PLC0415 - after the start

    return OwnClasses()


def _announce(phrase: "Phrase") -> None:
    click.echo(text(phrase))


def _project(folder: Path, file: Path, *, read_only: bool) -> str:
    """The project of a file, which a server that only reads can't add."""
    from learnblock.project.files.folder import ProjectFolder  # noqa: PLC0415

    def add(project: "Project") -> str:
        return ProjectFolder(folder).add(project).name

    def refuse(_: "Project") -> str:
        raise LearnBlockError("server-open-read-only", name=file.name)

    return _opened(folder, file, refuse if read_only else add)


def _opened(folder: Path, file: Path, add: Callable[["Project"], str]) -> str:
    """The name of the project of a file; one from elsewhere becomes a new project.

    Args:
        folder: the projects folder.
        file: the file.
        add: saves a new project, and returns the name of the project.
    """
    from learnblock import importing, running  # noqa: PLC0415
    from learnblock.project.files.folder import ProjectFolder  # noqa: PLC0415

    projects = ProjectFolder(folder)
    if file.suffix.lower() == ".learnblock" and file.resolve().parent == folder.resolve():
        return projects.read(file.stem).name
    if file.suffix.lower() in {importing.ENDING.lower(), importing.LIBRARY_ENDING}:
        return add(_original(projects, file))
    return add(projects.import_file(file.name, running.read_text(file)))


def _original(projects: "ProjectFolder", file: Path) -> "Project":
    """A project of the original LearnBlock; what changed is listed."""
    from learnblock import importing  # noqa: PLC0415

    with file.open("rb") as opened:
        data = opened.read(importing.LARGEST + 1)
    find_library = partial(importing.find_library, file.parent)
    project, report = projects.import_original(file.name, data, find_library)
    print_report(report)
    return project
