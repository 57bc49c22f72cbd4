"""What a robot reports over Bluetooth, from the thread of the connection to that of the program."""

import threading
from collections.abc import Callable
from typing import Generic, TypeVar

from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.robots.bluetooth.radio import Radio
from learnblock.timing import MONOTONIC, SteadyClock

State = TypeVar("State")

#: Seconds without a report until a robot counts as gone, if it reports ten times a second or more.
SILENCE = 2.0
#: Seconds for which a report is new enough to be a reading.
FRESH = 0.1


class ReportLink(Generic[State]):
    """The last report of a robot that reports by itself, and the first error.

    Args:
        radio: the connection.
        clock: the clock of its limits.

    Attributes:
        changed: notified with each report and error, and when what a driver waits for has changed.
    """

    def __init__(self, radio: Radio, clock: SteadyClock = MONOTONIC) -> None:
        self.changed = threading.Condition()
        self._radio = radio
        self._clock = clock
        self._heard = clock.now()
        self._state: State | None = None
        self._error: LearnBlockError | None = None
        self._is_closed = False

    @property
    def place(self) -> str:
        """Where the robot is, for errors."""
        return self._radio.loop.place

    @property
    def signal(self) -> int | None:
        """How strong the robot's radio was when it was found, dBm."""
        return self._radio.signal

    @property
    def known(self) -> State | None:
        """The last report, however old."""
        return self._state

    def note(self, state: State) -> None:
        """Take a report."""
        with self.changed:
            self._state, self._heard = state, self._clock.now()
            self.changed.notify_all()

    def fail(self, error: LearnBlockError) -> None:
        """Take an error; the first is raised from now on."""
        with self.changed:
            self._error = self._error or error
            self.changed.notify_all()

    def wait_for(self, predicate: Callable[[], bool], seconds: float) -> bool:
        """Wait until something holds, which `changed` is notified of; return whether it does.

        Raises:
            LearnBlockError: there is an error.
        """
        with self.changed:
            holds = self._clock.wait_for(
                self.changed, lambda: predicate() or bool(self._error), seconds
            )
            if self._error:
                raise self._error
            return holds

    def latest(self) -> State:
        """A report that is at most 0.1 s old.

        Raises:
            RobotConnectionError: the robot does not report any more.
        """
        with self.changed:
            is_there = self._clock.wait_for(self.changed, self._is_fresh, SILENCE)
            self.check()
            if not is_there or self._state is None:
                raise RobotConnectionError("robot-link-silent", place=self.place)
            return self._state

    def check(self) -> None:
        """Check that the robot reports.

        Raises:
            RobotConnectionError: it does not, or there is an error.
        """
        with self.changed:
            self._radio.check()
            if self._error:
                raise RobotConnectionError(self._error.phrase.code, **self._error.phrase.values)
            if self._is_closed:
                raise RobotConnectionError("robot-link-closed", place=self.place)
            if self._clock.now() - self._heard > SILENCE:
                raise RobotConnectionError("robot-link-silent", place=self.place)

    def close(self) -> None:
        """Let `check` say from now on that the connection is closed."""
        self._is_closed = True

    def _is_fresh(self) -> bool:
        is_new = self._state is not None and self._clock.now() - self._heard < FRESH
        return is_new or bool(self._error)
