"""Turning to a heading: the control loop that the turning skills share."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from learnblock.devices import Base
from learnblock.errors import StillTurningError
from learnblock.skills.progress import PATIENCE, Progress

if TYPE_CHECKING:
    from learnblock.client import Client

#: Degrees from the target at which the wheels are stopped; what remains adds up over many turns.
WITHIN = 0.3
#: Seconds between two commands; at 10 degrees/s the robot turns a fifth of a degree meanwhile.
PERIOD = 0.02
#: Degrees/s by which two commands differ at most while the robot speeds up. A pose that is reckoned
#: from the commands takes for granted that the robot can follow them.
SPEEDING_UP = 5.0
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

    def speed(self, remaining: float, before: float) -> float:
        """The speed in degrees/s, with the sign of the remaining degrees.

        Args:
            remaining: degrees.
            before: the previous speed in degrees/s.
        """
        magnitude = min(max(self.gain * abs(remaining), self.slowest), self.fastest)
        magnitude = min(magnitude, abs(before) + SPEEDING_UP)
        return math.copysign(magnitude, remaining)

    @property
    def least_progress(self) -> float:
        """The fewest degrees that a robot that is not stuck turns within `PATIENCE`."""
        return self.slowest * PATIENCE / 10

    def time_limit(self, angle: float) -> float:
        """The most seconds that a robot that is not stuck needs for a turn by `angle`."""
        return 5 + abs(angle) / self.slowest


#: A turn that takes no longer than it must.
BRISK = Manner(gain=5, slowest=10, fastest=120, settled_within=1)


def turn_by(robot: "Client", base: Base, angle: float, manner: Manner) -> None:
    """Turn by `angle` degrees, positive to the right, and stop.

    Raises:
        StillTurningError: the robot is stuck, or the turn exceeds the manner's time limit.
    """
    # A robot that still rolls turns less than its commands say.
    base.stop()
    robot.clock.sleep(SETTLING)
    target = _heading(robot) + angle
    began = robot.clock.time()
    deadline = began + manner.time_limit(angle)
    remaining = angle
    is_stuck = False
    while not is_stuck and robot.clock.time() < deadline:
        is_stuck = _approach(robot, base, target, manner, deadline)
        remaining = target - _heading(robot)
        if abs(remaining) <= manner.settled_within:
            return
    raise StillTurningError(
        "skill-still-turning",
        turned=round(angle - remaining),
        angle=round(angle),
        seconds=round(robot.clock.time() - began),
    )


def _approach(robot: "Client", base: Base, target: float, manner: Manner, deadline: float) -> bool:
    """Turn until the target or the deadline; return whether the robot is stuck before."""
    speed, progress = 0.0, Progress(manner.least_progress)
    while abs(remaining := target - _heading(robot)) > WITHIN:
        now = robot.clock.time()
        progress.note(now, remaining)
        if progress.is_stuck or now >= deadline:
            break
        speed = manner.speed(remaining, speed)
        base.move(0, speed)
        robot.clock.sleep(PERIOD)
    base.stop()
    robot.clock.sleep(SETTLING)
    return progress.is_stuck


def _heading(robot: "Client") -> float:
    return robot.senses.heading() or 0.0


def shortest(angle: float) -> float:
    """The shorter turn to the same direction as `angle`: degrees from -180 (exclusive) to 180."""
    return 180 - (180 - angle) % 360
