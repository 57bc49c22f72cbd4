"""Blocks that people make themselves: a Python file each, checked before it is accepted.

Nothing of such a file is run here; it runs only as a part of a program.
"""

from learnblock.own_blocks.checking import check
from learnblock.own_blocks.folder import (
    delete,
    duplicate,
    export,
    find,
    import_file,
    own_blocks,
    restore,
    save,
)
from learnblock.own_blocks.own_block import Checked, OwnBlock, Part, Problem
from learnblock.own_blocks.package import ENDING

__all__ = [
    "ENDING",
    "Checked",
    "OwnBlock",
    "Part",
    "Problem",
    "check",
    "delete",
    "duplicate",
    "export",
    "find",
    "import_file",
    "own_blocks",
    "restore",
    "save",
]
