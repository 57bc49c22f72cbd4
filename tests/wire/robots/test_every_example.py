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
    """The devices and abilities whose absence prevents an example from running on a robot."""
    found = running.check(running.read(EXAMPLES / name), robots.find(robot))
    needs = [one.message.values["devices"] for one in found if one.severity == "error"]
    named = [device.values for devices in needs for device in devices]
    return {f"{one['kind']}:{one['key']}".rstrip(":") for one in named}


@pytest.mark.parametrize(("name", "robot"), list(itertools.product(NAMES, sorted(TWINS))))
def test_an_example_runs_on_a_real_robot_or_is_refused_by_naming_the_missing_device(name, robot):
    lacking = missing(name, robot)
    if lacking:
        assert not robots.find(robot).load().known_equipment() & lacking
        return
    with reachable(robot, WORLDS.get(name, "empty")):
        report = run_example(name, robot, seconds=SECONDS, worker=ProcessWorker).report
    if report.ended == "error":
        # Its devices are known only once it is connected: it is refused before the first line.
        assert robots.find(robot).load().known_equipment() is None
        assert report.error["message"].values["problem"].code.startswith("check-skill-")
        assert report.time == 0
    else:
        assert report.ended in {"finished", "time limit"}
