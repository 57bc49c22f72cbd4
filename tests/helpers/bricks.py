"""EV3 bricks in tests: an emulated one for each kind of connection, and fast worlds."""

from contextlib import contextmanager
from functools import partial

import pytest

from emulated import emulating
from learnblock.devices import Base, DistanceSensors, GroundSensors, Gyroscope
from learnblock.emulators.ev3 import Emulator
from learnblock.testing import Relay
from twins import stands_after
from waiting import wait_for

WAYS = ("agent", "rpyc", "direct")
#: How much faster than real time a quick world runs.
SPEED = 6


@contextmanager
def brick(way, world="empty", *, speed=1, start=None):
    """Emulate a brick."""
    make = partial(Emulator, connection=way)
    with emulating(make, "sim-ev3", world, speed=speed, start=start) as emulation:
        emulation.brick = emulation.emulator.brick
        yield emulation


@contextmanager
def relayed(way, **others):
    """Emulate a brick behind a wire that can fail; yield emulation, relay and settings.

    The timeout is short, because the wire will fail, except for rpyc, which is slow.
    """
    with brick(way, **others) as emulation:
        settings = emulation.settings
        port = port_of(settings)
        with Relay((settings["address"], settings[port])) as relay:
            patience = 1.2 if way == "rpyc" else 0.8
            yield emulation, relay, {**settings, port: relay.port, "patience": patience}


def port_of(settings):
    """Return the name of the setting for the port of the connection."""
    return f"{settings['connection']}_port"


def assert_reads_what_the_twin_does(robot, twin):
    """Turn a robot of LEGO's, and compare its sensors with those of its twin."""
    base = robot.device(Base)
    base.move(0, 30)
    wait_for(lambda: robot.read(Gyroscope, "Z_AXIS") > 20, "a turn")
    base.stop()
    stands_after(twin)
    with twin.body() as body:
        front, ground, angle = body.distances()["front"], body.ground(), body.gyroscope()
    assert robot.device(DistanceSensors).read()["front"][0] == pytest.approx(front[0], rel=0.05)
    assert robot.device(GroundSensors).read()["central"] == pytest.approx(ground["central"], abs=6)
    assert robot.device(Gyroscope, "Z_AXIS").read() == pytest.approx(angle, abs=1.5)
