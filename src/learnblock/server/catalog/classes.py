"""The teacher's classes, as the page of *For teachers* reaches them."""

from pathlib import Path
from typing import Protocol

from learnblock.server.messages import ClassEntry, StartClass


class ClassShelf(Protocol):
    """The classes on this computer; the classroom implements it, which the server doesn't know.

    All methods may take seconds. They raise `LearnBlockError` if a class is unknown or its file is
    damaged, and `OSError` if a file can't be read or written.
    """

    def entries(self) -> tuple[ClassEntry, ...]:
        """All classes: the open ones first, then those that were used last."""

    def start(self, wanted: StartClass) -> str:
        """Open a class, a new one if there is none of this name; return the wall's address."""

    def close(self, title: str) -> None:
        """Have a class save everything and end."""

    def delete(self, title: str) -> None:
        """Delete a class that is closed, with everything that its pupils have made."""

    def pack(self, title: str, target: Path) -> None:
        """Write a class into one file, with which another computer opens it."""

    def unpack(self, source: Path) -> str:
        """Take in a class from such a file, and return its name."""

    def end(self) -> None:
        """Have the classes that were started from here save everything and end."""
