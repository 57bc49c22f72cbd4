"""The other versions of Python on this computer."""

import os
import shutil
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from places import ROOT

#: The versions that LearnBlock supports.
VERSIONS = ("3.11", "3.12", "3.13", "3.14")


@cache
def interpreter(version: str) -> Path | None:
    """Return an interpreter of that version: on the path or of pyenv."""
    return next(filter(_works, _candidates(version)), None)


def interpreters() -> dict[str, Path]:
    """Return all interpreters of the supported versions, by their full version, such as 3.11.2."""
    by_version = {}
    for version in VERSIONS:
        for python in filter(_works, _candidates(version)):
            by_version.setdefault(_full_version(python), python)
    return by_version


def with_learnblock(version: str) -> Path | None:
    """Return an interpreter that has what LearnBlock needs, as made by `scripts/bench hashes`."""
    return next((ROOT / "build" / "pythons").glob(f"{version}.*/bin/python"), None)


def _candidates(version: str) -> Iterator[Path]:
    for folder in os.get_exec_path():
        if path := shutil.which(f"python{version}", path=folder):
            yield Path(path)
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    yield from pyenv.glob(f"{version}.*/bin/python")


def _full_version(python: Path) -> str:
    command = [python, "-c", "import platform; print(platform.python_version())"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


def _works(python: Path) -> bool:
    # pyenv puts a shim on the path even for versions that are not selected.
    process = subprocess.run([python, "-c", ""], capture_output=True, check=False)
    return process.returncode == 0
