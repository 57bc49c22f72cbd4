"""A simulated robot in real time, for an emulator to drive."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Self

from learnblock import robots
from learnblock.client import Witness
from learnblock.closing import Closing
from learnblock.devices import Pose
from learnblock.errors import LearnBlockError
from learnblock.robots.simulated import SimulatedRobot
from learnblock.simulator import RobotBody


class Twin(Closing, Witness):
    """A robot in a world that runs in real time: a context manager.

        with Twin("sim-cozmo", "tags") as twin:
            with twin.body() as body:
                body.drive(50, 0)

    Args:
        robot: the id of a simulated robot.
        world: a world's name or the path of its file; by default the robot's world.
        seed: the seed of all noise.
        start: (x mm, y mm, heading in degrees); by default the world's start pose.
        speed: a multiple of real time.

    Attributes:
        speed: a multiple of real time.
        path: (time s, pose) of the robot every 0.1 s.

    Raises:
        LearnBlockError: there is no such robot or world, or the world has no room.
    """

    def __init__(
        self,
        robot: str,
        world: str | None = None,
        *,
        seed: int = 0,
        start: Pose | None = None,
        speed: float = 1.0,
    ) -> None:
        kind = robots.find(robot).load()
        if not issubclass(kind, SimulatedRobot):
            raise LearnBlockError("emulator-not-simulated", robot=robot)
        self._simulation = kind.make_simulation(world=world, seed=seed, pace=speed)
        self._body = self._simulation.world.add_robot(kind.description(), start=start)
        self._simulation.witnesses[self._body.name] = self
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._live, name="twin", daemon=True)
        self.speed = speed
        self.path: list[tuple[float, Pose]] = []

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    @contextmanager
    def body(self) -> Iterator[RobotBody]:
        """The robot, while its world is paused."""
        with self._simulation.lock:
            yield self._body

    @property
    def time(self) -> float:
        """The time of its world in seconds."""
        return self._simulation.time()

    def goals(self) -> dict[str, bool]:
        """For each goal of the world, whether it has been reached."""
        with self._simulation.lock:
            return {goal.name: goal.reached_at is not None for goal in self._simulation.world.goals}

    def close(self) -> None:
        """Stop its world; calling it twice is harmless."""
        self._closed.set()
        self._simulation.pacing.end()
        if self._thread.is_alive():
            self._thread.join()

    # As the witness of its world. Its accelerometer reports how it is handled, `goals` reads the
    # goals, and a robot that is emulated has no pen.

    def pose(self, time: float, pose: Pose) -> None:
        self.path.append((time, pose))

    def placed(self, time: float, pose: Pose) -> None:
        """Record that a person moved the robot; it is part of the path."""
        self.path.append((time, pose))

    def _live(self) -> None:
        while not self._closed.is_set():
            self._simulation.advance(self._simulation.steps + 1)
