"""The other versions of Python on this computer."""

import os
import shutil
import subprocess
from functools import cache
from pathlib import Path

from places import ROOT

#: The versions that LearnBlock supports.
VERSIONS = ("3.11", "3.12", "3.13", "3.14")


@cache
def interpreter(version: str) -> Path | None:
    """Return an interpreter of that version: on the path or of pyenv."""
    on_path = shutil.which(f"python{version}")
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    found = [*([Path(on_path)] if on_path else []), *pyenv.glob(f"{version}.*/bin/python")]
    return next((python for python in found if _works(python)), None)


def with_learnblock(version: str) -> Path | None:
    """Return an interpreter that has what LearnBlock needs, as made by `scripts/bench hashes`."""
    python = ROOT / "build" / "pythons" / version / "bin" / "python"
    return python if python.exists() else None


def _works(python: Path) -> bool:
    # pyenv puts a shim on the path even for versions that are not selected.
    done = subprocess.run([python, "-c", ""], capture_output=True, check=False)
    return done.returncode == 0
