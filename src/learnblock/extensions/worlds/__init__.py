"""The user's own worlds: shared as one file, imported, renamed and deleted."""

from learnblock.extensions.worlds.folder import delete, find, install, own_names, rename, restore
from learnblock.extensions.worlds.packed_world import (
    ENDINGS,
    PackedWorld,
    is_same,
    pack,
    picture_name,
    plain_name,
    staged,
    unpack,
)

__all__ = [
    "ENDINGS",
    "PackedWorld",
    "delete",
    "find",
    "install",
    "is_same",
    "own_names",
    "pack",
    "picture_name",
    "plain_name",
    "rename",
    "restore",
    "staged",
    "unpack",
]
