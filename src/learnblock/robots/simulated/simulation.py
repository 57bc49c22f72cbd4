"""A world that advances at a pace and reports what happens in it."""

import threading

from learnblock.client import Witness
from learnblock.devices import Pose
from learnblock.runtime.pacing import Pacing
from learnblock.simulator import World, WorldEvent

#: Steps between two entries of a robot's path: 0.1 s.
STEPS_PER_POSE = 10


class Simulation:
    """A world with its pace, and the receivers of its events.

    Args:
        world: the world.
        pacing: how fast it runs; free by default.
    """

    def __init__(self, world: World, pacing: Pacing | None = None) -> None:
        self.world = world
        self.pacing = pacing or Pacing()
        self.dt = world.dt
        self.seed = world.seed
        #: Held while the world changes; other threads take it to read the world.
        self.lock = threading.RLock()
        #: Receive the poses of a robot, by its name, and the world's goals.
        self.witnesses: dict[str, Witness] = {}
        self._placed: list[tuple[str, float, Pose]] = []

    @property
    def steps(self) -> int:
        """The number of steps so far."""
        return self.world.steps

    def time(self) -> float:
        """The world's time in seconds."""
        return self.world.time

    def advance(self, step: int, given_up: threading.Event | None = None) -> None:
        """Advance, no faster than the pace allows, until `steps` is `step`.

        Args:
            step: the number of steps.
            given_up: ends this early, see `Pacing.wait`.
        """
        while self.world.steps < step:
            self.pacing.wait(self.world.time, given_up)
            if given_up and given_up.is_set():
                return
            with self.lock:
                self.world.step()
                self._report()

    def place(self, name: str, x: float, y: float, heading: float) -> None:
        """Lift a robot and set it down elsewhere (mm, mm, degrees); may be called from any thread.

        Raises:
            ValueError: one of them is not a finite number.
        """
        with self.lock:
            self.world.robots[name].place(x, y, heading)
            # Reported with the next step, because only one thread writes a trace.
            self._placed.append((name, self.world.time, (x, y, heading)))

    def _report(self) -> None:
        for name, time, pose in self._placed:
            if name in self.witnesses:
                self.witnesses[name].placed(time, pose)
        self._placed.clear()
        for event in self.world.take_events():
            self._report_goal(event)
        if self.world.steps % STEPS_PER_POSE == 0:
            for name, witness in self.witnesses.items():
                witness.pose(self.world.time, self.world.robots[name].pose)

    def _report_goal(self, event: WorldEvent) -> None:
        kind, _, state = event.kind.partition("-")
        if kind != "goal":
            return
        for name, witness in self.witnesses.items():
            # A missed goal was missed by all robots.
            if event.other in ("", name):
                witness.goal(event.time, event.subject, state)


class WorldClock:
    """The clock of a robot whose program waits elsewhere; it can only be read."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation

    @property
    def instant(self) -> int:
        return self._simulation.steps

    def time(self) -> float:
        return self._simulation.time()

    def sleep(self, seconds: float) -> None:
        raise NotImplementedError(f"a robot that others advance cannot sleep {seconds} s")

    def charge(self) -> None:
        """Do nothing: the host that advances the world adds this time."""
