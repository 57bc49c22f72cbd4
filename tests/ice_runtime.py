"""The real Ice runtime in tests: components as a process of the Python that has it."""

import json
import queue
import subprocess
import sys
import threading
from contextlib import contextmanager
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent / "ice"))

from slices import slice_text

_FOLDER = Path(__file__).parent / "ice"
#: Debian's package belongs to Debian's Python.
PYTHON = "/usr/bin/python3"
PATIENCE = 20


def require_ice():
    """Skip a test where the runtime is not installed."""
    try:
        found = subprocess.run([PYTHON, "-c", "import Ice"], capture_output=True, check=False)
        missing = found.returncode != 0
    except OSError:
        missing = True
    if missing:
        pytest.skip("needs the Ice runtime: apt-get install python3-zeroc-ice")


class Components:
    """Components that run.

    Attributes:
        ports: of the objects, in the order in which they were asked for.
    """

    def __init__(self, process):
        self._process = process
        self._lines = queue.Queue()
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()
        self.ports = self.told()

    def told(self):
        """The next thing that an object was told."""
        line = self._lines.get(timeout=PATIENCE)
        assert line is not None, "the components have ended"
        return json.loads(line)

    def has_told_nothing(self):
        """Whether no object has been told anything."""
        return self._lines.empty()

    def kill(self):
        """End them without a word."""
        self._process.kill()
        self._process.wait()

    def end(self):
        """Have them end as components do that are told to: they say goodbye to their clients."""
        self._process.stdin.close()

    def close(self):
        self.kill()
        self._thread.join()
        self._process.stdin.close()
        self._process.stdout.close()

    def _read(self):
        for line in self._process.stdout:
            self._lines.put(line)
        self._lines.put(None)


@contextmanager
def components(folder, layout, *objects, quiet=False, ice=()):
    """Start components: identities, or (identity, options of its class in `servants.py`)."""
    require_ice()
    slices = written(folder, layout)
    plan = {
        "slices": str(slices),
        "objects": [one if isinstance(one, tuple) else (one, {}) for one in objects],
        "quiet": quiet,
        "ice": list(ice),
    }
    process = subprocess.Popen(
        [PYTHON, str(_FOLDER / "servants.py"), json.dumps(plan)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        running = Components(process)
    except BaseException:
        process.kill()
        process.communicate()
        raise
    try:
        yield running
    finally:
        running.close()


def written(folder, layout):
    """The file of slices in a layout."""
    path = Path(folder) / f"{layout}.ice"
    path.write_text(slice_text(layout), encoding="utf-8")
    return path
