"""A real robot stops while its program is paused."""

from learnblock.devices import Base
from learnblock.runtime.brake import Brake
from learnblock.runtime.debugger import Debugger
from listener import Listener

DRIVE = """from learnblock.devices import Base
base = robot.device(Base)
base.move(100, 5)
robot.time()
base.move(50, 0)
"""


class Wheels:
    def __init__(self):
        self.told = []
        self.base = Base(move=lambda adv, rot: self.told.append((adv, rot)))
        self.brake = Brake([self.base])


def test_a_brake_stops_the_wheels_and_releases_them():
    wheels = Wheels()
    wheels.base.move(100, 5)
    wheels.brake.pause()
    wheels.brake.resume()
    wheels.brake.resume()
    assert wheels.told == [(100, 5), (0, 0), (100, 5)]


def test_commands_under_the_brake_take_effect_afterwards():
    wheels = Wheels()
    wheels.brake.pause()
    wheels.base.move(100, 0)
    wheels.base.move(20, 0)
    assert wheels.told == [(0, 0)]
    wheels.brake.resume()
    assert wheels.told == [(0, 0), (20, 0)]


def test_a_stop_takes_effect_despite_the_brake():
    wheels = Wheels()
    wheels.base.move(100, 0)
    wheels.brake.pause()
    wheels.base.stop()
    wheels.brake.resume()
    assert wheels.told == [(100, 0), (0, 0), (0, 0), (0, 0)]


class Waits(Listener):
    """Records the robot's commands when its program pauses, and resumes it."""

    def __init__(self, stage, debugger):
        super().__init__()
        self.stage, self.debugger = stage, debugger
        self.log_when_held = []

    def held(self, line, variables):
        self.log_when_held = list(self.stage.results()[0].log)
        self.debugger.resume()


def test_a_real_robot_stops_at_a_breakpoint_and_continues_after_it(stage):
    debugger = Debugger(breakpoints=[6])
    watcher = Waits(stage, debugger)
    stage.add(DRIVE, real=True, debugger=debugger, watcher=watcher)
    stage.host().run()
    (result,) = stage.results()
    assert watcher.log_when_held == [("move", 100.0, 5.0), ("move", 0.0, 0.0)]
    assert [told[1] for told in result.log if told[0] == "move"] == [100.0, 0.0, 100.0, 50.0, 0.0]
    # The trace records the program's actions, not the brake's.
    moves = [event["args"] for event in result.events if event.get("do") == "move"]
    assert moves == [[100.0, 5.0], [50.0, 0.0], [0.0, 0.0]]
