"""EV3 bricks in tests: an emulated one for each kind of connection, and fast worlds."""

from contextlib import contextmanager

from emulated import LONG
from learnblock.emulators import Emulation
from learnblock.emulators.ev3 import Emulator
from learnblock.emulators.twin import Twin
from learnblock.testing import Relay

WAYS = ("agent", "rpyc", "direct")
#: How much faster than real time a quick world runs.
SPEED = 6


@contextmanager
def brick(way, world="empty", *, speed=1, start=None):
    """Emulate a brick."""
    emulators = []

    def begin():
        emulators.append(Emulator(twin, connection=way))
        return emulators[0]

    twin = Twin("sim-ev3", world, speed=speed, start=start)
    with Emulation(begin, twin) as emulation:
        emulation.settings = {**emulation.settings, "patience": LONG}
        emulation.brick = emulators[0].brick
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
