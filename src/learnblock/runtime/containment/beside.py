"""The files next to a program whose folder has other things in it, as a home folder has.

Landlock's right to list a folder holds for all folders below. So the program gets each of these
files, but not the list of them, and a finder for the modules among them.
"""

import os
import sys
from collections.abc import Mapping, Sequence
from importlib.abc import MetaPathFinder
from importlib.machinery import SOURCE_SUFFIXES, ModuleSpec, PathFinder
from importlib.util import spec_from_file_location
from itertools import islice
from pathlib import Path
from types import ModuleType

#: The most files; modules count first.
MOST_FILES = 4096
#: Where programs import the modules next to them: by their names alone, and like a library.
_PACKAGES = ("", "learnblock.libraries")


def files_beside(folder: Path) -> list[Path]:
    """The files directly in a folder, without hidden ones and links that lead out of it.

    Args:
        folder: the folder, without links in its path.
    """
    try:
        paths = [path for path in folder.iterdir() if not path.name.startswith(".")]
    except OSError:
        return []
    paths.sort(key=lambda path: (path.suffix not in SOURCE_SUFFIXES, path.name))
    return [*islice((path for path in paths if _is_inside(path, folder)), MOST_FILES)]


def make_importable(folder: str, files: Sequence[Path]) -> None:
    """Let the program import modules of a folder that it may not list.

    Args:
        folder: the folder, as the program knows it.
        files: the files in it.
    """
    modules = {
        path.stem: os.path.join(folder, path.name)  # noqa: PTH118 - text
        for path in files
        if path.suffix in SOURCE_SUFFIXES
    }
    places = [place for place, finder in enumerate(sys.meta_path) if finder is PathFinder]
    sys.meta_path.insert(places[0] if places else len(sys.meta_path), _Modules(modules))


class _Modules(MetaPathFinder):
    """Finds modules by their names.

    Args:
        files: the file of each module.
    """

    def __init__(self, files: Mapping[str, str]) -> None:
        self._files = files

    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None,  # noqa: ARG002 - the signature of finders
        target: ModuleType | None = None,  # noqa: ARG002 - as above
    ) -> ModuleSpec | None:
        package, _, name = fullname.rpartition(".")
        file = self._files.get(name) if package in _PACKAGES else None
        return spec_from_file_location(fullname, file) if file else None


def _is_inside(path: Path, folder: Path) -> bool:
    """Whether it is a file of the folder, and no link to one elsewhere."""
    return path.is_file() and (not path.is_symlink() or path.resolve().parent == folder)
