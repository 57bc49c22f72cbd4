"""Real robots in tests: an emulator at the other end of the wire, which programs then reach."""

from contextlib import contextmanager

from learnblock.emulators import emulate
from learnblock.robots import find, settings


@contextmanager
def reachable(name, world="empty"):
    """Emulate a robot, and have the user's settings lead to it; answers the twin."""
    with emulate(name, world) as emulation:
        settle(name, emulation.settings)
        yield emulation.twin


def settle(name, chosen):
    """Have the user's settings lead to a robot."""
    kind = find(name).load().settings_type
    for setting, value in chosen.items():
        # As it would be typed.
        typed = list(value) if isinstance(value, tuple) else value
        text = value if isinstance(value, str) else repr(typed)
        settings.change(name, kind, setting, text)
