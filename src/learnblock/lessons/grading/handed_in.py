"""What a class has handed in: programs, folders, and zips as learning platforms give them."""

import hashlib
import unicodedata
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from learnblock.errors import FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.grading.unpacking import ENDINGS, MOODLE, program_name, unpacked
from learnblock.lessons.grading.values import HandedIn
from learnblock.project.files import ENDING
from learnblock.project.files.programs import Report, opened
from learnblock.running.source import LARGEST_PROGRAM
from learnblock.storage.archive import IGNORED

#: The most programs of one pupil that are graded; more are rather the files of another tool.
MOST_PROGRAMS = 5
#: The most names of files in a message.
_NAMED = 5
_ZIP = ".zip"


@dataclass(frozen=True)
class _Pupil:
    """What a pupil has handed in.

    Args:
        name: of the pupil.
        full_name: instead of a name that others have, too.
        paths: files and folders.
    """

    name: str
    full_name: str
    paths: list[Path] = field(default_factory=list)


def read_all(paths: Sequence[Path], folder: Path, report: Report) -> Iterator[HandedIn]:
    """Read what was handed in, in the order of the names of files in each folder.

    Args:
        paths: programs, folders and zips.
        folder: where the programs in zips are unpacked.
        report: called with what is left out.

    Raises:
        LearnBlockError: a zip is damaged or too large.
    """
    reader = _Reader(folder, report)
    for path in paths:
        if path.is_dir():
            yield from reader.read_class(path)
        elif path.suffix.lower() == _ZIP:
            yield from reader.read_class(_without_outer(reader.unpack(path)))
        else:
            yield reader.read(path, path.stem)


class _Reader:
    """Reads what was handed in.

    Args:
        folder: where the programs in zips are unpacked.
        report: called with what is left out.
    """

    def __init__(self, folder: Path, report: Report) -> None:
        self._folder = folder
        self._report = report

    def unpack(self, file: Path) -> Path:
        """The folder with the programs of a zip.

        Raises:
            LearnBlockError: it is damaged or too large.
        """
        contents = unpacked(file, self._folder)
        if left := contents.left_out:
            named = left[:_NAMED]
            self._report(
                Phrase("grade-left-out", file=str(file), names=named, more=len(left) - len(named))
            )
        return contents.folder

    def read_class(self, folder: Path) -> Iterator[HandedIn]:
        """What each pupil has in a folder."""
        pupils = _pupils(folder)
        bearers = Counter(pupil.name for pupil in pupils)
        for pupil in pupils:
            yield from self._read_pupil(
                pupil.name if bearers[pupil.name] == 1 else pupil.full_name, pupil.paths
            )

    def read(self, path: Path, pupil: str) -> HandedIn:
        """The program of a file."""
        try:
            program = self._well_named(path)
            with opened(program, self._report) as file:
                source = file.source
                tags = dict(file.tags)
        except FileError as error:
            return HandedIn(pupil, str(path), _text_of(path), reason=error.phrase)
        except LearnBlockError as error:
            return HandedIn(pupil, str(path), reason=error.phrase)
        except OSError as error:
            return HandedIn(pupil, str(path), reason=Phrase(error.strerror or str(error)))
        return HandedIn(pupil, str(program), source.text, source.is_python, tags)

    def _read_pupil(self, pupil: str, paths: Sequence[Path]) -> Iterator[HandedIn]:
        """What a pupil has handed in: each program, with its name if there are several."""
        try:
            programs = [program for path in paths for program in self._programs(path)]
        except LearnBlockError as error:
            yield HandedIn(pupil, str(paths[0]), reason=error.phrase)
            return
        if not programs:
            reason = Phrase("grade-no-program")
            yield HandedIn(pupil, str(paths[0]), reason=reason, absence="nothing handed in")
        elif len(programs) > MOST_PROGRAMS:
            names = tuple(sorted(name for name, _ in programs)[:_NAMED])
            reason = Phrase("grade-many-programs", files=names, most=MOST_PROGRAMS)
            yield HandedIn(pupil, str(paths[0]), reason=reason)
        else:
            for name, program in sorted(programs):
                yield self.read(program, pupil if len(programs) == 1 else f"{pupil} - {name}")

    def _programs(self, path: Path) -> Iterator[tuple[str, Path]]:
        """The programs in a folder, and in zips there, each with its path inside."""
        if path.suffix.lower() == _ZIP and path.is_file():
            path = self.unpack(path)
        files = sorted(path.rglob("*")) if path.is_dir() else [path]
        for file in files:
            inside = (file.relative_to(path) if file != path else Path(file.name)).as_posix()
            if IGNORED.search(inside) or not file.is_file():
                continue
            if program_name(file.name):
                yield inside, file
            elif file.suffix.lower() == _ZIP:
                folder = inside[: -len(_ZIP)]
                yield from ((f"{folder}/{name}", program) for name, program in self._programs(file))

    def _well_named(self, path: Path) -> Path:
        """A program, or a copy of it whose name ends as names of programs do."""
        name = program_name(path.name)
        if name is None or path.suffix.lower() in ENDINGS:
            return path
        with path.open("rb") as file:
            # A larger one is refused when it is read.
            content = file.read(LARGEST_PROGRAM + 1)
        copy = self._folder / hashlib.sha256(content).hexdigest()[:8] / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(content)
        return copy


def _pupils(folder: Path) -> list[_Pupil]:
    """The pupils whose files and folders are in a folder.

    Moodle names them ``Ana Gil_12_assignsubmission_file_``, Google Classroom ``Ana Gil - Square``.
    """
    pupils: dict[tuple[str, str], _Pupil] = {}
    for path in sorted(folder.iterdir()):
        if IGNORED.search(path.name):
            continue
        # Some systems take a name's accents apart.
        whole = unicodedata.normalize("NFC", path.name)
        program = program_name(whole) or (whole if path.suffix.lower() == _ZIP else None)
        if moodle := MOODLE.fullmatch(whole):
            name, number = moodle["pupil"], moodle["number"]
            key, pupil = ("moodle", number), _Pupil(name, f"{name} ({number})")
        elif path.is_dir():
            key, pupil = ("folder", path.name), _Pupil(whole, whole)
        elif program:
            stem = program.rpartition(".")[0]
            key, pupil = ("file", path.name), _Pupil(stem.partition(" - ")[0], stem)
        else:
            continue
        pupils.setdefault(key, pupil).paths.append(path)
    return list(pupils.values())


def _without_outer(folder: Path) -> Path:
    """The folder with the pupils' work: a zip often has one folder with everything in it."""
    inside = [path for path in folder.iterdir() if not IGNORED.search(path.name)]
    if len(inside) == 1 and inside[0].is_dir() and not MOODLE.fullmatch(inside[0].name):
        return inside[0] if len(_pupils(inside[0])) > 1 else folder
    return folder


def _text_of(path: Path) -> str:
    """The text of a program that is invalid, so that the teacher can read it; "" for a project."""
    with suppress(OSError, UnicodeDecodeError):
        if path.suffix.lower() != ENDING:
            return path.read_text("utf-8-sig")
    return ""
