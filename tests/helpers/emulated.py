"""Real robots in tests: programs reach an emulator at the other end of the wire."""

from contextlib import contextmanager

from learnblock.emulators import emulate
from learnblock.robots import find, settings

#: The timeout in seconds of a driver whose robot answers. A busy machine may stop an emulator for
#: seconds.
LONG = 20.0


@contextmanager
def reachable(name, world="empty"):
    """Emulate a robot, and write the settings for reaching it; yield the twin."""
    with emulate(name, world) as emulation:
        settle(name, {**emulation.settings, "patience": LONG})
        yield emulation.twin


def settle(name, chosen):
    """Write the settings of a robot."""
    kind = find(name).load().settings_type
    for setting, value in chosen.items():
        # As typed by a user.
        typed = list(value) if isinstance(value, tuple) else value
        text = value if isinstance(value, str) else repr(typed)
        settings.change(name, kind, setting, text)
