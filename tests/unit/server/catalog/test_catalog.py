"""The choices that the page offers."""

import subprocess
import sys

ASK = """
import sys
from learnblock.server.catalog import welcome

told = {choice.name: choice.simulated for choice in welcome("").robots}
assert told["sim-ebo"] and not told["ebo"], told
print(*(name for name in sys.modules if name.startswith("learnblock.robots.")))
"""


def test_the_list_of_robots_loads_no_driver():
    done = subprocess.run(
        [sys.executable, "-c", ASK], capture_output=True, text=True, check=True
    ).stdout.split()
    assert "learnblock.robots.sim_ebo" in done
    assert {
        "learnblock.robots.ebo",
        "learnblock.robots.cozmo",
        "learnblock.robots.real",
    }.isdisjoint(done)
