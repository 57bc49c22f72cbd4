"""Stops a robot whose program was killed.

Some robots have no watchdog: they keep driving after their last command, even when the program is
gone. The driver of such a robot starts a guardian, a small process that waits for the driver's end:

    self.guardian = Guardian(type(self), self.settings)      in `connect`
    self.guardian.dismiss()                                  in `disconnect`, after the motors stop
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

#: Seconds for which to retry a robot that does not respond, and seconds between attempts.
#: It must not retry longer, because another program may be using the robot by then.
TRIES_FOR, PAUSE = 5.0, 0.1


class Guardian:
    """A process that stops the robot's motors when this process exits for any reason.

    Args:
        robot: the class whose `halt` stops the motors.
        settings: how to reach the robot.
    """

    def __init__(self, robot: type[RealRobot[Any]], settings: RobotSettings) -> None:
        command = [sys.executable, "-P", "-m", __name__, robot.__module__]
        self._process = subprocess.Popen(  # noqa: S603 - our own interpreter and module
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            # A signal to our whole process group, as from a closed terminal, must not end it.
            start_new_session=True,
        )
        assert self._process.stdin is not None  # noqa: S101 - for the type checker
        self._pipe = self._process.stdin
        self._pipe.write(msgspec.json.encode(settings) + b"\n")
        self._pipe.flush()

    def dismiss(self) -> None:
        """End the guardian because the motors have stopped; calling it twice is harmless."""
        self._process.kill()
        self._process.wait()
        self._pipe.close()

    def leave_in_charge(self) -> None:
        """Let the guardian stop the motors; it retries for some seconds and then exits."""
        self._pipe.close()
        threading.Thread(target=self._process.wait, name="guardian", daemon=True).start()


def _guard(module: str) -> None:
    # Ctrl-C is meant for the program; the guardian starts working when the program ends.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    robot: Any = robots.find(module).load()
    settings = msgspec.json.decode(sys.stdin.buffer.readline(), type=robot.settings_type)
    # Returns when the other end closes; only the driver has it, so it closes with the driver.
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
