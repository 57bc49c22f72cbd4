"""The robot's time while its program waits for a person."""

import pytest

from learnblock import robots
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.program import Program
from learnblock.runtime.watcher import Watcher
from waiting import wait_for

pytestmark = pytest.mark.realtime

#: A reaction game, whose robot drives while it waits.
GAME = """from learnblock.robots.sim_ebo import Robot

robot = Robot()
robot.move_straight(100)
robot.sleep(0.5)
before = robot.clock.time()
place = robot.get_pose()[0]
input("now!")
print(round(robot.clock.time() - before, 2))
print(robot.get_pose()[0] - place > 10)
robot.sleep(0.1)
"""


class Person(Watcher):
    """Answers once the robot's world has reached a step; the question comes at step 50."""

    def __init__(self, step):
        self.run, self.step, self.text = None, step, ""

    def input(self, prompt):
        # The world runs already, so it may have passed step 50.
        world = self.run.client.simulation
        wait_for(lambda: world.steps >= self.step, "the world's time goes on")
        return ""

    def printed(self, text):
        self.text += text


def played(step, pace, **options):
    person = Person(step)
    program = Program("game.py", GAME, GAME)
    job = Job(program, robots.find("sim-ebo"), Options(world="empty", pace=pace, **options))
    run = ProgramRun(job, watcher=person)
    person.run = run
    return run.run(), person.text.split()


@pytest.mark.slow
def test_at_pace_real_the_time_of_a_robot_passes_while_its_program_waits_for_a_person():
    report, (reaction, has_moved) = played(90, "10")
    assert report.error is None
    assert float(reaction) >= 0.4
    assert has_moved == "True"


@pytest.mark.slow
def test_a_run_may_end_by_its_time_while_its_program_waits():
    report, _ = played(100, "10", seconds=1.0)
    assert report.ended == "time limit"
    assert report.time == pytest.approx(1.0)


@pytest.mark.certain
def test_at_free_pace_time_stands_still_and_the_same_answers_leave_the_same_trace():
    first, (reaction, has_moved) = played(0, "free")
    second, _ = played(0, "free")
    assert (reaction, has_moved) == ("0.0", "False")
    assert first.trace_sha256 == second.trace_sha256
