"""The environment of a program: the variables it needs, and none of the user's secrets."""

import os
import site
from collections.abc import Mapping

from learnblock.storage.home import home

_KEPT = frozenset(
    {
        "LANG", "LANGUAGE", "TZ", "LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH", "VIRTUAL_ENV",
        # Windows cannot start programs without these.
        "SYSTEMROOT", "WINDIR", "PATH", "APPDATA", "LOCALAPPDATA",
    }
)  # fmt: skip
_KEPT_PREFIXES = ("LC_", "PYTHON", "OMP_", "OPENBLAS_")


def environment(scratch: str) -> Mapping[str, str]:
    """The variables of a program.

    Args:
        scratch: its temporary folder.
    """
    return {**without_folders(), **folders(scratch)}


def folders(scratch: str) -> Mapping[str, str]:
    """The variables of a program that name its temporary folder.

    Args:
        scratch: the folder.
    """
    return dict.fromkeys(("HOME", "USERPROFILE", "TMPDIR", "TEMP", "TMP"), scratch)


def without_folders() -> Mapping[str, str]:
    """The variables that all programs have in common."""
    ours = {
        # Python looks for the user's packages here; its default depends on HOME, which we change.
        "PYTHONUSERBASE": site.getuserbase(),
        # The order of a set of strings must not differ between two runs.
        "PYTHONHASHSEED": "0",
        "LEARNBLOCK_HOME": str(home().absolute()),
    }
    return {**harmless(), **ours}


def harmless() -> Mapping[str, str]:
    """The variables of this process that no program is refused."""
    return {
        name: value
        for name, value in os.environ.items()
        if name in _KEPT or name.startswith(_KEPT_PREFIXES)
    }
