"""The history of a project: its versions, its runs and its last picture."""

import re
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal, cast

import msgspec
from msgspec import Struct

from learnblock.errors import UnknownNameError
from learnblock.project.files import ENDING
from learnblock.project.files.carried import NOTHING
from learnblock.project.files.project import Project
from learnblock.project.files.project_file import LARGEST, decode, encode
from learnblock.storage.files import save

Reason = Literal["run", "time", "restored", "outside", "conflict"]

MOST_VERSIONS = 100
_NOWHERE_ELSE: tuple[Reason, ...] = ("conflict", "outside")
MOST_RUNS = 200

#: The time in milliseconds since 1970, the reason for the version, its number of lines.
_ID = re.compile(r"(\d{13,15})-(run|time|restored|outside|conflict)-(\d{1,7})")


class Version(Struct, frozen=True):
    """A version of the program to restore.

    Args:
        id: the id for `Restore`.
        time: the time in seconds since 1970.
        reason: why it was saved.
        lines: the number of lines of its Block-Text.
    """

    id: str
    time: float
    reason: Reason
    lines: int


class PastRun(Struct, frozen=True):
    """A run of the program: see `Ended`."""

    time: float
    robot: str
    world: str
    ended: str
    seconds: float
    goals: tuple[str, ...]
    trace_sha256: str
    version: str


_read_runs = msgspec.json.Decoder(list[PastRun]).decode


# Why: docs/decisions.md, "A kept version is a file, not a number of the log of revisions"
@dataclass(frozen=True)
class History:
    """The versions, runs and picture of one project, in one folder.

    Args:
        name: the name of the project.
        folder: the folder, which may not exist yet.
        now: returns the time in seconds since 1970.
    """

    name: str
    folder: Path
    now: Callable[[], float] = time.time

    def keep(self, project: Project, reason: Reason) -> str:
        """Save a version unless the last one is the same; return its id.

        Raises:
            ProjectError: it can't be written as a file.
            OSError: the folder can't be written to.
        """
        # Only the program of a version is restored.
        data = encode(replace(project, carried=NOTHING))
        return self.keep_file(data, reason, project.blocktext.count("\n") + 1)

    def keep_file(self, data: bytes, reason: Reason, lines: int) -> str:
        """Save a project's file as a version, even a damaged one, as `keep` does.

        Raises:
            OSError: the folder can't be written to.
        """
        before = self.versions()
        if before and self._path(before[0].id).read_bytes() == data:
            return before[0].id
        version = self._new_id(before, reason, lines)
        save(self._path(version), data)
        self._thin_out()
        return version

    def versions(self) -> tuple[Version, ...]:
        """List the versions, the newest first."""
        parsed = (_version(path.stem) for path in self.folder.glob(f"*{ENDING}"))
        versions = (version for version in parsed if version is not None)
        return tuple(sorted(versions, key=lambda version: version.time, reverse=True))

    def read(self, version: str) -> Project:
        """Read a version.

        Raises:
            UnknownNameError: it does not exist.
            ProjectError: its file is damaged.
        """
        ids = [entry.id for entry in self.versions()]
        if version not in ids:
            raise UnknownNameError("version", version, ids[:5])
        with self._path(version).open("rb") as file:
            return decode(file.read(LARGEST + 1), self.name)

    def add_run(self, run: PastRun) -> None:
        """Save the result of a run.

        Raises:
            OSError: the folder can't be written to.
        """
        runs = [run, *self.runs()][:MOST_RUNS]
        lines = b",\n".join(map(msgspec.json.encode, runs))
        save(self._runs, b"[\n" + lines + b"\n]\n")

    def runs(self) -> tuple[PastRun, ...]:
        """List the last runs, the newest first."""
        try:
            return tuple(_read_runs(self._runs.read_bytes()))
        except FileNotFoundError:
            return ()
        except (msgspec.MsgspecError, RecursionError):
            # A damaged list of runs must not prevent the next run.
            return ()

    def keep_picture(self, jpeg: bytes) -> None:
        """Save a picture of the project.

        Raises:
            OSError: the folder can't be written to.
        """
        save(self.picture, jpeg)

    @property
    def picture(self) -> Path:
        """The path of the project's picture, which it may not have."""
        return self.folder / "picture.jpg"

    @property
    def _runs(self) -> Path:
        return self.folder / "runs.json"

    def _path(self, version: str) -> Path:
        return self.folder / (version + ENDING)

    def _new_id(self, before: tuple[Version, ...], reason: Reason, lines: int) -> str:
        moment = int(self.now() * 1000)
        if before:
            # Versions stay in order even when the clock is set back.
            moment = max(moment, round(before[0].time * 1000) + 1)
        return f"{moment:013}-{reason}-{lines}"

    def _thin_out(self) -> None:
        versions = list(self.versions())
        while len(versions) > MOST_VERSIONS:
            least = versions.pop(_least_missed(versions))
            self._path(least.id).unlink(missing_ok=True)


def _version(id_: str) -> Version | None:
    match = _ID.fullmatch(id_)
    if match is None:
        return None
    reason = cast("Reason", match[2])
    return Version(id=id_, time=int(match[1]) / 1000, reason=reason, lines=int(match[3]))


def _least_missed(versions: list[Version]) -> int:
    """Choose the version whose removal leaves the smallest gap for its age.

    The first and the last version stay. Recent versions are thus dense, and old ones sparse. What
    a conflict has kept out of the program goes last, because it is nowhere else.
    """
    times = [version.time for version in versions]

    def gap(index: int) -> tuple[bool, float]:
        size = (times[index - 1] - times[index + 1]) / (times[0] - times[index] + 1)
        return versions[index].reason in _NOWHERE_ELSE, size

    return min(range(1, len(times) - 1), key=gap)
