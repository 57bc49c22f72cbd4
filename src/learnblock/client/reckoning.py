"""The pose of a base that can't measure it."""

import threading
from collections.abc import Callable
from copy import copy

from learnblock.client.clock import Clock
from learnblock.devices import Pose
from learnblock.wheels import Odometry


class Reckoning:
    """Reckons a pose from the speeds that were commanded and the time in between.

    It starts at (0, 0) with heading 0. Reading it changes nothing, and neither does the same
    command again: not even the last digit depends on how often that happens. It notices neither
    slip nor an obstacle in the way, so its error grows faster than that of odometry, which counts
    what the wheels really do.

    Args:
        move: the function that drives the base: mm/s forward and degrees/s clockwise.
        clock: the robot's time.
    """

    def __init__(self, move: Callable[[float, float], None], clock: Clock) -> None:
        #: What really drives the base.
        self.driver = move
        self._clock = clock
        self._since = clock.time()
        self._speed = (0.0, 0.0)
        self._odometry = Odometry()
        # An observer reads the pose while the program drives.
        self._lock = threading.Lock()

    def move(self, adv: float, rot: float) -> None:
        """Drive the base, and reckon with this speed from now on."""
        self.driver(adv, rot)
        with self._lock:
            if (adv, rot) != self._speed:
                self._proceed(self._odometry)
                self._since = self._clock.time()
                self._speed = adv, rot

    def pose(self) -> Pose:
        """(x mm, y mm, heading in degrees from -180 to 180, clockwise)."""
        with self._lock:
            now = copy(self._odometry)
            self._proceed(now)
            return now.pose

    def _proceed(self, odometry: Odometry) -> None:
        """Add what has been driven since the last change of speed."""
        seconds = self._clock.time() - self._since
        adv, rot = self._speed
        odometry.proceed(adv * seconds, rot * seconds)
