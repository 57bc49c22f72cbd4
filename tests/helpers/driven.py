"""Compare a real driver and its wire with the twin's own run, also on wires that fail."""

import threading

import pytest

from emulated import LONG, settle
from learnblock import running
from learnblock.errors import RobotConnectionError
from learnblock.robots import find
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.process import ThreadWorker
from learnblock.testing import Fault, Relay
from runs import EXAMPLES, run_example
from twins import off
from twins_time import follow

#: Seconds, short because the wire will fail.
TIMEOUT = 0.8


def assert_drives_like_its_twin(name, emulator, twin, example, monkeypatch, *, until, tolerance):
    """Run an example through driver and wire until something has happened to the twin.

    `tolerance` is the allowed distance from the twin's own path, in mm. Returns the emotions shown.
    """
    follow(twin, monkeypatch)
    emulated = emulator(twin)
    try:
        settle(name, {**emulated.settings, "patience": LONG})
        report = run_until(lambda: until(twin), name, example)
    finally:
        emulated.close()
    assert report.error is None or report.ended == "stopped"
    assert until(twin), f"it {report.ended} before: {report.error}"
    world = twin._simulation.world.description.name
    own = run_example(example, "sim-ebo", world=world, seconds=twin.time)
    driven = [pose for _, pose in twin.path[::3]]
    assert off(driven, [pose for _, pose in own.recorder.path]) < tolerance
    assert set(report.emotions) <= set(own.report.emotions)
    return report.emotions


def run_until(happened, name, example):
    """Run an example until something has happened, or for a minute; return the report."""
    entry = find(name)
    program = running.program(running.read(EXAMPLES / example), entry)
    run = ProgramRun(Job(program, entry, Options(seconds=60)), worker=ThreadWorker)
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


def assert_told_when_gone(kind, settings, setting, *, sentence, fault, use):
    """Return the error of a component whose wire fails, even at the start; it works afterwards."""
    with Relay(("127.0.0.1", port_of(settings, setting))) as relay:
        through = {**with_port(settings, setting, relay.port), "patience": TIMEOUT}
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
    with pytest.raises(RobotConnectionError, match=f"{sentence} 127"):
        call()


def port_of(settings, setting):
    """Return the port in a setting; the first one if there are several."""
    ports = settings[setting]
    return ports if isinstance(ports, int) else ports[0]


def with_port(settings, setting, port):
    """Return the settings with another port in it."""
    ports = settings[setting]
    return {**settings, setting: port if isinstance(ports, int) else [port, *ports[1:]]}
