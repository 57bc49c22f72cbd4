"""Translate ``import "dance"`` to Python and back."""

import sys

#: The package in which Python finds the imports of Block-Text.
PACKAGE = "learnblock.libraries"


def to_python(module: str) -> str:
    """The module in Python of an import of Block-Text."""
    return f"{PACKAGE}.{module}"


def from_python(module: str) -> str | None:
    """The import of Block-Text for ``from MODULE import *``; None if only Python can import it.

    A plain ``from dance import *`` is the older spelling, which finds the file ``dance.py``.
    Block-Text cannot import the modules of Python and of LearnBlock.
    """
    inside = module.removeprefix(f"{PACKAGE}.")
    if inside != module:
        return inside
    top = module.partition(".")[0]
    return None if top == "learnblock" or top in sys.stdlib_module_names else module
