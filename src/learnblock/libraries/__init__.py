"""Where ``from learnblock.libraries.dance import *`` finds what it imports.

First in the folder of the program that runs, which may hold ``dance.py`` or a library's folder
``dance``; then among the libraries that are installed in `home`. This package holds nothing else:
what a library is, and how one is made and installed, is told by `learnblock.library`.
"""

import sys
from collections.abc import Iterator
from pathlib import Path

from learnblock.home import home


def _folders() -> Iterator[Path]:
    program = Path(getattr(sys.modules["__main__"], "__file__", None) or "")
    # One that the page runs is no file, and has no folder.
    if program.is_absolute():
        yield program.parent
    yield home() / "libraries"


__path__ = [str(folder) for folder in _folders()]
