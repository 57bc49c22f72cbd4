"""Stops a robot whose program was killed, or whose computer froze the program.

Some robots have no watchdog: they keep driving after their last command, even when the program is
gone. The driver of such a robot starts a guardian, a small process that stops the motors when the
driver ends, or gives no sign of life for half a second:

    self.guardian = Guardian(type(self), self.settings)      in `connect`
    self.guardian.check()                                    in `check_link`, and before driving
    self.guardian.dismiss()                                  in `disconnect`, after the motors stop

A guardian that has stopped the motors ends. A driver that wakes up again gets an error from
`check`, which ends its run, because the robot is not where the program expects it.
"""

import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import IO, Any

import msgspec

from learnblock import robots
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import RobotSettings
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Seconds for which to retry a robot that does not respond, and seconds between attempts.
#: It must not retry longer, because another program may be using the robot by then.
TRIES_FOR, PAUSE = 5.0, 0.1
#: Seconds between two signs of life of a driver.
PERIOD = 0.1
#: The guardian waits for signs of life in steps of this length (in s), and stops the motors after
#: this many steps without any: half a second. A step counts as one, no matter how long it took, so
#: that a guardian that was frozen itself, as by a suspended computer, hears its driver first.
STEP, SILENT_STEPS = 0.05, 10
#: The same for a driver that computes: the thread that gives the signs of life may have to wait for
#: the others. A driver that is stuck for this long counts as frozen.
BUSY_STEPS = 40
#: Seconds to wait for the thread that gives the signs of life.
PATIENCE = 1.0

#: Waits this many seconds for signs of life; None if there are none, b"" if the driver has ended.
Hear = Callable[[float], bytes | None]


# Why: docs/decisions.md, "A real robot stops when its program ends or is paused"
class Guardian:
    """A process that stops the robot's motors when this process exits for any reason, or freezes.

    Args:
        robot: the class whose `halt` stops the motors.
        settings: how to reach the robot.
        clock: the clock of the signs of life.
    """

    def __init__(
        self,
        robot: type[RealRobot[Any]],
        settings: RobotSettings,
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        command = [sys.executable, "-P", "-m", __name__, robot.__module__]
        self._robot = robot.name()
        self._process = subprocess.Popen(  # noqa: S603 - our own interpreter and module
            command,
            bufsize=0,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            # A signal to our whole process group, as from a closed terminal, must not end it.
            start_new_session=True,
        )
        assert self._process.stdin is not None  # noqa: S101 - for the type checker
        self._process.stdin.write(msgspec.json.encode(settings) + b"\n")
        self._signs = SignsOfLife(self._process.stdin, clock)
        self._clock = clock
        self._stands_by = threading.Event()
        threading.Thread(target=self._hear, name="guardian", daemon=True).start()

    def wait_for_standby(self, seconds: float) -> None:
        """Wait until it could stop the motors at once, but no longer than so many seconds."""
        self._clock.wait(self._stands_by, seconds)

    def check(self) -> None:
        """Check that the guardian is watching, and has not stopped the motors.

        Raises:
            RobotConnectionError: it has stopped them, because this process was frozen for half a
                second, or it has ended by itself.
        """
        ended = None if self._signs.are_over else self._process.poll()
        if ended is not None:
            code = "robot-computer-froze" if ended == 0 else "robot-guardian-ended"
            raise RobotConnectionError(code, robot=self._robot)

    def dismiss(self) -> None:
        """End the guardian because the motors have stopped; calling it twice is harmless."""
        self._process.kill()
        self._process.wait()
        self._signs.end()

    def leave_in_charge(self) -> None:
        """Let the guardian stop the motors; it retries for some seconds and then exits."""
        self._signs.end()
        threading.Thread(target=self._process.wait, name="guardian", daemon=True).start()

    def _hear(self) -> None:
        assert self._process.stdout is not None  # noqa: S101 - for the type checker
        with self._process.stdout as output:
            if output.read(1):
                self._stands_by.set()


class SignsOfLife:
    """A thread that signals a guardian ten times a second that its driver is alive.

    Args:
        pipe: leads to the guardian.
        clock: the clock of the signs.
    """

    def __init__(self, pipe: IO[bytes], clock: SteadyClock = MONOTONIC) -> None:
        self._pipe = pipe
        self._clock = clock
        self._over = threading.Event()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._beat, name="signs of life", daemon=True)
        self._thread.start()

    @property
    def are_over(self) -> bool:
        """Whether they were ended."""
        return self._over.is_set()

    def end(self) -> None:
        """Stop, and close the pipe; calling it twice is harmless.

        A thread that can't write, because the guardian is frozen, is waited for only a second.
        """
        self._over.set()
        if self._clock.wait(self._ended, PATIENCE):
            self._thread.join()
        self._pipe.close()

    def _beat(self) -> None:
        try:
            while not self._clock.wait(self._over, PERIOD):
                self._pipe.write(b".")
        except OSError:
            # The guardian has ended; its `check` says so.
            return
        finally:
            self._ended.set()


