"""The right to write to the folder of projects, and what to do if another server has it."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import click

from learnblock.cli.console import say, text, usage_error
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.project.files.writer import Access, FolderClaim

if TYPE_CHECKING:
    from learnblock.cli.running_server import RunningServer

#: Seconds for another server to end, which ends every program and saves every project first.
PATIENCE = 20.0
#: The answers to the question.
_TAKE_OVER, _READ_ONLY = 1, 2


@contextmanager
def claimed(
    folder: Path, *, take_over: bool, read_only: bool, joins: bool
) -> Iterator["Access | RunningServer"]:
    """Claim a folder of projects; if this user's server has it, give that, else ask what to do.

    Args:
        folder: the folder.
        take_over: let the other server end, without a question.
        read_only: only read, without a question.
        joins: whether the user's running server will do.

    Raises:
        LearnBlockError: another server uses the folder, and there is no terminal to ask on, or it
            does not end.
    """
    if take_over and read_only:
        raise usage_error("cli-take-over-or-read-only")
    with FolderClaim(folder) as writer:
        if read_only:
            yield Access.reading(writer)
        else:
            yield _access(writer, folder, take_over=take_over, joins=joins and not take_over)


def _access(
    writer: FolderClaim, folder: Path, *, take_over: bool, joins: bool
) -> "Access | RunningServer":
    try:
        if writer.claim():
            return Access(writer)
    except OSError as error:
        # Some network drives don't support locks, and some folders are read-only.
        reason = error.strerror or str(error)
        say("server-folder-unlocked", folder=str(folder), reason=reason, err=True)
        return Access()
    if joins and (running := _running(writer)):
        return running
    if not take_over and _answer(writer, folder) == _READ_ONLY:
        return Access.reading(writer)
    return _taken_over(writer, folder)


def _running(writer: FolderClaim) -> "RunningServer | None":
    from learnblock.cli.running_server import RunningServer  # noqa: PLC0415 - rarely needed

    return RunningServer.of(writer)


def _answer(writer: FolderClaim, folder: Path) -> int:
    """Ask what to do about the other server.

    Raises:
        LearnBlockError: there is no terminal to ask on.
    """
    conflict = Phrase("server-folder-used", folder=str(folder), owner=writer.owner_phrase)
    if not sys.stdin.isatty():
        raise LearnBlockError("server-folder-refused", used=conflict)
    click.echo(text(conflict))
    say("cli-folder-choices")
    answer: int = click.prompt(
        text(Phrase("cli-folder-choice")), type=click.IntRange(_TAKE_OVER, _READ_ONLY)
    )
    return answer


def _taken_over(writer: FolderClaim, folder: Path) -> Access:
    owner = writer.owner_phrase
    say("server-folder-waiting", owner=owner, seconds=int(PATIENCE), err=True)
    if not writer.take_over(PATIENCE):
        raise LearnBlockError("server-folder-kept", folder=str(folder), owner=writer.owner_phrase)
    return Access(writer)
