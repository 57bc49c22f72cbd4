"""The simulated world of a program's robot, as its host controls it."""

import threading
from contextlib import AbstractContextManager, nullcontext
from typing import Protocol

from learnblock.client import Client
from learnblock.devices import Base
from learnblock.runtime.brake import Brake
from learnblock.runtime.debugger import Debugger, Holdable
from learnblock.runtime.pacing import Pacing


class Simulation(Protocol):
    """The interface of a simulated world for the host."""

    dt: float
    seed: int
    pacing: Pacing
    #: Held during each step and each call of a device, so that others can read in between.
    lock: AbstractContextManager[object]

    @property
    def steps(self) -> int:
        """The number of steps made so far."""

    def advance(self, step: int) -> None:
        """Advance until `steps` is `step`."""


class World:
    """The world of one program: none on a real robot, and none before the program has a robot.

    Args:
        debugger: pauses the world together with the program.
    """

    def __init__(self, debugger: Debugger | None) -> None:
        self.simulation: Simulation | None = None
        self._debugger = debugger
        self._entering = threading.Lock()
        self._speed: tuple[float | None] | None = None

    def enter(self, client: Client) -> None:
        """Take the world of the robot that the program has just created."""
        with self._entering:
            self.simulation = vars(client).get("simulation")
            if self.simulation and self._speed:
                self.simulation.pacing.set_factor(*self._speed)
            if self._debugger:
                self._debugger.govern(self._held_with(client))

    def set_speed(self, factor: float | None) -> None:
        """Set how fast the world runs, times real time; None is unlimited. Thread-safe.

        Before there is a world, the speed applies to the world that the program will enter.
        """
        with self._entering:
            self._speed = (factor,)
            if self.simulation:
                self.simulation.pacing.set_factor(factor)

    def end(self) -> None:
        """Stop waiting for real time: the run is being stopped."""
        if self.simulation:
            self.simulation.pacing.end()

    @property
    def exclusive(self) -> AbstractContextManager[object]:
        """Exclusive access to the simulated world; on a real robot, does nothing."""
        return self.simulation.lock if self.simulation else nullcontext()

    def _held_with(self, client: Client) -> Holdable:
        if self.simulation:
            return self.simulation.pacing
        return Brake([device for _, device in client.devices() if isinstance(device, Base)])
