"""The paper's listing 4 over the wires of iRobot's robots."""

import pytest

from emulated import LONG, settle
from irobots import emulated
from runs import run_example
from twins import let_pass
from twins_time import follow

#: How much faster than real time their worlds run.
SPEED = 3
#: Seconds for which it is watched after its program: to be at a place is to stay there.
STANDING = 5


@pytest.mark.spread
@pytest.mark.parametrize("name", ["root", "create3"])
def test_the_papers_square_reaches_its_goals(name, monkeypatch):
    with emulated(name, "square", speed=SPEED) as emulation:
        follow(emulation.twin, monkeypatch)
        settle(name, {**emulation.settings, "patience": LONG})
        report = run_example("square.bt", name, seconds=60).report
        let_pass(emulation.twin, STANDING)
        goals = emulation.twin.goals()
    assert report.error is None
    assert all(goals.values()), goals
