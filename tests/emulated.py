"""Real robots in tests: an emulator at the other end of the wire, which programs then reach."""

from contextlib import contextmanager

from learnblock.emulators import emulate
from learnblock.robots import find, settings


@contextmanager
def reachable(name, world="empty"):
    """Emulate a robot, and have the user's settings lead to it; answers the twin."""
    kind = find(name).load().settings_type
    with emulate(name, world) as emulation:
        for setting, value in emulation.settings.items():
            text = value if isinstance(value, str) else repr(value)
            settings.change(name, kind, setting, text)
        yield emulation.twin
