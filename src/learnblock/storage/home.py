"""The user's folder of skills, robots, worlds, blocks and settings."""

import os
import sys
import threading
from contextlib import suppress
from pathlib import Path
from types import ModuleType

#: Held while a file is imported, so that another thread never gets half of it. As with Python's own
#: locks of imports, a file may import others.
_IMPORTING = threading.RLock()


def home() -> Path:
    """The path in ``LEARNBLOCK_HOME``, or else the system's folder for user configuration."""
    folder = os.environ.get("LEARNBLOCK_HOME")
    if folder:
        return Path(folder)
    from platformdirs import user_config_path  # noqa: PLC0415 - most programs never need it

    return user_config_path("learnblock", appauthor=False)


def home_id() -> str:
    """A random word that tells this folder from others; empty if it can't be saved."""
    from uuid import uuid4  # noqa: PLC0415 - most programs never need it

    from learnblock.storage.files import save  # noqa: PLC0415 - as above

    with suppress(OSError):
        if not _home_id().exists():
            save(_home_id(), uuid4().hex.encode())
    return saved_home_id()


def saved_home_id() -> str:
    """The word that `home_id` has saved; empty if it has not."""
    with suppress(OSError, UnicodeDecodeError):
        return _home_id().read_text("ascii").strip()[:100]
    return ""


def _home_id() -> Path:
    return home() / "home-id"


def import_file(path: Path) -> ModuleType:
    """Import a Python file from the user's folder; import it again only after a change.

    Raises:
        Exception: any error that the file raises, which is then not imported.
    """
    import importlib.util  # noqa: PLC0415 - most programs never need it

    name = f"learnblock_home.{path.parent.name}.{path.stem}"
    with _IMPORTING:
        version = (str(path), path.stat().st_mtime_ns)
        loaded = sys.modules.get(name)
        if loaded and loaded.__spec__ and loaded.__spec__.loader_state == version:
            return loaded
        spec = importlib.util.spec_from_file_location(name, path)
        if spec is None or spec.loader is None:
            raise ImportError(f"{path} is not a Python file")
        spec.loader_state = version
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        try:
            spec.loader.exec_module(module)
        except BaseException:
            del sys.modules[name]
            raise
        return module
