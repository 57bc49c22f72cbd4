"""Calls regularly: so a robot hears that its program lives, and we notice when it is gone."""

import threading
from collections.abc import Callable

from learnblock.errors import RobotConnectionError

#: Seconds between two beats: three of them fit into the time after which our script stops.
PERIOD = 0.1


class Heartbeat:
    """A thread that calls `beat` until it fails or is stopped."""

    def __init__(self, beat: Callable[[], None]) -> None:
        self._beat = beat
        self._error: RobotConnectionError | None = None
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._run, name="heartbeat", daemon=True)
        self._thread.start()

    def check(self) -> None:
        """Say why it has failed, if it has.

        Raises:
            RobotConnectionError: what the last beat raised.
        """
        if self._error:
            raise RobotConnectionError(str(self._error))

    def stop(self) -> None:
        """Beat no more."""
        self._stopped.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._stopped.wait(PERIOD):
            try:
                self._beat()
            except RobotConnectionError as error:
                self._error = error
                return
