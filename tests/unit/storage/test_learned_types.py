"""Several threads may be the first to read a kind of file."""

import subprocess
import sys

import pytest

#: Without `learned`, half of its runs die of a segmentation fault in msgspec.
FIRST_READERS = """
import sys
import threading

sys.setswitchinterval(1e-6)
from learnblock.simulator.world_description import WorldFile
from learnblock.storage import toml_source

WORLD = {"title": "A yard", "wall": [{"points": [[0, 0], [1, 1]]}]}
started = threading.Barrier(8)
described = []


def read():
    started.wait()
    described.append(toml_source.examine(WORLD, WorldFile, lambda _: ())[0].title)


threads = [threading.Thread(target=read) for _ in range(8)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(described == 8 * ["A yard"])
"""


@pytest.mark.parametrize("attempt", range(3))
def test_many_threads_may_be_the_first_to_read_a_kind_of_file(attempt):
    done = subprocess.run(
        [sys.executable, "-c", FIRST_READERS],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, "True\n"), done.stderr
