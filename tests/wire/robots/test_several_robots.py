"""Real and simulated robots in one run: each real driver on its wire, and messages between all."""

import pytest

from emulated import reachable
from learnblock import robots, running
from learnblock.running import Job, Options
from learnblock.running.team import TeamRun
from learnblock.runtime.ending import How
from learnblock.runtime.watcher import Watcher

FIRST = """\
main:
    function.set_move(30, 0)
    function.sleep(0.3)
    function.stop_bot()
    while not function.received("ready"):
        function.send("baton", ["first", 1])
        function.sleep(0.05)
    end
end
"""
SECOND = """\
main:
    while not function.received("baton"):
        function.sleep(0.05)
    end
    print(function.message_value("baton"))
    function.send("ready")
    function.sleep(0.3)
end
"""


@pytest.fixture
def play(tmp_path):
    """Run two programs, each on its robot; return the report and what was printed."""

    def play(first, second):
        printed = []

        class Printing(Watcher):
            def printed(self, text):
                printed.append(text)

        jobs, options = {}, Options(world="empty", pace="real", seconds=60)
        for name, program, robot in (("first", FIRST, first), ("second", SECOND, second)):
            path = tmp_path / f"{name}.bt"
            path.write_text(program)
            entry = robots.find(robot)
            jobs[name] = Job(running.program(running.read(path), entry), entry, options)
        report = TeamRun(jobs, watch=lambda _: Printing()).run()
        return report, printed

    return play


@pytest.mark.parametrize(("first", "second"), [("thymio", "sim-ebo"), ("sim-thymio", "ev3")])
def test_a_real_and_a_simulated_robot_run_together(play, first, second):
    real = next(robot for robot in (first, second) if not robot.startswith("sim-"))
    with reachable(real, "empty"):
        report, printed = play(first, second)
    assert [own.error for own in report.robots.values()] == [None, None]
    assert [own.ended for own in report.robots.values()] == [How.FINISHED, How.FINISHED]
    assert printed == ["['first', 1]\n"]
    assert report.trace_sha256 is None


def test_two_real_robots_of_different_kinds_send_each_other_messages(play):
    with reachable("thymio", "empty"), reachable("ev3", "empty"):
        report, printed = play("thymio", "ev3")
    assert [own.ended for own in report.robots.values()] == [How.FINISHED, How.FINISHED]
    assert printed == ["['first', 1]\n"]
