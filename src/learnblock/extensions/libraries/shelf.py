"""The installed libraries, in the folder ``libraries`` of `home`."""

import shutil
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from learnblock.blocks import installed_libraries
from learnblock.errors import Diagnostic, FileError, LearnBlockError, LibraryError, UnknownNameError
from learnblock.extensions.libraries.archive import read
from learnblock.extensions.libraries.clashes import refuse_clashes
from learnblock.extensions.libraries.contents import Library
from learnblock.i18n import Phrase
from learnblock.storage.files import save
from learnblock.storage.home import home

_NO_PROBLEM = Phrase("")


@dataclass(frozen=True, slots=True)
class Shelved:
    """An installed library.

    Args:
        name: the name that programs import.
        folder: the folder of its files.
        library: None if it is broken.
        problem: why it is broken; empty if it is intact.
    """

    name: str
    folder: Path
    library: Library | None
    problem: Phrase = _NO_PROBLEM


def folder() -> Path:
    """The folder of installed libraries, which may not exist yet."""
    return home() / "libraries"


def shelved() -> tuple[Shelved, ...]:
    """All installed libraries, including broken ones."""
    return tuple(_shelved(name, path) for name, path in installed_libraries.installed().items())


def installed(name: str) -> Library:
    """An installed library.

    Raises:
        UnknownNameError: there is no such library.
        LearnBlockError: it is broken.
    """
    return read(_folder_of(name))


def readable() -> dict[str, Library]:
    """The installed libraries that are not broken, by name."""
    return {entry.name: entry.library for entry in shelved() if entry.library}


def versions() -> dict[str, str]:
    """The version of each installed library that can be read."""
    return {name: library.manifest.version for name, library in readable().items()}


def install(coming: Iterable[Library], *, replace: bool = False) -> tuple[Library, ...]:
    """Install libraries: all of them, or none if one cannot be installed.

    Args:
        coming: the libraries to install.
        replace: whether a library may replace the same or a newer version.

    Returns:
        The libraries that were not installed in exactly this form before.

    Raises:
        LibraryError: two skills have the same name, or an installed version is not older.
        OSError: they cannot be written.
    """
    coming = tuple(coming)
    _refuse_twice(coming)
    refuse_clashes(coming)
    there = readable()
    new = tuple(library for library in coming if not _is_same(there.get(library.name), library))
    if not replace:
        for library in new:
            _refuse_older(there.get(library.name), library)
    for library in new:
        _write(library)
    return new


def remove(name: str) -> None:
    """Remove a library; the last one of each name is kept in ``libraries/.trash``.

    Raises:
        UnknownNameError: there is no such library.
        OSError: it cannot be moved.
    """
    present = _folder_of(name)
    trash = folder() / ".trash" / name
    trash.parent.mkdir(exist_ok=True)
    _delete(trash)
    present.rename(trash)


def keep(name: str) -> None:
    """Copy a library that is installed into the trash, before it is replaced.

    Raises:
        OSError: it cannot be copied.
    """
    library = readable().get(name)
    if library is None:
        return
    trash = folder() / ".trash" / name
    trash.parent.mkdir(exist_ok=True)
    _delete(trash)
    write(library, trash)


def _folder_of(name: str) -> Path:
    folders = installed_libraries.installed()
    if name not in folders:
        raise UnknownNameError("library", name, folders)
    return folders[name]


def _shelved(name: str, path: Path) -> Shelved:
    try:
        library = read(path)
    except FileError as error:
        problem = Phrase("library-broken-file", file=error.filename, problem=error.phrase)
        return Shelved(name, path, None, problem)
    except LearnBlockError as error:
        return Shelved(name, path, None, error.phrase)
    except OSError as error:
        return Shelved(name, path, None, Phrase(str(error)))
    if library.name != name:
        problem = Phrase("library-two-names", name=library.name, folder=name)
        return Shelved(name, path, None, problem)
    return Shelved(name, path, library)


def _is_same(there: Library | None, coming: Library) -> bool:
    return there is not None and there.files == coming.files


def _refuse_twice(coming: tuple[Library, ...]) -> None:
    by_name: dict[str, Library] = {}
    for library in coming:
        if library.name in by_name:
            message = Phrase("library-same-name")
            raise LibraryError(library.name, [Diagnostic("two-libraries", message)])
        by_name[library.name] = library


def _refuse_older(there: Library | None, coming: Library) -> None:
    if there is None or coming.manifest.order > there.manifest.order:
        return
    message = Phrase(
        "library-not-newer",
        library=coming.name,
        installed=there.manifest.version,
        version=coming.manifest.version,
    )
    raise LibraryError(coming.name, [Diagnostic("no-newer", message)])


def _write(library: Library) -> None:
    """Write the whole folder of a library, and only then replace the old one."""
    target = folder() / library.name
    unfinished, before = (target.with_name(f".{library.name}.{end}") for end in ("new", "old"))
    _delete(unfinished)
    write(library, unfinished)
    _delete(before)
    with suppress(FileNotFoundError):
        target.rename(before)
    unfinished.rename(target)
    _delete(before)


def write(library: Library, target: Path) -> None:
    """Write the files of a library into a folder, which may not exist yet.

    Raises:
        OSError: they cannot be written.
    """
    target.mkdir(parents=True, exist_ok=True)
    for name, text in library.files.items():
        save(target / name, text.encode())


def _delete(path: Path) -> None:
    if path.exists():
        shutil.rmtree(path)
