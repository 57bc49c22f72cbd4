"""The libraries that a program can import: ``from learnblock.libraries.dance import *``.

Python looks first in the program's folder, for a file ``dance.py`` or a folder ``dance``, then
among the libraries installed in `home`. `learnblock.extensions.libraries` makes and installs them.
"""

import sys
from collections.abc import Iterator
from pathlib import Path

from learnblock.storage.home import home


def _folders() -> Iterator[Path]:
    program = Path(getattr(sys.modules["__main__"], "__file__", None) or "")
    # A program run from the page has no file, and therefore no folder.
    if program.is_absolute():
        yield program.parent
    yield home() / "libraries"


__path__ = [str(folder) for folder in _folders()]
