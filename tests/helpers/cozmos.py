"""Cozmos in tests: an emulator, its twin, and a wire that can fail before the driver."""

from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from typing import Any

import pytest

from learnblock.client.clock import WallClock
from learnblock.emulators.twin import Twin
from learnblock.robots import connect, settings
from learnblock.testing import Relay
from waiting import wait_for

pytest.importorskip("pycozmo", reason="pip install 'learnblock-studio[cozmo]'")

from learnblock.emulators.cozmo import Emulator
from learnblock.robots.cozmo import CozmoSettings


@dataclass
class Cozmo:
    """An emulated Cozmo."""

    twin: Twin
    machine: Any
    wire: Relay

    @property
    def port(self) -> int:
        return self.wire.port

    def robot(self, **chosen: Any) -> Any:
        """Connect the driver over the wire."""
        return connect("cozmo", **{"address": "127.0.0.1", "port": self.port, **chosen})

    def is_default(self) -> None:
        """Write the settings for reaching it."""
        for name, text in (("address", "127.0.0.1"), ("port", str(self.port))):
            settings.change("cozmo", CozmoSettings, name, text)

    def pose(self) -> tuple[float, float, float]:
        with self.twin.body() as body:
            return body.pose

    def speed(self) -> float:
        """Return the speed in mm/s over a tenth of a second."""
        began, (x, y, _) = self.twin.time, self.pose()
        wait_for(lambda: self.twin.time >= began + 0.1, "time passes")
        later_x, later_y, _ = self.pose()
        return ((later_x - x) ** 2 + (later_y - y) ** 2) ** 0.5 / (self.twin.time - began)


@contextmanager
def cozmo(world: str = "empty", *, speed: float = 1.0, loss: float = 0.0) -> Iterator[Cozmo]:
    """A Cozmo in a world that runs at `speed` times real time."""
    with (
        Twin("sim-cozmo", world, speed=speed) as twin,
        closing(Emulator(twin)) as emulator,
        Relay(("127.0.0.1", emulator.settings["port"]), udp=True) as wire,
    ):
        wire.loss = loss
        yield Cozmo(twin, emulator.machine, wire)


class FastClock(WallClock):
    """The time of a program whose robot is faster than real time."""

    speed = 4.0

    def time(self) -> float:
        return super().time() * self.speed

    def sleep(self, seconds: float) -> None:
        super().sleep(seconds / self.speed)
