"""iRobot's robots in tests: an emulated one, on a link that can fail."""

from contextlib import contextmanager
from importlib import import_module

from emulated import emulating, on_a_link


@contextmanager
def emulated(name, world="empty", *, speed=1):
    """Emulate a robot; the emulation also has the emulated `robot`."""
    make = import_module(f"learnblock.emulators.{name}").Emulator
    with emulating(make, f"sim-{name}", world, speed=speed) as emulation:
        emulation.robot = emulation.emulator.robot
        yield emulation


@contextmanager
def relayed(name, **others):
    """Emulate a robot on a link that can fail; yield emulation, relay and settings."""
    with emulated(name, **others) as emulation, on_a_link(emulation) as linked:
        yield linked
