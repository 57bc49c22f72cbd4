"""Driving a simulated robot by hand; its world advances only while something moves."""

import math
import threading
from time import monotonic

from learnblock.devices import Pose
from learnblock.robots.simulated import Simulation
from learnblock.runtime.pacing import Pacing
from learnblock.simulator import RobotBody

#: Seconds after the last command until the robot stops, because the page may be gone.
TIMEOUT = 0.5
#: An object that moves less than this in a step, in mm or degrees, is at rest.
STANDSTILL = 1e-3
#: Seconds in which a world makes a step, even on a busy computer.
_STEP = 5.0


class ManualDrive:
    """A joystick for a robot in a world in which no program runs.

    A thread advances the world in real time from the first command until everything is at rest.

    Args:
        simulation: the world.
        body: the robot.
    """

    def __init__(self, simulation: Simulation, body: RobotBody) -> None:
        self._simulation = simulation
        self._body = body
        self._state = threading.Lock()
        self._until = 0.0
        self._moves = self._closed = False
        self._thread: threading.Thread | None = None

    def command(self, adv: float, rot: float) -> None:
        """Set the target speed forward (mm/s) and rotation (degrees/s, clockwise positive).

        Raises:
            ValueError: one of them is not a finite number.
        """
        with self._simulation.lock:
            self._body.drive(adv, rot)
        with self._state:
            self._until = monotonic() + TIMEOUT
            if self._thread is None and not self._closed:
                self._thread = threading.Thread(target=self._run, name="hand", daemon=True)
                self._thread.start()

    def close(self) -> None:
        """Stop the robot and the world."""
        with self._state:
            self._closed, thread = True, self._thread
        if thread:
            # It makes one step more; if that hangs, the world is left to it.
            thread.join(_STEP)
        with self._simulation.lock:
            self._body.drive(0, 0)

    def _run(self) -> None:
        world, pacing = self._simulation.world, Pacing(1.0)
        while self._goes_on():
            pacing.wait(world.time)
            with self._simulation.lock:
                self._step()

    def _goes_on(self) -> bool:
        with self._state:
            is_held = monotonic() < self._until
            if self._closed or not (is_held or self._moves):
                self._thread = None
                return False
            return True

    def _step(self) -> None:
        if monotonic() >= self._until:
            self._body.drive(0, 0)
        before = self._poses()
        self._simulation.world.step()
        self._moves = any(map(_differ, before, self._poses()))

    def _poses(self) -> list[Pose]:
        world = self._simulation.world
        things = [pushed.pose for pushed in world.physics.pushed]
        return [
            *(robot.pose for robot in world.robots.values()),
            *((pose.x, pose.y, pose.heading) for pose in things),
        ]


def _differ(before: Pose, after: Pose) -> bool:
    return any(
        not math.isclose(a, b, abs_tol=STANDSTILL) for a, b in zip(before, after, strict=True)
    )
