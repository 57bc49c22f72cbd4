"""The kinematics of two driven wheels.

Speeds are mm/s forward and degrees/s clockwise seen from above. With the wheels `track` mm apart
and the rotation r in rad/s, the left wheel runs at adv + r * track / 2 and the right one at
adv - r * track / 2.
"""

import math
from dataclasses import dataclass

#: Seconds between two changes of a wheel's speed while it accelerates.
CONTROL_PERIOD = 0.01
#: Makes the largest numbers small enough for calculations, and keeps them far beyond any motor.
_TINY = 1e-9

Wheels = tuple[float, float]
"""The ground speeds of the left and the right wheel, in mm/s."""


def wheel_speeds(adv: float, rot: float, track: float) -> Wheels:
    """The wheel speeds at which a robot moves at (adv, rot)."""
    difference = math.radians(rot) * track / 2
    return adv + difference, adv - difference


def body_speeds(wheels: Wheels, track: float) -> tuple[float, float]:
    """The speed (adv, rot) of a robot with these wheel speeds."""
    left, right = wheels
    return (left + right) / 2, math.degrees((left - right) / track)


def limited(wheels: Wheels, maximum: float) -> Wheels:
    """Both speeds reduced by the same factor so that neither exceeds `maximum`.

    The robot drives the same curve, only slower.
    """
    fastest = max(abs(wheels[0]), abs(wheels[1]))
    if fastest <= maximum:
        return wheels
    factor = maximum / fastest
    return wheels[0] * factor, wheels[1] * factor


def accelerated(now: Wheels, target: Wheels, change: float) -> Wheels:
    """One step from `now` towards `target`; neither wheel changes by more than `change`."""
    left, right = target[0] - now[0], target[1] - now[1]
    largest = max(abs(left), abs(right))
    if largest <= change:
        return target
    return now[0] + left * change / largest, now[1] + right * change / largest


@dataclass(frozen=True, slots=True)
class Drivetrain:
    """What two driven wheels and their motors can do.

    Args:
        track: mm between the wheels.
        maximum_speed: mm/s of a wheel's rim.
        acceleration: mm/s² of a wheel's rim, when it speeds up or slows down; by default a wheel
            has a new speed at once.
    """

    track: float
    maximum_speed: float
    acceleration: float = math.inf

    def reachable(self, adv: float, rot: float) -> tuple[float, float]:
        """The speed (adv, rot) at which the robot moves after a command.

        If a wheel can't turn so fast, both are reduced by the same factor: the robot drives the
        same curve, only slower.
        """
        fastest = self._fastest_wheel(adv, rot)
        if fastest <= self.maximum_speed:
            return adv, rot
        if math.isinf(fastest):
            return self.reachable(adv * _TINY, rot * _TINY)
        factor = self.maximum_speed / fastest
        return adv * factor, rot * factor

    def wheels(self, adv: float, rot: float) -> Wheels:
        """The wheel speeds after a command (adv, rot), as far as the wheels can turn so fast."""
        most = self.maximum_speed
        left, right = wheel_speeds(*self.reachable(adv, rot), self.track)
        # Rounding must not make them faster than a motor allows.
        return min(max(left, -most), most), min(max(right, -most), most)

    def periods(self, before: tuple[float, float], after: tuple[float, float]) -> float:
        """How many times `CONTROL_PERIOD` a change between two speeds takes, with fractions."""
        change = self._fastest_wheel(after[0] - before[0], after[1] - before[1])
        return change / (self.acceleration * CONTROL_PERIOD)

    def _fastest_wheel(self, adv: float, rot: float) -> float:
        return abs(adv) + abs(math.radians(rot)) * self.track / 2


class Odometry:
    """The pose of a robot by the distances that its wheels have rolled.

    It starts at (0, 0) with heading 0, along x. It knows neither slip nor the true size of the
    wheels, so its error grows with the way.

    >>> odometry = Odometry(track=100)
    >>> odometry.roll(200, 200)
    >>> odometry.pose
    (200.0, 0.0, 0.0)

    Args:
        track: the distance between the wheels in mm; only `roll` needs it.
    """

    def __init__(self, track: float = 1.0) -> None:
        self._track = track
        self._x = self._y = self._heading = 0.0

    @property
    def pose(self) -> tuple[float, float, float]:
        """(x mm, y mm, heading in degrees clockwise, from -180 to 180)."""
        return self._x, self._y, (self._heading + 180) % 360 - 180

    def copy(self) -> "Odometry":
        """Another one at the same pose, made in a fraction of the time of `copy.copy`."""
        copy = Odometry(self._track)
        copy._x, copy._y, copy._heading = self._x, self._y, self._heading
        return copy

    def roll(self, left: float, right: float) -> None:
        """Process the mm that each wheel has rolled forward, at speeds with a fixed ratio."""
        self.proceed(*body_speeds((left, right), self._track))

    def proceed(self, arc: float, turned: float) -> None:
        """Process an arc: its length in mm, and the angle in degrees that the robot has turned."""
        half = math.radians(turned / 2)
        # The straight way from one end of the arc to the other, which is a chord of its circle.
        chord = arc * math.sin(half) / half if half else arc
        middle = math.radians(self._heading) + half
        self._x += chord * math.cos(middle)
        self._y -= chord * math.sin(middle)
        self._heading += turned
