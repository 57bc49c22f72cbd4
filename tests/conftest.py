"""What all tests share."""

import sys
from pathlib import Path

import pytest

# Modules of helpers that several tests import, such as `runs`.
sys.path.insert(0, str(Path(__file__).parent))


@pytest.fixture(autouse=True)
def own_home(tmp_path_factory, monkeypatch):
    """No test sees, or changes, what the user who runs it keeps."""
    home = tmp_path_factory.mktemp("home")
    monkeypatch.setenv("LEARNBLOCK_HOME", str(home))
    for name in ("WORLD", "SEED", "PACE", "TRACE"):
        monkeypatch.delenv(f"LEARNBLOCK_{name}", raising=False)
    return home
