"""Everything that is kept about a pupil, or a class, in one file."""

import io
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path

import msgspec

from learnblock.classroom.hand_ins import FOLDER, HandInShelf
from learnblock.classroom.roster import Pupil, Roster


def export(roster: Roster, pupils: Iterable[Pupil]) -> bytes:
    """A zip file with each pupil's folder, hand-ins, and entry in the class's file.

    Raises:
        OSError: a file can't be read.
    """
    packed = io.BytesIO()
    hand_ins = HandInShelf(roster.folder)
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for pupil in pupils:
            top = f"{pupil.name}-{pupil.id}"
            # The PIN is left out: it gives access, and an export doesn't need it.
            about = {"name": pupil.name, "id": pupil.id, "joined": pupil.joined}
            archive.writestr(f"{top}/pupil.json", msgspec.json.encode(about))
            for path, name in files_in(roster.folder_of(pupil)):
                archive.write(path, f"{top}/{name}")
            for path, name in files_in(hand_ins.folder_of(pupil.id)):
                archive.write(path, f"{top}/{FOLDER}/{name}")
    return packed.getvalue()


def files_in(folder: Path) -> Iterator[tuple[Path, str]]:
    """The files in a folder, with their paths inside; links are left out."""
    for path in sorted(folder.rglob("*")):
        # A link could lead out of the folder.
        if path.is_file() and not path.is_symlink():
            yield path, path.relative_to(folder).as_posix()
