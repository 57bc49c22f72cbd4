"""Write what the page is built from besides its sources: types of messages, and schemas of forms.

    python hatch_types.py

The build does this too, when one of the Python sources has changed. Those are the Python files of
``cache-keys`` in ``pyproject.toml``, so that uv builds again when they change.
"""

import hashlib
import re
import sys
import tomllib
from collections.abc import Iterable
from importlib import import_module
from pathlib import Path
from typing import Any

#: The written files, each with the module and the function that return its text.
FILES = {
    "frontend/src/protocol/messages.ts": ("learnblock.server.typescript", "typescript"),
    "frontend/src/protocol/world.ts": ("learnblock.server.typescript", "world_typescript"),
    "frontend/src/protocol/classroom.ts": ("learnblock.classroom.typescript", "typescript"),
    "frontend/src/features/world-editor/schema.json": (
        "learnblock.simulator.world_schema",
        "world_schema",
    ),
    "frontend/src/features/lesson-editor/schema.json": (
        "learnblock.lessons.check_schema",
        "check_schema",
    ),
}
HASH_FILE = "frontend/types.sha256"
#: The packages that those modules import; the build needs them only when it writes the files.
IMPORTED = frozenset({"greenlet", "msgspec", "pymunk", "tomli-w"})


def requirements(root: Path) -> list[str]:
    """Return what `make` requires, as the project requires it."""
    required = _pyproject(root)["project"]["dependencies"]
    return [text for text in required if re.split(r"[^\w.-]", text)[0] in IMPORTED]


def sources(root: Path) -> list[Path]:
    """Return the Python files that the written files depend on."""
    python = [key for key in cache_keys(root) if re.fullmatch(r"src/.+\.py", key)]
    return sorted(path for pattern in python for path in root.glob(pattern))


def cache_keys(root: Path) -> list[str]:
    """Return the files, some with stars, after whose changes uv builds again."""
    return [key["file"] for key in _pyproject(root)["tool"]["uv"]["cache-keys"]]


def sources_hash(root: Path) -> str:
    """Return a hash of everything that the written files depend on: their sources and this file."""
    return hash_of(root, [root / Path(__file__).name, *sources(root)])


def hash_of(root: Path, files: Iterable[Path]) -> str:
    """Return a hash of files in a folder: of their places and of what is in them."""
    digest = hashlib.sha256()
    for path in files:
        digest.update(path.relative_to(root).as_posix().encode() + b"\0")
        # A checkout on Windows may have other line ends.
        digest.update(path.read_bytes().replace(b"\r\n", b"\n") + b"\0")
    return digest.hexdigest()


def are_made(root: Path) -> bool:
    """Return whether the files are there, written from the sources as they are."""
    made = root / HASH_FILE
    return (
        all((root / file).is_file() for file in FILES)
        and made.is_file()
        and made.read_text(encoding="utf-8").strip() == sources_hash(root)
    )


def make(root: Path) -> None:
    """Write the files; one whose text has not changed stays as it is."""
    for file, (module, function) in FILES.items():
        _write(root / file, getattr(import_module(module), function)())
    _write(root / HASH_FILE, sources_hash(root) + "\n")


def _write(path: Path, text: str) -> None:
    if path.is_file() and path.read_text(encoding="utf-8") == text:
        return
    # Whole or not at all, since Vite may be reading it.
    new = path.with_name(f"{path.name}.new")
    new.write_text(text, encoding="utf-8", newline="\n")
    new.replace(path)


def _pyproject(root: Path) -> dict[str, Any]:
    return tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))


if __name__ == "__main__":
    ROOT = Path(__file__).parent
    # The build has no LearnBlock installed.
    sys.path.insert(0, str(ROOT / "src"))
    make(ROOT)
