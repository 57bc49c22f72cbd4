"""EV3 bricks in tests: an emulated one for each kind of connection, and fast worlds."""

import socket
import threading
import time
from contextlib import contextmanager

from learnblock.emulators import Emulation
from learnblock.emulators.ev3 import Emulator
from learnblock.emulators.twin import Twin
from learnblock.testing import Relay

WAYS = ("agent", "rpyc", "direct")
#: How much faster than real time a quick world runs.
SPEED = 6


@contextmanager
def brick(way, world="empty", *, speed=1, start=None):
    """Emulate a brick; the timeout is short, except for rpyc, which is slow."""
    emulators = []

    def begin():
        emulators.append(Emulator(twin, connection=way))
        return emulators[0]

    twin = Twin("sim-ev3", world, speed=speed, start=start)
    with Emulation(begin, twin) as emulation:
        emulation.settings = {**emulation.settings, "patience": 1.2 if way == "rpyc" else 0.8}
        emulation.brick = emulators[0].brick
        yield emulation


@contextmanager
def relayed(way, **others):
    """Emulate a brick behind a wire that can fail; yield emulation, relay and settings."""
    with brick(way, **others) as emulation:
        settings = emulation.settings
        port = port_of(settings)
        with Relay((settings["address"], settings[port])) as relay:
            yield emulation, relay, {**settings, port: relay.port}


def port_of(settings):
    """Return the name of the setting for the port of the connection."""
    return f"{settings['connection']}_port"


def x_of(twin):
    """Return how far the twin has moved along x, in mm."""
    with twin.body() as body:
        return body.pose[0]


def stands_after(twin):
    """Return the seconds of the world until the twin stops."""
    began = twin.time
    last, since = x_of(twin), began
    deadline = time.monotonic() + 5
    while twin.time < since + 0.3:
        assert time.monotonic() < deadline, "it does not stand"
        if abs(x_of(twin) - last) > 0.05:
            last, since = x_of(twin), twin.time
        time.sleep(0.002)
    return since - began


@contextmanager
def mute_server():
    """Start a server that accepts connections and sends nothing; return its port."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        held = []
        listener.settimeout(0.05)
        ended = threading.Event()

        def take():
            while not ended.is_set():
                try:
                    held.append(listener.accept()[0])
                except TimeoutError:
                    continue

        thread = threading.Thread(target=take)
        thread.start()
        try:
            yield listener.getsockname()[1]
        finally:
            ended.set()
            thread.join()
            for one in held:
                one.close()
