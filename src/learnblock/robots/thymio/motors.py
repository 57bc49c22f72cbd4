"""A Thymio's motors, which need their command repeatedly, and the way that they have driven."""

import threading
from contextlib import suppress

from learnblock.devices import Pose
from learnblock.errors import RobotConnectionError
from learnblock.robots.thymio.link import ThymioLink
from learnblock.robots.thymio.program import DRIVE
from learnblock.timing import MONOTONIC, Deadline, SteadyClock
from learnblock.wheels import Odometry, Wheels

#: Seconds between two commands; without one the robot stops after `program.LIVES` ticks.
REPEATING = 0.1
#: Seconds between two looks at the wheels' speeds.
COUNTING = 0.02
#: Seconds to wait for the robot to stop before the connection is closed.
STANDING = 0.3


class Motors:
    """Repeats the last command, because the robot's watchdog would otherwise stop it.

    Between two commands it adds up the speeds that the motors measure, which gives the pose.

    Args:
        link: the link to the robot.
        track: mm between the wheels.
        unit: mm/s of a wheel at motor speed 1.
        clock: the clock of the repetitions.
    """

    def __init__(
        self, link: ThymioLink, track: float, unit: float, clock: SteadyClock = MONOTONIC
    ) -> None:
        self._link = link
        self._clock = clock
        self._unit = unit
        self._speeds = (0, 0)
        self._odometry = Odometry(track)
        self._counted: tuple[float, Wheels] = (clock.now(), (0.0, 0.0))
        self._counting = threading.Lock()
        # A stop must not be overtaken by the repetition of an earlier command.
        self._telling = threading.Lock()
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._repeat, name="thymio motors", daemon=True)
        self._thread.start()

    def drive(self, left: int, right: int) -> None:
        """Turn the wheels at these motor speeds, -500 to 500, until the next command.

        A command with unchanged speeds is not sent at once: a program that drives a thousand times
        per second would block the cable.

        Raises:
            RobotConnectionError: the connection is lost.
        """
        with self._telling:
            if (left, right) == self._speeds == (0, 0):
                # Nothing to send, even if another program is using the robot now.
                return
            self._link.check()
            if (left, right) != self._speeds:
                self._speeds = left, right
                self._link.tell(DRIVE, left, right)

    def pose(self) -> Pose:
        """The pose by the measured speeds, relative to the start of the connection.

        Raises:
            RobotConnectionError: the connection is lost.
        """
        with self._counting:
            self._count()
            return self._odometry.pose

    def close(self) -> None:
        """Stop repeating, and wait briefly for the robot to stop."""
        self._closed.set()
        self._thread.join()
        # A lost robot stops by itself.
        with suppress(RobotConnectionError):
            self._link.wait(self._stands, STANDING)

    def _stands(self) -> bool:
        targets = self._link.read("motor.left.target") + self._link.read("motor.right.target")
        return targets == (0, 0)

    def _repeat(self) -> None:
        again = Deadline.after(REPEATING, self._clock)
        while not self._clock.wait(self._closed, min(COUNTING, again.left)):
            try:
                with self._counting:
                    self._count()
                if again.is_over:
                    again = Deadline.after(REPEATING, self._clock)
                    self._tell_again()
            except RobotConnectionError:
                # The next use of the robot raises it again; without commands it stops.
                return

    def _count(self) -> None:
        """Process the way since the last look, at the mean of both speeds."""
        since, (left_before, right_before) = self._counted
        now = self._clock.now()
        (left,), (right,) = (
            self._link.read("motor.left.speed"),
            self._link.read("motor.right.speed"),
        )
        scale = self._unit * (now - since) / 2
        self._odometry.roll((left_before + left) * scale, (right_before + right) * scale)
        self._counted = now, (left, right)

    def _tell_again(self) -> None:
        with self._telling:
            if self._speeds != (0, 0):
                self._link.tell(DRIVE, *self._speeds)
