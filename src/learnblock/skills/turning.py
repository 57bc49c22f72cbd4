"""Turning to a heading: the control loop that the turning skills share."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from learnblock.devices import Base
from learnblock.errors import StillTurningError
from learnblock.skills.progress import PERIOD, Pace, Progress

if TYPE_CHECKING:
    from learnblock.client import Client

#: Degrees from the target at which the wheels are stopped; what remains adds up over many turns.
WITHIN = 0.3
#: Seconds a robot rocks after its wheels have stopped.
SETTLING = 0.2


@dataclass(frozen=True, slots=True, kw_only=True)
class Manner(Pace):
    """The speeds of a turn, in degrees/s, and its tolerance.

    Args:
        settled_within: degrees it may be off once the robot has settled; else it turns again.
    """

    speeding_up: float = 5.0
    slowing_down: float = 12.0
    settled_within: float


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
