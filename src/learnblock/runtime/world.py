"""The simulated world of a program's robot, as its host controls it."""

import math
import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from typing import Protocol

from learnblock.client import Client
from learnblock.devices import Base
from learnblock.runtime.brake import Brake
from learnblock.runtime.debugger import Debugger, Holdable
from learnblock.runtime.pacing import Pacing

#: Seconds in which a world makes a step, even on a busy computer.
_STEP = 5.0


class HostedSimulation(Protocol):
    """The interface of a simulated world for the host."""

    dt: float
    seed: int
    pacing: Pacing
    #: Held during each step and each call of a device, so that others can read in between.
    lock: AbstractContextManager[object]

    @property
    def steps(self) -> int:
        """The number of steps made so far."""

    @property
    def is_over(self) -> bool:
        """Whether its game has ended."""

    def advance(self, step: int, given_up: threading.Event | None = None) -> None:
        """Advance until `steps` is `step`, until the game ends, or until `given_up` is set."""


class ProgramWorld:
    """The world of one program: none on a real robot, and none before the program has a robot.

    Args:
        debugger: pauses the world together with the program.
    """

    def __init__(self, debugger: Debugger | None) -> None:
        self.simulation: HostedSimulation | None = None
        #: Whether no other program is in it, which would have to be woken.
        self.is_private = True
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

    @contextmanager
    def running_by_itself(self, seconds: float | None) -> Iterator[None]:
        """Let the time of a paced world pass while its program waits for a person.

        A world without a speed limit waits too: it could run any distance ahead.

        Args:
            seconds: the world's time at which the run ends; None for no limit.
        """
        simulation = self.simulation
        if simulation is None or simulation.pacing.factor is None or not self.is_private:
            yield
            return
        last = math.inf if seconds is None else round(seconds / simulation.dt)
        ended = threading.Event()
        thread = threading.Thread(
            target=_advance, args=(simulation, last, ended), name="world", daemon=True
        )
        thread.start()
        try:
            yield
        finally:
            ended.set()
            # It may be paused, which must not keep the program from going on.
            simulation.pacing.wake()
            # It makes one step more.
            thread.join(_STEP)

    @property
    def exclusive(self) -> AbstractContextManager[object]:
        """Exclusive access to the simulated world; on a real robot, does nothing."""
        return self.simulation.lock if self.simulation else nullcontext()

    def _held_with(self, client: Client) -> Holdable:
        if self.simulation:
            return self.simulation.pacing
        return Brake([device for _, device in client.devices() if isinstance(device, Base)])


def _advance(simulation: HostedSimulation, last: float, ended: threading.Event) -> None:
    while not ended.is_set() and simulation.steps < last and not simulation.is_over:
        simulation.advance(simulation.steps + 1, ended)
