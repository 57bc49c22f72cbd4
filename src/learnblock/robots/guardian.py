"""Stops a robot when the program that drove it is gone without a word.

Some robots have no watchdog: they drive on until they are told otherwise, also when nobody is left
who could tell them. The driver of such a robot keeps a guardian, a small process of its own that
does nothing but wait for the driver's end:

    self.guardian = Guardian(type(self), self.settings)      in `connect`
    self.guardian.dismiss()                                  in `disconnect`, when the motors stand
"""

import signal
import subprocess
import sys
import threading
from time import monotonic
from typing import Any

import msgspec

from learnblock import robots
from learnblock.errors import LearnBlockError
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import RobotSettings

#: Seconds for which it tries to reach a robot whose link is gone as well, and between two tries.
#: Longer it must not try: by then somebody may drive the robot with another program.
TRIES_FOR, PAUSE = 5.0, 0.1


class Guardian:
    """A process that stops the robot's motors when this one ends, however it ends.

    Args:
        robot: whose `halt` stops the motors.
        settings: with which the robot is reached.
    """

    def __init__(self, robot: type[RealRobot[Any]], settings: RobotSettings) -> None:
        command = [sys.executable, "-P", "-m", __name__, robot.__module__]
        self._process = subprocess.Popen(  # noqa: S603 - our own interpreter and module
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            # What ends our whole group, such as a terminal that is closed, must not end it.
            start_new_session=True,
        )
        assert self._process.stdin is not None  # noqa: S101 - for the type checker
        self._pipe = self._process.stdin
        self._pipe.write(msgspec.json.encode(settings) + b"\n")
        self._pipe.flush()

    def dismiss(self) -> None:
        """All is well: it ends. The second time does nothing."""
        self._process.kill()
        self._process.wait()
        self._pipe.close()

    def leave_in_charge(self) -> None:
        """The motors could not be stopped from here: it tries for some seconds, and ends."""
        self._pipe.close()
        threading.Thread(target=self._process.wait, name="guardian", daemon=True).start()


def _guard(module: str) -> None:
    # Ctrl-C is for the program, whose end is our beginning.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    robot: Any = robots.find(module).load()
    settings = msgspec.json.decode(sys.stdin.buffer.readline(), type=robot.settings_type)
    # Returns when the other end is closed: nobody but the driver has it, and its death closes it.
    sys.stdin.buffer.read()
    deadline = monotonic() + TRIES_FOR
    while monotonic() < deadline:
        try:
            robot.halt(settings)
        except LearnBlockError:
            threading.Event().wait(PAUSE)
        else:
            return


if __name__ == "__main__":
    _guard(sys.argv[1])
