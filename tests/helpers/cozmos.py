"""Cozmos in tests: an emulator, its twin, and a wire that can fail before the driver."""

from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from typing import Any

import pytest

import twins
from emulated import LONG
from learnblock.client.clock import WallClock
from learnblock.emulators.twin import Twin
from learnblock.robots import connect, settings
from learnblock.testing import Relay

pytest.importorskip("pycozmo", reason="the add-on cozmo is not installed")

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

    def robot(self, **options: Any) -> Any:
        """Connect the driver over the wire."""
        return connect("cozmo", **{**self._place, **options})

    def is_default(self) -> None:
        """Write the settings for reaching it."""
        for name, value in self._place.items():
            settings.change("cozmo", CozmoSettings, name, str(value))

    def pose(self) -> tuple[float, float, float]:
        return twins.pose(self.twin)

    def speed(self) -> float:
        return twins.speed(self.twin)

    @property
    def _place(self) -> dict[str, Any]:
        return {"address": "127.0.0.1", "port": self.port, "patience": LONG}


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
