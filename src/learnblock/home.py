"""The user's own folder of skills, robots, worlds, blocks and settings."""

import os
from pathlib import Path


def home() -> Path:
    """``LEARNBLOCK_HOME``, or else the place where this system keeps a user's configuration."""
    chosen = os.environ.get("LEARNBLOCK_HOME")
    if chosen:
        return Path(chosen)
    from platformdirs import user_config_path  # noqa: PLC0415 - most programs never need it

    return user_config_path("learnblock", appauthor=False)
