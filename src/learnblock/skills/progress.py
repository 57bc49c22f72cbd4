"""How fast a robot moves towards its target, and noticing that it is stuck."""

import math
from dataclasses import dataclass

#: Seconds after which a robot that makes no progress is stuck.
PATIENCE = 3.0
#: Seconds between two commands; at 10 degrees/s a robot turns a fifth of a degree meanwhile.
PERIOD = 0.02


@dataclass(frozen=True, slots=True, kw_only=True)
class Pace:
    """The speeds of a movement, in mm/s or degrees/s; its way is in mm or degrees.

    Args:
        gain: the speed for each unit of the way that remains.
        slowest: below it some robots do not move at all.
        fastest: the highest speed.
        speeding_up: by which two commands differ at most while the robot speeds up. A pose that is
            reckoned from the commands takes for granted that the robot can follow them.
        slowing_down: by which two commands differ at most while the robot slows down: one that is
            too fast to follow them would pass its target.
    """

    gain: float
    slowest: float
    fastest: float
    speeding_up: float
    slowing_down: float

    def speed(self, remaining: float, before: float) -> float:
        """The next speed, with the sign of what remains.

        Args:
            remaining: the way that remains.
            before: the previous speed.
        """
        magnitude = min(max(self._braking(abs(remaining)), self.slowest), self.fastest)
        magnitude = min(magnitude, abs(before) + self.speeding_up)
        return math.copysign(magnitude, remaining)

    def _braking(self, remaining: float) -> float:
        """The speed from which the robot can still stop within a way.

        Close to the target it is in proportion to the way, as it brakes less and less. Further away
        it is the speed of a constant deceleration, which meets the other one without a bend.
        """
        deceleration = self.slowing_down / PERIOD
        close = deceleration / self.gain**2
        if remaining <= close:
            return self.gain * remaining
        return math.sqrt(2 * deceleration * (remaining - close / 2))

    @property
    def least_progress(self) -> float:
        """The shortest way that a robot that is not stuck covers within `PATIENCE`."""
        return self.slowest * PATIENCE / 10

    def time_limit(self, way: float) -> float:
        """The most seconds that a robot that is not stuck needs for a way."""
        return 5 + abs(way) / self.slowest


class Progress:
    """The progress of a movement.

    Args:
        least: what a robot that is not stuck covers at least within `PATIENCE`, in the unit of the
            measured values.
    """

    def __init__(self, least: float) -> None:
        self._least = least
        self._since, self._from = 0.0, math.inf
        #: Whether the robot has made no progress for so long.
        self.is_stuck = False

    def note(self, time: float, measured: float) -> None:
        """Note a value that was measured at a time in s, while the robot was told to move."""
        if abs(measured - self._from) >= self._least:
            self._since, self._from = time, measured
        self.is_stuck = time - self._since >= PATIENCE
