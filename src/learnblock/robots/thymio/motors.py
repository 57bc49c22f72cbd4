"""A Thymio's motors, which have to be told again and again that they are to turn."""

import threading
from contextlib import suppress

from learnblock.errors import RobotConnectionError
from learnblock.robots.thymio.link import Link
from learnblock.robots.thymio.program import DRIVE

#: Seconds between two commands; the robot stops by itself after `program.LIVES` ticks without.
REPEATING = 0.1
#: Seconds in which the robot should have noted that it is to stand before we let go of it.
STANDING = 0.3


class Motors:
    """Keeps a Thymio going: its watchdog stops it unless the last command is repeated.

    Args:
        link: to the robot.
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
        """Turn the wheels at these motor speeds, -500 to 500, until told otherwise.

        The same speeds again are left to the repetition: a program that asks a thousand times a
        second would keep the cable from all else.

        Raises:
            RobotConnectionError: the robot is gone.
        """
        with self._telling:
            if (left, right) == self._speeds == (0, 0):
                # Whoever stands can be left alone, even when another program has the robot now.
                return
            self._link.check()
            if (left, right) != self._speeds:
                self._speeds = left, right
                self._link.tell(DRIVE, left, right)

    def close(self) -> None:
        """Repeat no more, and wait a moment for the robot to say that it stands."""
        self._closed.set()
        self._thread.join()
        # A robot that is gone has nothing to say, and stands still by itself.
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
                # Whoever uses the robot next is told; without us it stands still.
                return

    def _tell_again(self) -> None:
        with self._telling:
            if self._speeds != (0, 0):
                self._link.tell(DRIVE, *self._speeds)
