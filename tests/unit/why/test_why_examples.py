"""Every example leaves the same trace with a log, and its world can be shown again exactly."""

import pytest

from learnblock import robots
from learnblock.robots.simulated import Simulation
from learnblock.why.world_again import WorldAgain
from logged_runs import logged_example
from runs import FEW, TASKS, able_twin

NAMES = sorted(TASKS)
#: Every so many steps the world is compared.
STRIDE = 61


def conditions(name):
    """A robot that can run an example, its world and a few seconds."""
    return able_twin(name), {"world": TASKS[name][0], "seconds": FEW}


def shown(robot):
    """All that a simulated robot's devices, and a look at it, tell."""
    readings = [
        (type(device).__name__, key, device.functions["read"]())
        for key, device in robot.devices()
        if "read" in device.functions and type(device).__name__ != "Camera"
    ]
    views = [robot.body.view(camera.key).picture().tobytes() for camera in cameras(robot)]
    body = robot.body
    return repr((body.pose, body.distance_driven, body.emotion, body.leds, readings)), views


def cameras(robot):
    return robot.body.description.camera


@pytest.mark.sample(6)
@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_a_log_leaves_the_trace_as_it_is(made, name):
    robot, options = conditions(name)
    plain = made(name, robot, **options).report
    logged = logged_example(name, robot, **options).report
    assert logged.trace_sha256 == plain.trace_sha256


@pytest.mark.sample(6)
@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_any_moment_of_a_world_is_shown_again_exactly(name, monkeypatch):
    robot, options = conditions(name)
    seen = {}
    advance = Simulation.advance

    def look(simulation, step, given_up=None):
        while simulation.steps < step:
            # Now the program has done all that it does at this moment.
            if simulation.steps % STRIDE == 0:
                seen[simulation.steps] = shown(simulation.client)
            advance(simulation, simulation.steps + 1, given_up)

    def enter(client):
        client.simulation.client = client

    monkeypatch.setattr(Simulation, "advance", look)
    connect = robots.find(robot).load().connect
    monkeypatch.setattr(
        robots.find(robot).load(), "connect", lambda client: (connect(client), enter(client))[0]
    )
    recorded = logged_example(name, robot, **options).recorded
    monkeypatch.undo()

    world = WorldAgain(recorded)
    # Back and forth, as a person drags.
    order = sorted(seen, key=lambda step: (step % 5, step))
    assert len(order) >= int(recorded.ending["time"] * 100) // STRIDE
    assert {step: shown(world.seek(step / 100)) for step in order} == seen
