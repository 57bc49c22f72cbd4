"""The folder of a user's projects."""

import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Self

from learnblock.errors import (
    Diagnostic,
    ProjectError,
    SettingsError,
    UnknownNameError,
    shortage,
)
from learnblock.i18n import Phrase
from learnblock.project.files import ENDING
from learnblock.project.files.exchange import project_of, project_of_original
from learnblock.project.files.history import History, PastRun, Reason, Version
from learnblock.project.files.kept_runs import KeptRuns
from learnblock.project.files.lesson_folder import LessonFolder
from learnblock.project.files.names import names_like
from learnblock.project.files.packing import encode_whole
from learnblock.project.files.picture import LARGEST_PICTURE, PictureError, check_picture
from learnblock.project.files.project import (
    Project,
    ProjectEntry,
    checked_name,
)
from learnblock.project.files.project_file import LARGEST, decode, encode
from learnblock.project.files.shared_record import SharedRecord, keep_record, read_record
from learnblock.running import forbid_network, move_network
from learnblock.storage.files import save

if TYPE_CHECKING:
    from learnblock.importing import FindLibrary, ImportReport

__all__ = ["FileState", "Project", "ProjectFolder"]


class FileChangedError(Exception):
    """Another program has changed a file since it was read or written last."""


@dataclass(frozen=True)
class FileState:
    """What distinguishes versions of a file without reading them."""

    inode: int
    changed: int
    size: int

    @classmethod
    def of(cls, status: os.stat_result) -> Self:
        """The state of a file with this status."""
        return cls(status.st_ino, status.st_mtime_ns, status.st_size)


