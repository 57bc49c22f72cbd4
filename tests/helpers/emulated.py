"""Real robots in tests: programs reach an emulator at the other end of the wire."""

from contextlib import contextmanager
from functools import partial
from importlib import import_module

from learnblock.emulators import TWINS, Emulation, Twin, emulate
from learnblock.robots import find, settings
from learnblock.testing import Relay
from twins_time import follow

#: The timeout in seconds of a driver whose robot answers. A busy machine may stop an emulator for
#: seconds.
LONG = 20.0


#: How much faster than real time a quick world runs.
SPEED = 4


@contextmanager
def quick(name, monkeypatch):
    """Emulate a robot in a quick world, whose time is that of programs; yield the emulation."""
    twin = Twin(TWINS[name], "empty", speed=SPEED)
    make = import_module(f"learnblock.emulators.{name}").Emulator
    with Emulation(partial(make, twin), twin) as emulation:
        follow(twin, monkeypatch)
        emulation.settings = {**emulation.settings, "patience": LONG}
        yield emulation


@contextmanager
def emulating(make, robot, world="empty", *, speed=1, start=None):
    """Emulate a robot by `make(twin)`; yield the emulation, which also has the `emulator`."""
    emulators = []

    def begin():
        emulators.append(make(twin))
        return emulators[0]

    twin = Twin(robot, world, speed=speed, start=start)
    with Emulation(begin, twin) as emulation:
        emulation.settings = {**emulation.settings, "patience": LONG}
        emulation.emulator = emulators[0]
        yield emulation


@contextmanager
def on_a_link(emulation):
    """Put a link that can fail before an emulator; yield emulation, relay and settings."""
    host, _, port = emulation.settings["address"].rpartition(":")
    with Relay((host, int(port))) as relay:
        address = f"127.0.0.1:{relay.port}"
        yield emulation, relay, {**emulation.settings, "address": address, "patience": 2.0}


def unproven(certificate):
    """Return what a robot that passes does not prove, for lack of the part."""
    assert certificate.passed
    return [finding.claim for finding in certificate.findings if finding.outcome != "holds"]


@contextmanager
def reachable(name, world="empty"):
    """Emulate a robot, and write the settings for reaching it; yield the twin."""
    with emulate(name, world) as emulation:
        settle(name, {**emulation.settings, "patience": LONG})
        yield emulation.twin


def settle(name, values):
    """Write the settings of a robot."""
    kind = find(name).load().settings_type
    for setting, value in values.items():
        # As typed by a user.
        typed = list(value) if isinstance(value, tuple) else value
        text = value if isinstance(value, str) else repr(typed)
        settings.change(name, kind, setting, text)
