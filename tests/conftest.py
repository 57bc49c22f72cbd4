"""What all tests share."""

import signal
import sys
from pathlib import Path

import pytest

# Modules of helpers that several tests import, such as `runs`.
sys.path.insert(0, str(Path(__file__).parent))

# A shell ignores Ctrl-C for what it starts in the background, and all that this starts inherits it.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def own_home(tmp_path_factory, monkeypatch):
    """No test sees, or changes, what the user who runs it keeps."""
    home = tmp_path_factory.mktemp("home")
    monkeypatch.setenv("LEARNBLOCK_HOME", str(home))
    for name in ("WORLD", "SEED", "PACE", "TRACE"):
        monkeypatch.delenv(f"LEARNBLOCK_{name}", raising=False)
    return home
