"""The last digits of sines, cosines and the physics: they differ between computers."""

import math
import random
from types import SimpleNamespace

import pytest

from learnblock.simulator import World, chassis, geometry
from runs import WORLDS, run_example, run_file

PRINTS = """from learnblock.robots.sim_thymio import Robot

robot = Robot()

robot.set_move(80, 25)
for _ in range(30):
    robot.sleep(0.1)
    print(robot.get_pose(), robot.get_min_distance(), robot.get_light())
"""


def another_computer(monkeypatch):
    """Change the last digit of everything that the simulator computes with angles."""
    numbers = random.Random(1)  # noqa: S311 - repeatable

    def nudged(value):
        return value * (1 + numbers.choice((-2, -1, 0, 1, 2)) * 2**-53)

    def nudging(function):
        return lambda *values: nudged(function(*values))

    functions = {name: nudging(getattr(math, name)) for name in ("sin", "cos", "hypot", "atan2")}
    nudged_math = SimpleNamespace(**{**vars(math), **functions})
    step = World.step

    def nudged_step(world):
        for robot in world.robots.values():
            body = robot.chassis._body
            body.angle, body.velocity = nudged(body.angle), tuple(map(nudged, body.velocity))
        step(world)

    monkeypatch.setattr(chassis, "math", nudged_math)
    monkeypatch.setattr(geometry, "math", nudged_math)
    monkeypatch.setattr(World, "step", nudged_step)


@pytest.mark.parametrize("name", ["avoid.bt", "line-ebo.bt"])
def test_an_example_leaves_the_same_trace_on_a_computer_with_other_last_digits(name, monkeypatch):
    options = {"world": WORLDS.get(name), "seconds": 4}
    here = run_example(name, "sim-ebo", **options).report.trace_sha256
    another_computer(monkeypatch)
    assert run_example(name, "sim-ebo", **options).report.trace_sha256 == here


def test_a_program_that_prints_its_readings_prints_the_same_there(tmp_path, monkeypatch):
    program = tmp_path / "program.py"
    program.write_text(PRINTS)
    here = run_file(program, "sim-thymio").entries("print")
    another_computer(monkeypatch)
    assert run_file(program, "sim-thymio").entries("print") == here
