"""A real driver and its wire against the twin's own run, and wires that fail."""

import math
from itertools import pairwise
from time import monotonic

import pytest

from learnblock.errors import RobotConnectionError
from learnblock.robots import find, settings
from learnblock.testing import Fault, Relay
from runs import run_example

PATIENCE = 0.5


def settle(name, chosen):
    """Have the user's settings lead to a robot."""
    kind = find(name).load().settings_type
    for setting, value in chosen.items():
        text = value if isinstance(value, str) else repr(value)
        settings.change(name, kind, setting, text)


def assert_drives_like_its_twin(name, emulator, twin, example, *, seconds, tolerance):
    """Run an example through driver and wire; how far from the twin's own path it gets, in mm.

    Answers the emotions that were shown.
    """
    emulated = emulator(twin)
    try:
        settle(name, emulated.settings)
        finished = run_example(example, name, seconds=seconds)
    finally:
        emulated.close()
    assert finished.report.error is None
    world = twin._simulation.world.description.name
    own = run_example(example, "sim-ebo", world=world, seconds=1.3 * seconds * twin.speed)
    assert off(twin.path, own.recorder.path) < tolerance
    shown = finished.report.emotions
    assert set(shown) - set(own.report.emotions) <= {"sadness"}
    return shown


def off(driven, own):
    """How far the one path is from the other at most."""
    own = [pose[:2] for _, pose in own]
    legs = [leg for leg in pairwise(own) if leg[0] != leg[1]]
    return max(min(away(pose[:2], leg) for leg in legs) for _, pose in driven[::3])


def away(point, leg):
    """How far a point is from a straight leg."""
    (x, y), (to_x, to_y) = leg
    along_x, along_y = to_x - x, to_y - y
    part = ((point[0] - x) * along_x + (point[1] - y) * along_y) / (along_x**2 + along_y**2)
    part = min(max(part, 0), 1)
    return math.dist(point, (x + part * along_x, y + part * along_y))


def assert_told_when_gone(kind, chosen, setting, *, sentence, fault, use):
    """What a component says when its wire fails, also at the beginning; it goes on afterwards."""
    with Relay(("127.0.0.1", port_of(chosen, setting))) as relay:
        through = {**with_port(chosen, setting, relay.port), "patience": PATIENCE}
        robot = kind(**through)
        use(robot)
        relay.fault = fault
        assert_told(sentence, lambda: use(robot))
        relay.fault = Fault.NONE
        use(robot)
        robot.stop()
        relay.fault = fault
        assert_told(sentence, lambda: kind(**through))


def assert_told(sentence, call):
    began = monotonic()
    with pytest.raises(RobotConnectionError, match=f"{sentence} robot `.*cannot be reached"):
        call()
    # Twice its patience, as it may have to connect anew.
    assert monotonic() - began < 2 * PATIENCE + 1


def port_of(chosen, setting):
    """The port that a setting holds; the first one where it holds several."""
    found = chosen[setting]
    return found if isinstance(found, int) else found[0]


def with_port(chosen, setting, port):
    """The settings with another port there."""
    found = chosen[setting]
    return {**chosen, setting: port if isinstance(found, int) else [port, *found[1:]]}
