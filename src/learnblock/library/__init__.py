"""Libraries: skills that are made, given away and imported together.

A library is a folder, or the same files in one zip. What is imported is somebody else's: it is read
here, and never run; it runs only as a part of a program.
"""

from learnblock.library.address import find
from learnblock.library.archive import ENDING, pack, read, unpack
from learnblock.library.clashes import Clash, clashes
from learnblock.library.contents import Library, from_files
from learnblock.library.making import make, own_skills
from learnblock.library.manifest import Manifest, Name, Version, manifest, order
from learnblock.library.renaming import renamed
from learnblock.library.shelf import (
    Shelved,
    install,
    installed,
    readable,
    remove,
    shelved,
    versions,
    write,
)

__all__ = [
    "ENDING",
    "Clash",
    "Library",
    "Manifest",
    "Name",
    "Shelved",
    "Version",
    "clashes",
    "find",
    "from_files",
    "install",
    "installed",
    "make",
    "manifest",
    "order",
    "own_skills",
    "pack",
    "read",
    "readable",
    "remove",
    "renamed",
    "shelved",
    "unpack",
    "versions",
    "write",
]
