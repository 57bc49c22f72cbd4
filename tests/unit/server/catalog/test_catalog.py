"""The choices that the page offers."""

import subprocess
import sys

from learnblock import robots, running
from learnblock.server.catalog import example

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


def test_polygons_opens_without_a_warning():
    source = running.read(running.example("polygons.bt"))
    assert running.check(source, robots.find(example("polygons").robot)) == []
