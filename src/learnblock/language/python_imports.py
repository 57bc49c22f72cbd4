"""How ``import "dance"`` is spelled in Python."""

import sys

#: The package in which Python finds what Block-Text imports.
PACKAGE = "learnblock.libraries"


def to_python(module: str) -> str:
    """The module in Python that an import of Block-Text names."""
    return f"{PACKAGE}.{module}"


def from_python(module: str) -> str | None:
    """What Block-Text imports for ``from MODULE import *``; None for what only Python can.

    A plain ``from dance import *`` is how this was spelled at first, and how Python finds the file
    ``dance.py``. Python's own modules and ours are no such files.
    """
    inside = module.removeprefix(f"{PACKAGE}.")
    if inside != module:
        return inside
    top = module.partition(".")[0]
    return None if top == "learnblock" or top in sys.stdlib_module_names else module
