"""The libraries that are installed, in ``libraries`` of `home`."""

import shutil
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from learnblock.blocks import libraries
from learnblock.errors import Diagnostic, LearnBlockError, LibraryError, UnknownNameError
from learnblock.files import save
from learnblock.home import home
from learnblock.library.archive import read
from learnblock.library.clashes import refuse_clashes
from learnblock.library.contents import Library


@dataclass(frozen=True, slots=True)
class Shelved:
    """A library that is installed.

    Args:
        name: by which programs import it.
        folder: where it lies.
        library: what it is; None where it is broken.
        problem: why; empty where it is not.
    """

    name: str
    folder: Path
    library: Library | None
    problem: str = ""


def folder() -> Path:
    """Where installed libraries lie; it need not be there."""
    return home() / "libraries"


def shelved() -> tuple[Shelved, ...]:
    """Every library that is installed, broken ones too."""
    return tuple(_shelved(name, path) for name, path in libraries.installed().items())


def installed(name: str) -> Library:
    """An installed library.

    Raises:
        UnknownNameError: there is none of that name.
        LearnBlockError: it is broken.
    """
    return read(_folder_of(name))


def readable() -> dict[str, Library]:
    """The installed libraries that are not broken, by name."""
    return {one.name: one.library for one in shelved() if one.library}


def versions() -> dict[str, str]:
    """The version of each library that is installed and can be read."""
    return {name: library.manifest.version for name, library in readable().items()}


def install(coming: Iterable[Library], *, replace: bool = False) -> tuple[Library, ...]:
    """Install libraries, all or none of them.

    Args:
        coming: which.
        replace: put one also in the place of a version that is as new, or newer.

    Returns:
        Those that were not there just so already.

    Raises:
        LibraryError: two skills have one name, or what is there already is as new.
        OSError: they cannot be written.
    """
    coming = tuple(coming)
    _refuse_twice(coming)
    refuse_clashes(coming)
    there = readable()
    new = tuple(one for one in coming if not _is_same(there.get(one.name), one))
    if not replace:
        for library in new:
            _refuse_older(there.get(library.name), library)
    for library in new:
        _write(library)
    return new


def remove(name: str) -> None:
    """Take a library away; the last one of each name is kept in ``libraries/.trash``.

    Raises:
        UnknownNameError: there is none of that name.
        OSError: it cannot be moved.
    """
    present = _folder_of(name)
    trash = folder() / ".trash" / name
    trash.parent.mkdir(exist_ok=True)
    _delete(trash)
    present.rename(trash)


def _folder_of(name: str) -> Path:
    found = libraries.installed()
    if name not in found:
        raise UnknownNameError("library", name, found)
    return found[name]


def _shelved(name: str, path: Path) -> Shelved:
    try:
        library = read(path)
    except (LearnBlockError, OSError) as error:
        return Shelved(name, path, None, str(error))
    if library.name != name:
        return Shelved(name, path, None, f"library.toml calls it {library.name}, its folder {name}")
    return Shelved(name, path, library)


def _is_same(there: Library | None, coming: Library) -> bool:
    return there is not None and there.files == coming.files


def _refuse_twice(coming: tuple[Library, ...]) -> None:
    seen: dict[str, Library] = {}
    for library in coming:
        if library.name in seen:
            message = "two of these libraries have this name: import one of them"
            raise LibraryError(library.name, [Diagnostic("two-libraries", message)])
        seen[library.name] = library


def _refuse_older(there: Library | None, coming: Library) -> None:
    if there is None or coming.manifest.order > there.manifest.order:
        return
    message = (
        f"version {there.manifest.version} of the library {coming.name} is installed, and"
        f" {coming.manifest.version} is no newer: replace it with --replace, or keep it"
    )
    raise LibraryError(coming.name, [Diagnostic("no-newer", message)])


def _write(library: Library) -> None:
    """Write a library's folder whole, and only then put it in the place of the one before."""
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
    """Write the files of a library into a folder, which need not be there.

    Raises:
        OSError: that cannot be.
    """
    target.mkdir(parents=True, exist_ok=True)
    for name, text in library.files.items():
        save(target / name, text.encode())


def _delete(path: Path) -> None:
    if path.exists():
        shutil.rmtree(path)