def wait_for_silence(hear: Hear, is_busy: Callable[[], bool]) -> None:
    """Return when a driver has ended, or has given no sign of life for half a second.

    Args:
        hear: waits for signs of life.
        is_busy: whether the driver computes; it may then be silent for two seconds.
    """
    silent = 0
    while silent < SILENT_STEPS or (silent < BUSY_STEPS and is_busy()):
        sign = hear(STEP)
        if sign == b"":
            return
        silent = 0 if sign else silent + 1


def insist_on(halt: Callable[[], object], clock: SteadyClock) -> bool:
    """Try to stop the motors until it succeeds; return whether it did within `TRIES_FOR` seconds.

    Args:
        halt: stops them, or raises a `LearnBlockError`.
        clock: the clock of this limit.
    """
    deadline = Deadline.after(TRIES_FOR, clock)
    while not deadline.is_over:
        try:
            halt()
        except LearnBlockError:
            clock.sleep(min(PAUSE, deadline.left))
        else:
            return True
    return False


def _hearing(stream: int) -> Hear:
    """Hear what arrives from a descriptor; a thread reads it, as Windows can't wait for pipes."""
    arrived: queue.SimpleQueue[bytes] = queue.SimpleQueue()

    def read() -> None:
        data = b"."
        while data:
            data = os.read(stream, 1024)
            arrived.put(data)

    threading.Thread(target=read, name="hearing", daemon=True).start()

    def hear(seconds: float) -> bytes | None:
        try:
            return arrived.get(timeout=seconds)
        except queue.Empty:
            return None

    return hear


def is_busy(process: int) -> bool:
    """Whether a thread of a process computes or could; False where the system doesn't report it.

    A stopped process has no such thread, and neither has one that waits for swapped memory.
    """
    try:
        states = [file.read_text() for file in Path(f"/proc/{process}/task").glob("*/stat")]
    except OSError:
        # It, or one of its threads, has just ended.
        return False
    # The state follows the name in brackets.
    return any(text.rpartition(")")[2].split()[0] == "R" for text in states)


def _guard(module: str) -> bool:
    """Wait until the driver is silent, then stop the motors; return whether they were stopped."""
    # Ctrl-C is for the program; the guardian starts working when the program ends.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    robot: Any = robots.find(module).load()
    # Unbuffered, so that nothing is read ahead of the signs of life.
    with open(sys.stdin.fileno(), "rb", buffering=0, closefd=False) as stream:
        settings = msgspec.json.decode(stream.readline(), type=robot.settings_type)
    halt = robot.standby(settings)
    with suppress(OSError):
        # The driver may have ended meanwhile.
        os.write(sys.stdout.fileno(), b".")
    # The driver alone has the other end, so it closes with the driver.
    wait_for_silence(_hearing(sys.stdin.fileno()), partial(is_busy, os.getppid()))
    return insist_on(halt, MONOTONIC)


if __name__ == "__main__":
    sys.exit(0 if _guard(sys.argv[1]) else 1)
