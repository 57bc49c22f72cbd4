"""Converts between Cozmo's units and ours: mm, degrees to the right, m/s2."""

import math

from learnblock.wheels import Drivetrain

TRACK = 45.0
"""The distance between the treads in mm (pycozmo.robot)."""
MAXIMUM_SPEED = 200.0
"""The maximum speed of a tread in mm/s (pycozmo.robot)."""
DRIVETRAIN = Drivetrain(TRACK, MAXIMUM_SPEED)
LOWEST_HEAD, HIGHEST_HEAD = -25.0, 44.5
"""The range of the head in degrees (pycozmo.robot)."""
PIVOT, ARM = 45.0, 66.0
"""The height of the lift's pivot and the length of its arm in mm (pycozmo.robot)."""
LOWEST_LIFT, HIGHEST_LIFT = 32.0, 92.0
"""The range of the lift in mm above the floor (pycozmo.robot)."""

LIGHTS = ("Left", "Front", "Center", "Rear", "Right")
"""The lamps on Cozmo's back, in pycozmo's order."""


def treads(adv: float, rot: float) -> tuple[float, float]:
    """The speeds of the left and the right tread in mm/s.

    If one would be too fast, both are reduced, so that the curve is unchanged.

    Args:
        adv: mm/s, positive is forward.
        rot: degrees/s, positive is to the right.
    """
    return DRIVETRAIN.wheels(adv, rot)


def head_angle(degrees: float) -> float:
    """The head's angle in radians for an angle in degrees (up is positive), within its range."""
    return math.radians(min(max(degrees, LOWEST_HEAD), HIGHEST_HEAD))


def lift_height(degrees: float) -> float:
    """The lift's height in mm for an angle of its arm, limited to its range."""
    height = PIVOT + ARM * math.sin(math.radians(min(max(degrees, -90.0), 90.0)))
    return min(max(height, LOWEST_LIFT), HIGHEST_LIFT)


def lift_angle(height: float) -> float:
    """The angle of the lift's arm in degrees for a height in mm."""
    return math.degrees(math.asin(min(max((height - PIVOT) / ARM, -1.0), 1.0)))


def acceleration(x: float, y: float, z: float) -> tuple[float, float, float]:
    """Forward, left and up in m/s2; the robot reports mm/s2."""
    return x / 1000, y / 1000, z / 1000
