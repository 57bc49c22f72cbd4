"""The kinematics of two driven wheels.

Speeds are mm/s forward and degrees/s clockwise seen from above. With the wheels `track` mm apart
and the rotation r in rad/s, the left wheel runs at adv + r * track / 2 and the right one at
adv - r * track / 2.
"""

import math

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
    return wheels[0] * maximum / fastest, wheels[1] * maximum / fastest


def accelerated(now: Wheels, target: Wheels, change: float) -> Wheels:
    """One step from `now` towards `target`; neither wheel changes by more than `change`."""
    left, right = target[0] - now[0], target[1] - now[1]
    largest = max(abs(left), abs(right))
    if largest <= change:
        return target
    return now[0] + left * change / largest, now[1] + right * change / largest
