"""Let programs use the time of the world at the other end of their wire.

A busy machine then slows program and world alike, so that their paths can be compared.
"""

from twins import let_pass


class TwinsClock:
    """A client's clock that shows the time of a twin's world."""

    instant = None

    def __init__(self, twin):
        self._twin, self._began = twin, twin.time

    def time(self):
        return self._twin.time - self._began

    def sleep(self, seconds):
        let_pass(self._twin, seconds)

    def charge(self):
        """Do nothing: a real access takes time anyway."""


def follow(twin, monkeypatch):
    """Let robots and programs of this process use the time of a twin's world."""
    # A world that is late does not catch up, because its robot could not keep up.
    monkeypatch.setattr("learnblock.runtime.pacing.SLIP", 0.0)
    monkeypatch.setattr("learnblock.client.client.WallClock", lambda: TwinsClock(twin))
    monkeypatch.setattr(
        "learnblock.runtime.remote._HostedWallClock", lambda wire, noting: TwinsClock(twin)
    )
