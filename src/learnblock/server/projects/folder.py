"""The folder of a user's projects."""

import re
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Literal

from learnblock import language, robots
from learnblock.errors import (
    Diagnostic,
    LearnBlockError,
    ProgramError,
    ProjectError,
    UnknownNameError,
)
from learnblock.files import save
from learnblock.language.python import ROBOT_IMPORT
from learnblock.running import DEFAULT_ROBOT
from learnblock.server.messages import PastRun, ProjectEntry, Version
from learnblock.server.projects.history import History, Reason
from learnblock.server.projects.project_file import (
    ENDING,
    LARGEST,
    LONGEST_NAME,
    Project,
    checked_name,
    decode,
    encode,
)

__all__ = ["Format", "Project", "ProjectFolder"]

Format = Literal["bt", "py", "learnblock"]

_NOT_IN_NAMES = re.compile(r"[^\w .-]+")


@dataclass(frozen=True)
class ProjectFolder:
    """Projects as files of a folder, with their history and what was deleted beside them.

    Args:
        path: need not exist yet.
        now: seconds since 1970.
    """

    path: Path
    now: Callable[[], float] = time.time

    def entries(self) -> tuple[ProjectEntry, ...]:
        """Every project, the last changed first."""
        return tuple(sorted(self._entries(), key=lambda entry: entry.changed, reverse=True))

    def read(self, name: str) -> Project:
        """A project.

        Raises:
            UnknownNameError: there is none of that name.
            ProjectError: its file is wrong or cannot be read.
        """
        path = self._path(name)
        if not path.is_file():
            raise UnknownNameError("project", name, self._names())
        with _told(path, "the project cannot be read"), path.open("rb") as file:
            return decode(file.read(LARGEST + 1), path.stem)

    def write(self, project: Project) -> None:
        """Save a project, as a whole or not at all.

        Raises:
            ProjectError: it cannot be saved; what was saved before is as it was.
        """
        path = self._path(project.name)
        with _told(path, "the project cannot be saved"):
            save(path, encode(project))

    def free_name(self, wish: str) -> str:
        """A name like `wish` that a project can have and none has."""
        plain = _plain(wish)
        # Windows and macOS take two names for one that differ only in capitals.
        taken = {name.casefold() for name in self._names()}
        names = (plain, *(f"{plain} {number}" for number in range(2, len(taken) + 3)))
        return next(name for name in names if name.casefold() not in taken)

    def delete(self, name: str) -> None:
        """Put a project and its history into the folder's trash, ``.trash``.

        Raises:
            UnknownNameError: there is none of that name.
            ProjectError: it cannot be moved there.
        """
        path = self._path(name)
        if not path.is_file():
            raise UnknownNameError("project", name, self._names())
        moment = datetime.fromtimestamp(self.now(), UTC).strftime("%Y-%m-%d %H.%M.%S.%f")
        trash = self.path / ".trash" / f"{path.stem} {moment}"
        with _told(path, "the project cannot be deleted"):
            trash.mkdir(parents=True)
            path.replace(trash / path.name)
            history = self._history(name).folder
            if history.is_dir():
                history.replace(trash / "history")

    def import_file(self, filename: str, text: str) -> Project:
        """A project of a file's text, under a free name; it is not written yet.

        Args:
            filename: ends in .bt, .py or .learnblock.
            text: may have mistakes if it is a program.

        Raises:
            ProjectError: it is no such file, or a wrong project.
        """
        stem, _, ending = filename.replace("\\", "/").rpartition("/")[2].rpartition(".")
        text = text.removeprefix("\ufeff").replace("\r\n", "\n")
        name = self.free_name(stem)
        if ending == "bt":
            return Project(name, text)
        if ending == "py":
            return _from_python(name, text)
        if f".{ending}" != ENDING:
            message = "this is no program: .bt, .py and .learnblock files are"
            raise ProjectError(filename, [Diagnostic("unknown-file", message)])
        return replace(decode(text.encode("utf-8", "replace"), stem), name=name)

    def export(self, project: Project, format_: Format) -> tuple[str, str]:
        """The name and the text of a file of a project.

        Raises:
            ProgramError: Python is asked for and the program has mistakes.
            ProjectError: the project cannot be written as a file.
        """
        if format_ == "bt":
            text = project.blocktext
        elif format_ == "py":
            text = project.python if project.python is not None else _python(project)
        else:
            text = encode(project).decode()
        return f"{project.name}.{format_}", text

    # What was.

    def keep_version(self, project: Project, reason: Reason) -> str:
        """Keep a version of a project, unless the last is the same; answer its id.

        Raises:
            ProjectError: it cannot be kept.
        """
        with _told(self._path(project.name), "the version cannot be kept"):
            return self._history(project.name).keep(project, reason)

    def versions(self, name: str) -> tuple[Version, ...]:
        """The versions of a project, the newest first."""
        return self._history(name).versions()

    def read_version(self, name: str, version: str) -> Project:
        """A version of a project.

        Raises:
            UnknownNameError: it is not kept.
            ProjectError: its file is damaged.
        """
        with _told(self._path(name), "the version cannot be read"):
            return self._history(name).read(version)

    def add_run(self, name: str, run: PastRun) -> None:
        """Keep how a run went.

        Raises:
            ProjectError: it cannot be kept.
        """
        with _told(self._path(name), "the run cannot be kept"):
            self._history(name).add_run(run)

    def runs(self, name: str) -> tuple[PastRun, ...]:
        """The last runs of a project, the newest first."""
        with _told(self._path(name), "its runs cannot be read"):
            return self._history(name).runs()

    def _history(self, name: str) -> History:
        name = checked_name(name)
        return History(name, self.path / ".history" / name, self.now)

    def _path(self, name: str) -> Path:
        return self.path / (checked_name(name) + ENDING)

    def _entries(self) -> Iterator[ProjectEntry]:
        for path in self.path.glob("*" + ENDING):
            # What another program put there is called as it likes, and may be gone by now.
            with suppress(OSError, ProjectError):
                yield ProjectEntry(checked_name(path.stem), path.stat().st_mtime)

    def _names(self) -> list[str]:
        return sorted(entry.name for entry in self._entries())


def _plain(wish: str) -> str:
    """A name that a project can have."""
    short = _NOT_IN_NAMES.sub(" ", wish).encode("utf-8", "ignore")[: LONGEST_NAME - 10]
    try:
        return checked_name(short.decode("utf-8", "ignore").strip(" ._-"))
    except ProjectError:
        return "program"


def _from_python(name: str, text: str) -> Project:
    """A project of a Python file, which may be wrong."""
    module = ROBOT_IMPORT.search(text)
    robot = _robot_of(module[1]) if module else DEFAULT_ROBOT
    try:
        blocktext = language.format(language.from_python(text))
    except ProgramError:
        # The page shows the mistakes in the Python itself.
        blocktext = ""
    return Project(name, blocktext, text, robot=robot)


def _robot_of(module: str) -> str:
    try:
        return robots.find(module).name
    except LearnBlockError:
        # A robot that is not here: the program can still be read, and run on another one.
        return DEFAULT_ROBOT


def _python(project: Project) -> str:
    tree = language.parse(project.blocktext, f"{project.name}.bt")
    return language.to_python(tree, robots.module_of(project.robot)).text


@contextmanager
def _told(path: Path, what: str) -> Iterator[None]:
    """Tell what the system refuses in a sentence of ours."""
    try:
        yield
    except OSError as error:
        reason = f"{what} in {path.parent}: {error.strerror or error}"
        raise ProjectError(path.name, [Diagnostic("no-access", reason)]) from error
