"""What a project that was opened from a link remembers of it, beside its history."""

import hashlib
from pathlib import Path
from typing import Annotated, Self

import msgspec
from msgspec import Meta, Struct

from learnblock.project.files.project import Project
from learnblock.project.files.share_link import MOST_VARIANTS, ProvedRun
from learnblock.storage.files import save

#: The maximum size of the file in bytes.
_LARGEST = 16 * 1024


class ProgramState(Struct, frozen=True, forbid_unknown_fields=True):
    """Everything of a project that decides its runs.

    Args:
        program: a hash of its programs.
        robots: the kinds of its robots.
        world: the name of its world.
        variant: the number of the world's variant.
    """

    program: str
    robots: tuple[str, ...]
    world: str
    variant: Annotated[int, Meta(ge=0, le=MOST_VARIANTS)] = 0

    @classmethod
    def of(cls, project: Project, variant: int) -> Self:
        """The state of a project in a variant of its world."""
        texts = [(part.text, part.count) for part in project.parts]
        tags = sorted(project.tags.items())
        return cls(
            program=hashlib.sha256(msgspec.json.encode([texts, tags])).hexdigest(),
            robots=tuple(part.robot for part in project.parts),
            world=project.world,
            variant=variant,
        )


class SharedRecord(Struct, frozen=True, forbid_unknown_fields=True):
    """A link's run, and the project as it was when it was opened from the link."""

    state: ProgramState
    run: ProvedRun | None = None


_read = msgspec.json.Decoder(SharedRecord).decode


def keep_record(folder: Path, record: SharedRecord) -> None:
    """Save a record in the folder of a project's history.

    Raises:
        OSError: it can't be saved.
    """
    save(_path(folder), msgspec.json.encode(record))


def read_record(folder: Path) -> SharedRecord | None:
    """The record of a project; None if it was not opened from a link, or if the file is damaged."""
    try:
        with _path(folder).open("rb") as file:
            return _read(file.read(_LARGEST))
    except (OSError, msgspec.MsgspecError, RecursionError):
        # Another program may have put any file there.
        return None


def _path(folder: Path) -> Path:
    return folder / "shared.json"
