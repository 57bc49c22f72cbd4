"""Turning to a heading by the gyroscope: the control loop that the turning skills share."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from learnblock.devices import Base, Gyroscope
from learnblock.errors import StillTurningError

if TYPE_CHECKING:
    from learnblock.client import Client

#: The key of the gyroscope whose axis points up.
UPRIGHT = "Z_AXIS"
#: Degrees from the target at which the wheels are stopped.
WITHIN = 1.0
#: Seconds between two commands; at 10 degrees/s the robot turns a fifth of a degree meanwhile.
PERIOD = 0.02
#: Seconds a robot rocks after its wheels have stopped.
SETTLING = 0.2


@dataclass(frozen=True, slots=True)
class Manner:
    """The speeds and tolerance of a turn.

    Args:
        gain: degrees/s for each degree that remains.
        slowest: degrees/s; below it some robots do not move at all.
        fastest: degrees/s.
        settled_within: degrees it may be off once the robot has settled; else it turns again.
    """

    gain: float
    slowest: float
    fastest: float
    settled_within: float

    def speed(self, remaining: float) -> float:
        """The speed in degrees/s, with the sign of the remaining degrees."""
        magnitude = min(max(self.gain * abs(remaining), self.slowest), self.fastest)
        return math.copysign(magnitude, remaining)

    def time_limit(self, angle: float) -> float:
        """The most seconds that a robot that is not stuck needs for a turn by `angle`."""
        return 5 + abs(angle) / self.slowest


def has_gyroscope(robot: "Client") -> bool:
    """Whether the robot has a gyroscope, without reporting a missing one.

    A turn works without it.
    """
    return any(isinstance(device, Gyroscope) and key == UPRIGHT for key, device in robot.devices())


def heading(robot: "Client") -> float:
    """Degrees turned since the gyroscope's reset, clockwise positive."""
    return robot.read(Gyroscope, UPRIGHT) or 0.0


def turn_by(robot: "Client", base: Base, angle: float, manner: Manner) -> None:
    """Turn by `angle` degrees, positive to the right, and stop.

    Raises:
        StillTurningError: the turn exceeds the manner's time limit.
    """
    target = heading(robot) + angle
    began = robot.clock.time()
    deadline = began + manner.time_limit(angle)
    remaining = angle
    while robot.clock.time() < deadline:
        _approach(robot, base, target, manner, deadline)
        remaining = target - heading(robot)
        if abs(remaining) <= manner.settled_within:
            return
    raise StillTurningError(
        "skill-still-turning",
        turned=round(angle - remaining),
        angle=round(angle),
        seconds=round(robot.clock.time() - began),
    )


def _approach(robot: "Client", base: Base, target: float, manner: Manner, deadline: float) -> None:
    while abs(remaining := target - heading(robot)) > WITHIN and robot.clock.time() < deadline:
        base.move(0, manner.speed(remaining))
        robot.clock.sleep(PERIOD)
    base.stop()
    robot.clock.sleep(SETTLING)


def turn_blind(robot: "Client", base: Base, angle: float, speed: float) -> None:
    """Turn by `angle` degrees for the time this takes at `speed` degrees/s (positive)."""
    base.move(0, math.copysign(speed, angle))
    robot.clock.sleep(abs(angle) / speed)
    base.stop()


def shortest(angle: float) -> float:
    """The shorter turn to the same direction as `angle`: degrees from -180 (exclusive) to 180."""
    return 180 - (180 - angle) % 360
