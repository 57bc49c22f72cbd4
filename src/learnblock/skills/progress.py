"""Noticing that a robot is stuck: it is told to move, and what it measures stays the same."""

import math

#: Seconds after which a robot that does not get on is stuck.
PATIENCE = 3.0


class Progress:
    """How a movement gets on.

    Args:
        least: what a robot that is not stuck covers at least within `PATIENCE`, in the unit of the
            measured values.
    """

    def __init__(self, least: float) -> None:
        self._least = least
        self._since, self._from = 0.0, math.inf
        #: Whether the robot has not got on for so long.
        self.is_stuck = False

    def note(self, time: float, measured: float) -> None:
        """Note a value that was measured at a time in s, while the robot was told to move."""
        if abs(measured - self._from) >= self._least:
            self._since, self._from = time, measured
        self.is_stuck = time - self._since >= PATIENCE
