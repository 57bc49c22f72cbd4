"""Regular calls that reset a robot's watchdog and detect a lost connection."""

import threading
from collections.abc import Callable

from learnblock.errors import RobotConnectionError
from learnblock.timing import MONOTONIC, SteadyClock

#: Seconds between two beats; our script stops the motors after three missed beats.
PERIOD = 0.1


class Heartbeat:
    """A thread that calls `beat` until it fails or is stopped.

    Args:
        beat: called with each beat.
        clock: the clock of the beats.
    """

    def __init__(self, beat: Callable[[], None], clock: SteadyClock = MONOTONIC) -> None:
        self._beat = beat
        self._clock = clock
        self._error: RobotConnectionError | None = None
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._run, name="heartbeat", daemon=True)
        self._thread.start()

    def check(self) -> None:
        """Check that no beat has failed.

        Raises:
            RobotConnectionError: the last beat failed.
        """
        if self._error:
            phrase = self._error.phrase
            raise RobotConnectionError(phrase.code, **phrase.values)

    def stop(self) -> None:
        """Stop the thread."""
        self._stopped.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._clock.wait(self._stopped, PERIOD):
            try:
                self._beat()
            except RobotConnectionError as error:
                self._error = error
                return
