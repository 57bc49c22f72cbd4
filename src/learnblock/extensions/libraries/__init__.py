"""Libraries: skills that are made, shared and imported together.

A library is a folder, or the same files in one zip. Its code is only read here, and never run; it
runs only as part of a program.
"""

from learnblock.extensions.libraries.archive import ENDING, find, pack, read, unpack
from learnblock.extensions.libraries.clashes import Clash, clashes
from learnblock.extensions.libraries.contents import Library, from_files
from learnblock.extensions.libraries.making import make, own_skills
from learnblock.extensions.libraries.manifest import Manifest, Name, Version, manifest, order
from learnblock.extensions.libraries.renaming import renamed
from learnblock.extensions.libraries.shelf import (
    Shelved,
    install,
    installed,
    keep,
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
    "keep",
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
