"""What a class has handed in: programs, folders, and zips as learning platforms give them."""

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from learnblock.cli.project_files import ENDING, opened
from learnblock.errors import FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.archive import IGNORED
from learnblock.lessons.grading.unpacking import ENDINGS, MOODLE, unpacked
from learnblock.lessons.grading.values import HandedIn


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


def read_all(paths: Sequence[Path], folder: Path) -> Iterator[HandedIn]:
    """Read what was handed in, in the order of the names of files in each folder.

    Args:
        paths: programs, folders and zips.
        folder: where the programs in zips are unpacked.

    Raises:
        LearnBlockError: a zip is damaged or too large.
    """
    for path in paths:
        if path.is_dir():
            yield from _read_class(path)
        elif path.suffix.lower() == ".zip":
            yield from _read_class(_without_outer(unpacked(path, folder)))
        else:
            yield _read(path, path.stem)


def _read_class(folder: Path) -> Iterator[HandedIn]:
    pupils = _pupils(folder)
    bearers = Counter(one.name for one in pupils)
    for one in pupils:
        yield _read_pupil(one.name if bearers[one.name] == 1 else one.full_name, one.paths)


def _pupils(folder: Path) -> list[_Pupil]:
    """The pupils whose files and folders are in a folder.

    Moodle names them ``Ana Gil_12_assignsubmission_file_``, Google Classroom ``Ana Gil - Square``.
    """
    found: dict[tuple[str, str], _Pupil] = {}
    for path in sorted(folder.iterdir()):
        if IGNORED.search(path.name):
            continue
        if moodle := MOODLE.fullmatch(path.name):
            name, number = moodle["pupil"], moodle["number"]
            key, pupil = ("moodle", number), _Pupil(name, f"{name} ({number})")
        elif path.is_dir():
            key, pupil = ("folder", path.name), _Pupil(path.name, path.name)
        elif path.suffix.lower() in ENDINGS:
            key, pupil = ("file", path.name), _Pupil(path.stem.partition(" - ")[0], path.stem)
        else:
            continue
        found.setdefault(key, pupil).paths.append(path)
    return list(found.values())


def _without_outer(folder: Path) -> Path:
    """The folder with the pupils' work: a zip often has one folder with everything in it."""
    [*inside] = folder.iterdir()
    if len(inside) == 1 and inside[0].is_dir() and not MOODLE.fullmatch(inside[0].name):
        return inside[0] if len(_pupils(inside[0])) > 1 else folder
    return folder


def _read_pupil(pupil: str, paths: Sequence[Path]) -> HandedIn:
    """What a pupil has handed in: the only program."""
    found = sorted(program for path in paths for program in _programs(path))
    if len(found) == 1:
        return _read(found[0], pupil)
    names = tuple(str(one.relative_to(paths[0].parent)) for one in found[:5])
    reason = Phrase("grade-many-programs", files=names) if found else Phrase("grade-no-program")
    return HandedIn(pupil, str(paths[0]), reason=reason)


def _programs(path: Path) -> list[Path]:
    inside = path.rglob("*") if path.is_dir() else [path]
    return [one for one in inside if one.suffix.lower() in ENDINGS and one.is_file()]


def _read(path: Path, pupil: str) -> HandedIn:
    try:
        with opened(path) as program:
            source = program.source
            tags = dict(program.tags)
    except FileError as error:
        return HandedIn(pupil, str(path), _text_of(path), reason=error.phrase)
    except LearnBlockError as error:
        return HandedIn(pupil, str(path), reason=error.phrase)
    except OSError as error:
        return HandedIn(pupil, str(path), reason=Phrase(error.strerror or str(error)))
    return HandedIn(pupil, str(path), source.text, source.is_python, tags)


def _text_of(path: Path) -> str:
    """The text of a program that is invalid, so that the teacher can read it; "" for a project."""
    with suppress(OSError, UnicodeDecodeError):
        if path.suffix.lower() != ENDING:
            return path.read_text("utf-8-sig")
    return ""
