"""`learnblock class`: a class in one room, whose pupils join by a word."""

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.console import say, text
from learnblock.errors import LearnBlockError

if TYPE_CHECKING:
    from learnblock.classroom.hub_class import HubService
    from learnblock.i18n import Phrase


@click.command("class")
@click.argument("name")
@click.option(
    "--folder",
    type=click.Path(path_type=Path, file_okay=False),
    help="Where the class is kept  [default: classes/NAME in your own folder]",
)
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    help="Listen on this port  [default: 8421, or a free one if that is taken]",
)
@click.option("--host", metavar="ADDRESS", help="Listen on this address  [default: 0.0.0.0]")
@click.option(
    "--allow-host",
    "allowed_hosts",
    metavar="NAME",
    multiple=True,
    help="A name that the network uses for this computer.",
)
@click.option("--tls", is_flag=True, help="Use HTTPS, with a certificate made for the class.")
@click.option("--no-browser", is_flag=True, help="Only print the addresses.")
@click.option(
    "--hub",
    metavar="ADDRESS",
    help="Be a service of JupyterHub, whose proxy has this address; only the hub starts it so.",
)
@click.option("--pupils", metavar="GROUP", help="With --hub: the group of the pupils.")
@click.option("--teachers", metavar="GROUP", help="With --hub: the group of the teachers.")
@click.option("--delete", is_flag=True, help="Delete the class with everything its pupils made.")
def class_command(name: str, folder: Path | None, *, delete: bool, **choices: Any) -> None:
    """Open a class: pupils join it by a word, from any device in the room.

    It prints the address for pupils and the join word, and opens the teacher's wall. Each pupil has
    a first name and four pictures instead of an account, and a LearnBlock of their own on this
    computer. Ctrl-C saves everything and closes the class; the same command opens it again.

    \b
    learnblock class 7b
    learnblock class 7b --tls
    """  # noqa: D301 - click wants the character itself
    from learnblock.classroom.roster import class_folder  # noqa: PLC0415 - `--help` needs it not

    folder = folder or class_folder(name)
    if delete:
        _delete(name, folder)
    else:
        _open(name, folder, **choices)


def _open(
    name: str,
    folder: Path,
    *,
    host: str | None,
    port: int | None,
    tls: bool,
    no_browser: bool,
    allowed_hosts: tuple[str, ...],
    **at_hub: str | None,
) -> None:
    if sys.platform == "win32":
        raise LearnBlockError("class-not-on-windows")
    # `--help` needs none of these.
    from learnblock.classroom.certificate import own_certificate  # noqa: PLC0415
    from learnblock.classroom.offers import lesson_offers  # noqa: PLC0415
    from learnblock.classroom.own_classes import claimed  # noqa: PLC0415
    from learnblock.classroom.roster import Roster  # noqa: PLC0415
    from learnblock.classroom.serve import EVERYWHERE, ClassService, serve_class  # noqa: PLC0415
    from learnblock.server.serve import show_in_browser  # noqa: PLC0415

    hub = _hub(name, **at_hub)
    if hub:
        host, port = hub.listen
    with claimed(folder, name) as writer:
        roster = Roster(folder, name)
        offers, problems = lesson_offers()
        for problem in problems:
            click.echo(text(problem), err=True)
        service = ClassService(
            roster,
            writer,
            _announce,
            offers,
            host=host or EVERYWHERE,
            port=port,
            certificate=own_certificate(folder) if tls else None,
            allowed_hosts=allowed_hosts,
            hub=hub,
        )
        serve_class(service, show=None if no_browser or hub else show_in_browser)


def _hub(
    name: str, *, hub: str | None, pupils: str | None, teachers: str | None
) -> "HubService | None":
    if hub is None:
        return None
    from learnblock.classroom.hub_class import HubService  # noqa: PLC0415 - see above

    return HubService.of(os.environ, hub, pupils or name, teachers or f"teachers-{name}")


def _delete(name: str, folder: Path) -> None:
    from learnblock.classroom.own_classes import remove  # noqa: PLC0415 - see above
    from learnblock.classroom.roster import require_class  # noqa: PLC0415 - see above

    require_class(folder, name)
    click.confirm(text(_question(name)), abort=True)
    remove(folder, name)
    say("class-deleted", title=name)


def _question(name: str) -> "Phrase":
    from learnblock.i18n import Phrase  # noqa: PLC0415 - see above

    return Phrase("class-delete", title=name)


def _announce(phrase: "Phrase") -> None:
    click.echo(text(phrase))
