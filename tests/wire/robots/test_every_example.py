"""Every example on every robot: it runs through the real driver and wire, or is refused."""

import itertools

import pytest

from emulated import reachable
from learnblock import robots, running
from learnblock.emulators import TWINS
from learnblock.runtime.process import ProcessWorker
from runs import EXAMPLES, WORLDS, run_example

NAMES = sorted(path.name for path in EXAMPLES.glob("*.bt"))
#: The seconds of each run, enough for all its devices to answer; the paper's programs are
#: run to the end in the tests of each robot.
SECONDS = 0.8

pytestmark = pytest.mark.spread


def missing(name, robot):
    """The devices whose absence prevents an example from running on a robot."""
    found = running.check(running.read(EXAMPLES / name), robots.find(robot))
    needs = [one.message.values["devices"] for one in found if one.severity == "error"]
    return sorted({device.values["kind"] for devices in needs for device in devices})


@pytest.mark.parametrize(("name", "robot"), list(itertools.product(NAMES, sorted(TWINS))))
def test_an_example_runs_on_a_real_robot_or_is_refused_by_naming_the_missing_device(name, robot):
    lacking = missing(name, robot)
    if lacking:
        devices = robots.find(robot).load().device_names()
        assert not {device.partition(":")[0] for device in devices} & set(lacking)
        return
    with reachable(robot, WORLDS.get(name, "empty")):
        finished = run_example(name, robot, seconds=SECONDS, worker=ProcessWorker)
    assert finished.report.error is None
    assert finished.report.ended in {"finished", "time limit"}
