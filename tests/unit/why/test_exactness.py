"""What a log shows of any moment is what the run was like then, to the last digit and pixel."""

import pytest

from learnblock.running import Options
from learnblock.runtime.watcher import Watcher
from runs import EXAMPLES, TASKS, person
from truths import Job, differences, random_job, remembered

pytestmark = pytest.mark.spread

#: Examples for the fast tests: `scripts/bench exactness` looks at all, and at far more moments.
FEW = ("avoid.bt", "first/tag.bt", "flower.bt", "line-states.bt", "watch-out.bt")
SECONDS = 6


@pytest.mark.parametrize("name", FEW)
def test_an_example_is_shown_as_it_was(name):
    # EBO has no ground sensors, which watch-out.bt asks for.
    options = Options(world=TASKS[name][0], seconds=SECONDS, seed=1, anyway=True)
    run = remembered(Job(EXAMPLES / name, "sim-ebo", options), 12, 1, lambda: person(name))
    assert run.truths
    assert differences(run) == []


def test_a_drawing_goes_on_in_a_kept_world_where_its_robot_is():
    # Kept worlds begin after ten seconds.
    options = Options(world="flower", seconds=25, seed=1)
    run = remembered(Job(EXAMPLES / "flower.bt", "sim-ebo", options), 12, 1, Watcher)
    assert differences(run) == []


@pytest.mark.sample(8)
@pytest.mark.parametrize("seed", range(100, 120))
def test_a_random_program_is_shown_as_it_was(seed, tmp_path):
    run = remembered(random_job(tmp_path, seed), 8, seed, Watcher)
    assert differences(run) == []