@dataclass(frozen=True)
class ProjectFolder:
    """Projects as files in a folder, with their history and a trash folder.

    Args:
        path: the path of the folder, which may not exist yet.
        now: returns the time in seconds since 1970.
        read_only: whether everything that would write is refused.
    """

    path: Path
    now: Callable[[], float] = time.time
    read_only: bool = False

    def entries(self) -> tuple[ProjectEntry, ...]:
        """List the projects, the last changed first."""
        return tuple(sorted(self._entries(), key=lambda entry: entry.changed, reverse=True))

    def read(self, name: str) -> Project:
        """Read a project.

        Raises:
            UnknownNameError: it does not exist.
            ProjectError: its file is invalid or can't be read.
        """
        path = self._path(name)
        if not path.is_file():
            raise UnknownNameError("project", name, self._names())
        with _reporting(path, "read"), path.open("rb") as file:
            return decode(file.read(LARGEST + 1), path.stem)

    def write(self, project: Project) -> None:
        """Save a project completely or not at all.

        Raises:
            ProjectError: it can't be saved; the file is unchanged.
        """
        self._require_writing()
        path = self._path(project.name)
        with _reporting(path, "save"):
            save(path, encode(project))

    def add(self, project: Project) -> Project:
        """Save a new project under a free name, and return it with that name.

        Raises:
            ProjectError: it can't be saved.
        """
        self._require_writing()
        new_project = replace(project, name=self.free_name(project.name))
        # A file with this name that was deleted by hand may have been allowed the network. While
        # the settings have a mistake, no program is.
        with suppress(SettingsError):
            forbid_network(self._path(new_project.name))
        self.write(new_project)
        return new_project

    def file(self, name: str) -> Path:
        """The path of a project's file, which may not exist."""
        return self._path(name)

    def write_whole(self, project: Project, last_state: FileState | None) -> FileState:
        """Save a project with everything of the user's that it needs, completely or not at all.

        Args:
            project: the project.
            last_state: the state of its file as read or written last.

        Returns:
            The new state.

        Raises:
            FileChangedError: another program has changed the file, which stays as it is.
            ProjectError: it can't be saved; the file is unchanged.
        """
        self._require_writing()
        path = self._path(project.name)
        with _reporting(path, "save"):
            status = save(
                path,
                encode_whole(project),
                still_wanted=lambda: self.state(project.name) in (None, last_state),
            )
        if status is None:
            raise FileChangedError
        return FileState.of(status)

    def state(self, name: str) -> FileState | None:
        """The state of a project's file, which differs after any change; None without a file."""
        try:
            return FileState.of(self._path(name).stat())
        except OSError:
            return None

    def keep_file(self, name: str) -> str:
        """Save a project's file, as another program has left it, as a version; return its id.

        Raises:
            ProjectError: it can't be read or saved.
        """
        self._require_writing()
        path = self._path(name)
        with _reporting(path, "keep-version"), path.open("rb") as file:
            data = file.read(LARGEST + 1)
            return self._history(name).keep_file(data, "outside", _lines(data, name))

    def free_name(self, wish: str) -> str:
        """Find a free name like `wish`."""
        # They are compared without case, which Windows and macOS ignore in file names.
        names = {name.casefold() for name in self._names()}
        return next(name for name in names_like(wish) if name.casefold() not in names)

    def taken_names(self, wish: str) -> list[str]:
        """The names of projects that were created with this name, the first one first."""
        names = {name.casefold(): name for name in self._names()}
        candidates = (name.casefold() for name in names_like(wish))
        return [names[name] for name in takewhile(names.__contains__, candidates)]

    def rename(self, name: str, wish: str) -> None:
        """Rename a project's file and its history, both or neither.

        It keeps its permission to use the network.

        Raises:
            UnknownNameError: it does not exist.
            ProjectError: the new name is invalid or taken, or the file can't be renamed.
            SettingsError: the user's settings have a mistake.
        """
        self._require_writing()
        path, target = self._path(name), self._path(wish)
        if not path.is_file():
            raise UnknownNameError("project", name, self._names())
        # Windows and macOS ignore case in file names.
        others = {other.casefold() for other in self._names() if other != name}
        if wish.casefold() in others:
            message = Phrase("project-name-taken", name=wish)
            raise ProjectError(target.name, [Diagnostic("name-taken", message)])
        with _reporting(path, "rename"):
            path.rename(target)
            try:
                move_network(path, target)
                self._move_history(name, wish)
            except (OSError, SettingsError):
                target.rename(path)
                raise

    def _move_history(self, name: str, wish: str) -> None:
        old, new = self._history(name).folder, self._history(wish).folder
        if new.is_dir() and name.casefold() != wish.casefold():
            # A project whose file was deleted by hand has left it.
            new.replace(self._new_trash(wish) / "history")
        if old.is_dir():
            old.rename(new)

    def delete(self, name: str) -> None:
        """Move a project and its history into the trash folder, ``.trash``.

        A later project with this name may not use the network, even if this one may.

        Raises:
            UnknownNameError: it does not exist.
            ProjectError: it can't be moved.
            SettingsError: the user's settings have a mistake.
        """
        self._require_writing()
        path = self._path(name)
        if not path.is_file():
            raise UnknownNameError("project", name, self._names())
        forbid_network(path)
        with _reporting(path, "delete"):
            trash = self._new_trash(path.stem)
            path.replace(trash / path.name)
            history = self._history(name).folder
            if history.is_dir():
                history.replace(trash / "history")

    def _new_trash(self, name: str) -> Path:
        moment = datetime.fromtimestamp(self.now(), UTC).strftime("%Y-%m-%d %H.%M.%S.%f")
        trash = self.path / ".trash" / f"{name} {moment}"
        trash.mkdir(parents=True)
        return trash

    def import_file(self, filename: str, text: str) -> Project:
        """Create a project from a file's text, under a free name; it is not saved yet.

        Raises:
            ProjectError: see `exchange.project_of`.
        """
        return self._freely_named(project_of(filename, text))

    def import_original(
        self, filename: str, data: bytes, find_library: "FindLibrary"
    ) -> "tuple[Project, ImportReport]":
        """Create a project from a file of the original LearnBlock, under a free name.

        Raises:
            FileError: see `exchange.project_of_original`.
        """
        project, report = project_of_original(filename, data, find_library)
        return self._freely_named(project), report

    def _freely_named(self, project: Project) -> Project:
        return replace(project, name=self.free_name(project.name))

    # History.

    def keep_version(self, project: Project, reason: Reason) -> str:
        """Save a version of a project unless the last one is the same; return its id.

        Raises:
            ProjectError: it can't be saved.
        """
        self._require_writing()
        with _reporting(self._path(project.name), "keep-version"):
            return self._history(project.name).keep(project, reason)

    def versions(self, name: str) -> tuple[Version, ...]:
        """List the versions of a project, the newest first."""
        return self._history(name).versions()

    def read_version(self, name: str, version: str) -> Project:
        """Read a version of a project.

        Raises:
            UnknownNameError: it does not exist.
            ProjectError: its file is damaged.
        """
        with _reporting(self._path(name), "read-version"):
            return self._history(name).read(version)

    def add_run(self, name: str, run: PastRun) -> None:
        """Save the result of a run.

        Raises:
            ProjectError: it can't be saved.
        """
        self._require_writing()
        with _reporting(self._path(name), "keep-run"):
            self._history(name).add_run(run)

    def runs(self, name: str) -> tuple[PastRun, ...]:
        """List the last runs of a project, the newest first."""
        with _reporting(self._path(name), "read-runs"):
            return self._history(name).runs()

    def kept_runs(self, name: str) -> KeptRuns:
        """The logs of a project's runs.

        Raises:
            ProjectError: no project can have this name.
        """
        return KeptRuns(self._history(name).folder / "runs", self.read_only, self.now)

    def lesson(self, name: str) -> LessonFolder:
        """How far a project has come in its lesson.

        Raises:
            ProjectError: no project can have this name.
        """
        return LessonFolder(name, self._history(name).folder, self.read_only)

    def shared(self, name: str) -> SharedRecord | None:
        """The link that a project was opened from; None if it was not."""
        return read_record(self._history(name).folder)

    def keep_shared(self, name: str, record: SharedRecord) -> None:
        """Save the link that a project was opened from, if anything may be saved.

        Raises:
            ProjectError: it can't be saved.
        """
        if not self.read_only:
            with _reporting(self._path(name), "save"):
                keep_record(self._history(name).folder, record)

    # Pictures.

    def keep_picture(self, name: str, jpeg: bytes) -> None:
        """Keep a picture of a project instead of the one before.

        Raises:
            PictureError: it is not such a picture.
            ProjectError: it can't be saved.
        """
        self._require_writing()
        check_picture(jpeg)
        with _reporting(self._path(name), "save"):
            self._history(name).keep_picture(jpeg)

    def copy_picture(self, name: str, copy: str) -> None:
        """Give a copy of a project its picture, if it has one.

        Raises:
            ProjectError: it can't be saved.
        """
        self._require_writing()
        with _reporting(self._path(copy), "save"), suppress(FileNotFoundError):
            self._history(copy).keep_picture(self._history(name).picture.read_bytes())

    def picture(self, name: str) -> bytes | None:
        """The picture of a project; None if it has none."""
        try:
            with self._history(name).picture.open("rb") as file:
                jpeg = file.read(LARGEST_PICTURE + 1)
            check_picture(jpeg)
        except (OSError, PictureError):
            # Another program may have put any file there.
            return None
        return jpeg

    def _picture_taken(self, name: str) -> float:
        """When a project's picture was taken, in seconds since 1970; 0 if it has none."""
        try:
            return self._history(name).picture.stat().st_mtime
        except OSError:
            return 0.0

    def _require_writing(self) -> None:
        if self.read_only:
            raise ProjectError(
                self.path.name, [Diagnostic("no-access", Phrase("server-read-only"))]
            )

    def _history(self, name: str) -> History:
        name = checked_name(name)
        return History(name, self.path / ".history" / name, self.now)

    def _path(self, name: str) -> Path:
        return self.path / (checked_name(name) + ENDING)

    def _entries(self) -> Iterator[ProjectEntry]:
        for path in self.path.glob("*" + ENDING):
            # Another program may just have created or deleted the file.
            with suppress(OSError, ProjectError):
                name = checked_name(path.stem)
                yield ProjectEntry(name, path.stat().st_mtime, self._picture_taken(name))

    def _names(self) -> list[str]:
        return sorted(entry.name for entry in self._entries())


def _lines(data: bytes, name: str) -> int:
    """The lines of a project's program; 0 for a damaged file."""
    try:
        return decode(data, name).blocktext.count("\n") + 1
    except ProjectError:
        return 0


@contextmanager
def _reporting(path: Path, action: str) -> Iterator[None]:
    """Report an action refused by the operating system."""
    try:
        yield
    except OSError as error:
        lack = shortage(error)
        reason = lack or error.strerror or str(error)
        message = Phrase("project-no-access", action=action, folder=str(path.parent), reason=reason)
        code = "no-space" if lack else "no-access"
        raise ProjectError(path.name, [Diagnostic(code, message)]) from error
