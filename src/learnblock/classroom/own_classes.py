"""The teacher's classes on this computer: listed, opened, closed and deleted without a terminal."""

import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from learnblock.classroom import class_file
from learnblock.classroom.roster import (
    FILE,
    Roster,
    class_folder,
    classes_folder,
    known_folder,
    read_class,
    wall_address,
)
from learnblock.errors import LearnBlockError, phrase_of
from learnblock.project.files.writer import FolderClaim
from learnblock.server.messages import ClassEntry, StartClass

#: Seconds for a class to answer, and to save everything and end.
_STARTING, _ENDING = 30.0, 30.0
#: Seconds for all classes to end with the LearnBlock that has started them.
_FAREWELL = 10.0
#: Seconds between two looks whether a class answers.
_LOOK_AGAIN = 0.05
#: Characters of a failed class's last words.
_LONGEST_REASON = 300


class OwnClasses:
    """The classes in this user's folder, each of which is open in a process of its own.

    A class that was opened in a terminal is found like one that was started here: by its folder.
    """

    def __init__(self) -> None:
        self._started: dict[str, subprocess.Popen[bytes]] = {}

    def entries(self) -> tuple[ClassEntry, ...]:
        """All classes: the open ones first, then those that were used last."""
        folder = classes_folder()
        files = folder.glob(f"*/{FILE}") if folder.is_dir() else ()
        entries = [_entry(file.parent) for file in files]
        return tuple(sorted(entries, key=lambda entry: (not entry.wall, -entry.used)))

    def start(self, wanted: StartClass) -> str:
        """Open a class, a new one if there is none of this name; return the wall's address.

        Raises:
            LearnBlockError: the name is not possible, the file is damaged, or it does not open.
            OSError: the class's file can't be written.
        """
        if sys.platform == "win32":
            raise LearnBlockError("class-not-on-windows")
        folder = class_folder(wanted.title)
        file = read_class(folder)
        if file and (wall := _open_wall(folder, file.key)):
            return wall
        with claimed(folder, wanted.title):
            roster = Roster(folder, wanted.title)
            roster.prepare(wanted.lesson, wanted.project, wanted.blocks)
        return self._opened(roster, wanted.title)

    def close(self, title: str) -> None:
        """Have a class save everything and end.

        Raises:
            LearnBlockError: there is no such class, or it has not ended in time.
        """
        with FolderClaim(known_folder(title)) as writer:
            if not writer.take_over(_ENDING):
                raise LearnBlockError("class-does-not-end", title=title, seconds=int(_ENDING))
        if process := self._started.pop(title, None):
            process.wait(_ENDING)

    def delete(self, title: str) -> None:
        """Delete a class that is closed, with everything that its pupils have made.

        Raises:
            LearnBlockError: there is no such class, or it is open.
            OSError: some of it can't be deleted.
        """
        remove(known_folder(title), title)

    def pack(self, title: str, target: Path) -> None:
        """Write a class into one file, with which another computer opens it.

        Raises:
            LearnBlockError: there is no such class.
            OSError: a file can't be read or written.
        """
        class_file.pack(known_folder(title), target)

    def unpack(self, source: Path) -> str:
        """Take in a class from such a file, and return its name.

        Raises:
            FileError: it is no class.
            LearnBlockError: there is a class of this name.
            OSError: it can't be read or written.
        """
        return class_file.unpack(source)

    def end(self) -> None:
        """Have the classes that were started from here save everything and end."""
        processes = list(self._started.values())
        for process in processes:
            process.terminate()
        deadline = time.monotonic() + _FAREWELL
        for process in processes:
            # It saves by itself, so one that takes longer is not waited for.
            with suppress(subprocess.TimeoutExpired):
                process.wait(max(0.0, deadline - time.monotonic()))

    def _opened(self, roster: Roster, title: str) -> str:
        """Open a class in a process of its own; return the wall's address once it answers."""
        # -P: a file named learnblock.py in the folder that one works in is not ours.
        command = [sys.executable, "-P", "-m", "learnblock", "class", title, "--no-browser"]
        with tempfile.TemporaryFile() as errors:
            process = subprocess.Popen(  # noqa: S603 - our own command
                command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors
            )
            self._started[title] = process
            deadline = time.monotonic() + _STARTING
            while time.monotonic() < deadline and process.poll() is None:
                if wall := _described_wall(roster.folder, roster.key):
                    return wall
                time.sleep(_LOOK_AGAIN)
            process.terminate()
            process.wait(_ENDING)
            del self._started[title]
            raise LearnBlockError("class-not-started", title=title, reason=_last_words(errors))


def _entry(folder: Path) -> ClassEntry:
    title, path = folder.name, folder / FILE
    try:
        used = path.stat().st_mtime
        file = read_class(folder)
    except (LearnBlockError, OSError) as error:
        return ClassEntry(title, problem=phrase_of(error))
    if file is None:
        return ClassEntry(title)
    return ClassEntry(
        title,
        pupils=len(file.pupils),
        used=used,
        lesson=file.lesson,
        project=file.project,
        blocks=file.blocks,
        wall=_open_wall(folder, file.key) or "",
    )


def _open_wall(folder: Path, key: str) -> str | None:
    """The address of the wall of a class if it is open; a class that crashed is not."""
    wall = _described_wall(folder, key)
    return wall if wall and FolderClaim(folder).is_claimed else None


def _described_wall(folder: Path, key: str) -> str | None:
    """The address of a class's wall, as the server has described it that has the right to write."""
    owner = FolderClaim(folder).owner
    # Another user of the folder could write an address into it. The key is not sent there.
    if owner is None or not owner.is_here or not owner.knows(key):
        return None
    return wall_address(owner.address, key)


@contextmanager
def claimed(folder: Path, title: str) -> Iterator[FolderClaim]:
    """The right to write to the folder of a class, which is closed meanwhile elsewhere.

    Raises:
        LearnBlockError: the class is open.
    """
    with FolderClaim(folder) as writer:
        if not writer.claim():
            raise LearnBlockError("class-already-open", title=title)
        yield writer


def remove(folder: Path, title: str) -> None:
    """Delete the folder of a class.

    Raises:
        LearnBlockError: the class is open.
        OSError: some of it can't be deleted.
    """
    with claimed(folder, title):
        shutil.rmtree(folder)


def _last_words(errors: IO[bytes]) -> str:
    errors.seek(0)
    lines = errors.read().decode(errors="replace").strip().splitlines() or [""]
    return lines[-1][-_LONGEST_REASON:]
