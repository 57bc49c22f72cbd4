import json
import re
import subprocess
import sys
from types import ModuleType, SimpleNamespace

import pytest

from learnblock.runtime.process import ThreadWorker
from learnblock.runtime.standalone import main_program

# A simulated robot small enough for a test, as a module next to the program.
TINY = """
from learnblock.client import Client
from learnblock.devices import Base, DistanceSensors
from learnblock.runtime.lockstep import LockStepClock
from learnblock.runtime.standalone import trace_main_program
from learnblock.runtime.usertime import use_robot_time
from pathlib import Path
import random

class Robot(Client):
    steps = 0
    def __init__(self):
        super().__init__(skills=[], clock=LockStepClock(self.wait, 0, 0.01))
        random.seed(7)
        self.restore = use_robot_time(self.clock)
        self.end = trace_main_program(self, Path("trace.jsonl"))
    def conditions(self):
        return {"robot": "tiny"}
    def wait(self, steps):
        self.steps += steps
        return self.steps
    def connect(self):
        self.add(Base(move=lambda adv, rot: None))
        self.add(DistanceSensors(read=lambda: {"front": [float(self.steps)]}))
    def disconnect(self):
        self.restore()
        self.end()
"""

PROGRAM = """
import random, time
from learnblock.devices import Base, DistanceSensors

def drive(speed):
    robot.device(Base).move(speed, 0)
    time.sleep(0.25)

for speed in range(3):
    drive(speed * 10)
    print(random.random(), robot.read(DistanceSensors))
"""


def alone(tmp_path, source):
    """Return the trace of a standalone program."""
    (tmp_path / "tiny.py").write_text(TINY)
    (tmp_path / "program.py").write_text(source)
    done = subprocess.run(
        [sys.executable, "program.py"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    trace = (tmp_path / "trace.jsonl").read_text().splitlines()
    return done, [json.loads(line) for line in trace]


HEADER = "from tiny import Robot\nrobot = Robot()\n"


def test_a_program_without_a_host_has_the_same_trace(tmp_path, run):
    done, trace = alone(tmp_path, HEADER + PROGRAM)
    hosted = run(PROGRAM)
    assert trace[1:] == hosted.events[1:]
    assert done.stdout == hosted.output


@pytest.mark.parametrize(
    ("source", "how"),
    [
        ("", "finished"),
        ("robot.stop()\nprint('bye')", "finished"),
        ("1 / 0", "error"),
        ("with robot: 1 / 0", "error"),
        ("with robot: pass", "finished"),
    ],
)
def test_a_trace_ends_like_the_program_standalone_and_hosted(tmp_path, run, source, how):
    _, trace = alone(tmp_path, HEADER + source)
    assert trace[-1] == {"t": 0.0, "end": how}
    assert trace[1:] == run(source, worker=ThreadWorker).events[1:]


def test_lines_of_a_function_that_creates_the_robot_are_traced(tmp_path):
    source = "from tiny import Robot\ndef main():\n    robot = Robot()\n    x = 1\nmain()\ny = 2\n"
    _, trace = alone(tmp_path, source)
    assert [event["line"] for event in trace if "line" in event] == [4, 6]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows ends a process without a signal")
def test_a_program_ended_in_the_middle_of_a_wait_says_how_long_it_has_run(tmp_path):
    (tmp_path / "program.py").write_text(
        "import os, signal, threading\n"
        "from learnblock.robots.sim_ebo import Robot\n"
        "robot = Robot(world='empty', pace='real')\n"
        "end = lambda: os.kill(os.getpid(), signal.SIGTERM)\n"
        "threading.Timer(0.4, end).start()\n"
        "robot.move_straight(100)\n"
        "robot.sleep(60)\n"
    )
    command = [sys.executable, "program.py"]
    done = subprocess.run(command, cwd=tmp_path, stderr=subprocess.PIPE, text=True, check=False)
    seconds, driven = re.findall(r"([\d.]+) s, (\d+) mm", done.stderr)[0]

    assert float(seconds) > 0.1
    # It needs an eighth of a second to speed up.
    assert int(driven) == pytest.approx(100 * (float(seconds) - 0.0625), abs=3)


@pytest.mark.parametrize("in_marimo", [False, True])
def test_a_notebook_of_marimo_is_no_program_although_it_has_a_file(monkeypatch, in_marimo):
    main = ModuleType("__main__")
    main.__file__, main.__spec__ = "square.py", None
    monkeypatch.setitem(sys.modules, "__main__", main)
    assert main_program() == "square.py"
    marimo = SimpleNamespace(running_in_notebook=lambda: in_marimo)
    monkeypatch.setitem(sys.modules, "marimo", marimo)
    assert main_program() == (None if in_marimo else "square.py")
