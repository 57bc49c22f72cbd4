"""The real Ice runtime in tests: components in a process of the Python that has it."""

import json
import queue
import subprocess
import sys
import threading
from contextlib import contextmanager
from pathlib import Path

import pytest

from places import TESTS

sys.path.insert(0, str(TESTS / "helpers" / "ice"))

from slices import slice_text

_FOLDER = TESTS / "helpers" / "ice"
#: Debian's package belongs to Debian's Python.
PYTHON = "/usr/bin/python3"
TIMEOUT = 20


def require_ice():
    """Skip a test if the runtime is not installed."""
    try:
        process = subprocess.run([PYTHON, "-c", "import Ice"], capture_output=True, check=False)
        missing = process.returncode != 0
    except OSError:
        missing = True
    if missing:
        pytest.skip("needs the Ice runtime: apt-get install python3-zeroc-ice")


class Components:
    """Running components.

    Attributes:
        ports: the ports of the objects, in the order of the request.
    """

    def __init__(self, process):
        self._process = process
        self._lines = queue.Queue()
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()
        self.ports = self.told()

    def told(self):
        """Return the next command that an object received."""
        line = self._lines.get(timeout=TIMEOUT)
        assert line is not None, "the components have ended"
        return json.loads(line)

    def has_told_nothing(self):
        """Return whether no object has received a command."""
        return self._lines.empty()

    def kill(self):
        """End them abruptly."""
        self._process.kill()
        self._process.wait()

    def end(self):
        """End them cleanly: they close their connections to clients."""
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
        "objects": [entry if isinstance(entry, tuple) else (entry, {}) for entry in objects],
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
    """Return the file of slices in a layout."""
    path = Path(folder) / f"{layout}.ice"
    path.write_text(slice_text(layout), encoding="utf-8")
    return path
