"""A Thymio's motors, which need their command repeatedly."""

import threading
from contextlib import suppress

from learnblock.errors import RobotConnectionError
from learnblock.robots.thymio.link import Link
from learnblock.robots.thymio.program import DRIVE

#: Seconds between two commands; without one the robot stops after `program.LIVES` ticks.
REPEATING = 0.1
#: Seconds to wait for the robot to stop before the connection is closed.
STANDING = 0.3


class Motors:
    """Repeats the last command, because the robot's watchdog would otherwise stop it.

    Args:
        link: the link to the robot.
    """

    def __init__(self, link: Link) -> None:
        self._link = link
        self._speeds = (0, 0)
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
        while not self._closed.wait(REPEATING):
            try:
                self._tell_again()
            except RobotConnectionError:
                # The next use of the robot raises it again; without commands it stops.
                return

    def _tell_again(self) -> None:
        with self._telling:
            if self._speeds != (0, 0):
                self._link.tell(DRIVE, *self._speeds)
