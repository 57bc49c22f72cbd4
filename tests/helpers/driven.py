"""Compare a real driver and its wire with the twin's own run, also on wires that fail."""

import math
import threading
from itertools import pairwise
from time import monotonic

import pytest

from emulated import settle
from learnblock import running
from learnblock.errors import RobotConnectionError
from learnblock.robots import find
from learnblock.running import Options, ProgramRun
from learnblock.runtime.process import ThreadWorker
from learnblock.testing import Fault, Relay
from runs import EXAMPLES, run_example
from twins_time import follow

TIMEOUT = 0.8


def assert_drives_like_its_twin(name, emulator, twin, example, monkeypatch, *, until, tolerance):
    """Run an example through driver and wire until something has happened to the twin.

    `tolerance` is the allowed distance from the twin's own path, in mm. Returns the emotions shown.
    """
    follow(twin, monkeypatch)
    emulated = emulator(twin)
    try:
        settle(name, emulated.settings)
        report = run_until(lambda: until(twin), name, example)
    finally:
        emulated.close()
    assert report.error is None or report.ended == "stopped"
    assert until(twin), f"it {report.ended} before: {report.error}"
    world = twin._simulation.world.description.name
    own = run_example(example, "sim-ebo", world=world, seconds=twin.time)
    assert off(twin.path, own.recorder.path) < tolerance
    assert set(report.emotions) <= set(own.report.emotions)
    return report.emotions


def run_until(happened, name, example):
    """Run an example until something has happened, or for a minute; return the report."""
    entry = find(name)
    program = running.program(running.read(EXAMPLES / example), entry)
    run = ProgramRun(program, entry, Options(seconds=60), worker=ThreadWorker)
    over = threading.Event()

    def stop_in_time():
        while not over.wait(0.05):
            if happened():
                run.stop()
                return

    watching = threading.Thread(target=stop_in_time)
    watching.start()
    try:
        return run.run()
    finally:
        over.set()
        watching.join()


def pose(twin):
    """Return the position of the twin."""
    with twin.body() as body:
        return body.pose


def emotion(twin):
    """Return the emotion on the twin's face."""
    with twin.body() as body:
        return body.emotion


def off(driven, own):
    """Return the largest distance between two paths."""
    own = [pose[:2] for _, pose in own]
    legs = [leg for leg in pairwise(own) if leg[0] != leg[1]]
    return max(min(away(pose[:2], leg) for leg in legs) for _, pose in driven[::3])


def away(point, leg):
    """Return the distance of a point from a straight line."""
    (x, y), (to_x, to_y) = leg
    along_x, along_y = to_x - x, to_y - y
    part = ((point[0] - x) * along_x + (point[1] - y) * along_y) / (along_x**2 + along_y**2)
    part = min(max(part, 0), 1)
    return math.dist(point, (x + part * along_x, y + part * along_y))


def assert_told_when_gone(kind, chosen, setting, *, sentence, fault, use):
    """Return the error of a component whose wire fails, even at the start; it works afterwards."""
    with Relay(("127.0.0.1", port_of(chosen, setting))) as relay:
        through = {**with_port(chosen, setting, relay.port), "patience": TIMEOUT}
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
    with pytest.raises(RobotConnectionError, match=f"{sentence} 127"):
        call()
    # Twice its timeout, because it may have to reconnect.
    assert monotonic() - began < 2 * TIMEOUT + 2


def port_of(chosen, setting):
    """Return the port in a setting; the first one if there are several."""
    found = chosen[setting]
    return found if isinstance(found, int) else found[0]


def with_port(chosen, setting, port):
    """Return the settings with another port in it."""
    found = chosen[setting]
    return {**chosen, setting: port if isinstance(found, int) else [port, *found[1:]]}
