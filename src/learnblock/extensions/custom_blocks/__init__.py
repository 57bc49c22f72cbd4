"""Custom blocks: Python files that users write, checked before they are saved.

The code in such a file is not run here; it runs only as part of a program.
"""

from learnblock.extensions.custom_blocks.checking import check
from learnblock.extensions.custom_blocks.custom_block import Checked, CustomBlock, Part, Problem
from learnblock.extensions.custom_blocks.folder import (
    delete,
    duplicate,
    export,
    find,
    import_file,
    load_all,
    restore,
    save,
)
from learnblock.extensions.custom_blocks.package import ENDING

__all__ = [
    "ENDING",
    "Checked",
    "CustomBlock",
    "Part",
    "Problem",
    "check",
    "delete",
    "duplicate",
    "export",
    "find",
    "import_file",
    "load_all",
    "restore",
    "save",
]
