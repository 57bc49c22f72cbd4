"""The pages that show a project."""

from collections.abc import Iterator
from typing import Protocol

from learnblock.server.messages import ToPage
from learnblock.server.runs.shown import ShownProgram


class Viewer(Protocol):
    """A page that shows a project."""

    #: The program as this page shows it.
    shown: ShownProgram
    #: Whether it has requested camera frames.
    watching: bool

    def send(self, message: ToPage, data: bytes | None = None) -> None:
        """Queue a message for the page, followed by `data`, if any."""


class Viewers:
    """The pages that currently show a project."""

    def __init__(self) -> None:
        self._viewers: list[Viewer] = []

    def __iter__(self) -> Iterator[Viewer]:
        return iter(tuple(self._viewers))

    def __bool__(self) -> bool:
        return bool(self._viewers)

    def add(self, viewer: Viewer) -> None:
        """Send a page everything that the others receive from now on."""
        self._viewers.append(viewer)

    def remove(self, viewer: Viewer) -> None:
        """Stop sending messages to a page."""
        self._viewers.remove(viewer)

    def send(self, message: ToPage) -> None:
        """Send a message to every page."""
        for viewer in self:
            viewer.send(message)
