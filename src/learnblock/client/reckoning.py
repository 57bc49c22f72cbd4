"""The pose of a base that can't measure it."""

import math
import threading
from collections.abc import Callable

from learnblock.client.clock import Clock
from learnblock.devices import Pose
from learnblock.wheels import CONTROL_PERIOD, Drivetrain, Odometry

#: A part of a control period that only rounding leaves over.
_ROUNDING = 1e-6


class Reckoning:
    """Reckons a pose from the speeds that were commanded and the time in between.

    It starts at (0, 0) with heading 0. Reading it changes nothing, and neither does the same
    command again: not even the last digit depends on how often that happens. It notices neither
    slip nor an obstacle in the way, so its error grows faster than that of odometry, which counts
    what the wheels really do.

    A command that the robot can't follow, because its wheels turn slower or need time to speed up,
    is reckoned with what they do.

    Args:
        move: the function that drives the base: mm/s forward and degrees/s clockwise.
        clock: the robot's time.
        drivetrain: what the wheels can do; if None, they are taken to follow every command at once.
    """

    def __init__(
        self,
        move: Callable[[float, float], None],
        clock: Clock,
        drivetrain: Drivetrain | None = None,
    ) -> None:
        #: What really drives the base.
        self.driver = move
        self._clock = clock
        self._drivetrain = drivetrain
        self._since = clock.time()
        #: The speeds (adv, rot) at the last command, and those to which the wheels then change.
        self._before = self._target = (0.0, 0.0)
        #: How many control periods that change takes, with fractions.
        self._periods = 0.0
        self._odometry = Odometry()
        # An observer reads the pose while the program drives.
        self._lock = threading.Lock()

    def move(self, adv: float, rot: float) -> None:
        """Drive the base, and reckon with this speed from now on."""
        self.driver(adv, rot)
        target = self._drivetrain.reachable(adv, rot) if self._drivetrain else (adv, rot)
        with self._lock:
            if target != self._target:
                self._change(target)

    def pose(self) -> Pose:
        """(x mm, y mm, heading in degrees from -180 to 180, clockwise)."""
        with self._lock:
            now = self._odometry.copy()
            self._proceed(now)
            return now.pose

    def _proceed(self, odometry: Odometry) -> tuple[float, float]:
        """Add what has been driven since the last command, and return the present speed."""
        seconds = self._clock.time() - self._since
        speed = self._before
        for period in range(1, self._changing + 1):
            if seconds <= _ROUNDING * CONTROL_PERIOD:
                return speed
            speed = self._speed_in(period)
            span = min(seconds, CONTROL_PERIOD)
            odometry.proceed(speed[0] * span, speed[1] * span)
            seconds -= span
        if seconds <= _ROUNDING * CONTROL_PERIOD:
            return speed
        odometry.proceed(self._target[0] * seconds, self._target[1] * seconds)
        return self._target

    def _change(self, target: tuple[float, float]) -> None:
        """Begin to change from the present speed to another one."""
        self._before = self._proceed(self._odometry)
        self._since = self._clock.time()
        self._target = target
        if self._drivetrain:
            self._periods = self._drivetrain.periods(self._before, target)

    def _speed_in(self, period: int) -> tuple[float, float]:
        """The speed in the first, second, ... control period after the last command."""
        part = period / self._periods
        (adv, rot), (to_adv, to_rot) = self._before, self._target
        return adv + (to_adv - adv) * part, rot + (to_rot - rot) * part

    @property
    def _changing(self) -> int:
        """In how many control periods the wheels do not turn at their new speed yet."""
        return math.ceil(self._periods - _ROUNDING) - 1
