"""Driving a way that ends: the control loop on the odometry that the driving skills share."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from learnblock.devices import Base, positive
from learnblock.errors import StillDrivingError
from learnblock.skills.progress import PERIOD, Pace, Progress

if TYPE_CHECKING:
    from learnblock.client import Client

#: Millimetres from the target at which the wheels are stopped.
WITHIN = 1.0
#: mm/s for each mm that remains, the slowest speed, at which every robot still moves, and mm/s by
#: which two commands differ at most while the robot speeds up and while it slows down.
_GAIN, _SLOWEST, _SPEEDING_UP, _SLOWING_DOWN = 5.0, 10.0, 8.0, 15.0
#: Degrees/s for each degree off the heading.
STEERING = 2.0


@dataclass(frozen=True, slots=True)
class Course:
    """A way to drive.

    Args:
        length: mm; negative backwards.
        remaining: returns the mm that remain, with the sign of the way to drive.
        turning: returns the degrees/s to turn at a speed in mm/s.
        within: mm from its end at which the wheels are stopped.
    """

    length: float
    remaining: Callable[[], float]
    turning: Callable[[float], float]
    within: float = WITHIN


def drive(robot: "Client", base: Base, course: Course, speed: float) -> None:
    """Drive a course at no more than `speed` mm/s, and stop.

    Raises:
        StillDrivingError: the robot is stuck, or the drive takes far too long.
    """
    # A robot must not pass the end between two commands.
    slowest = min(speed, _SLOWEST, course.within / PERIOD / 2)
    pace = Pace(
        gain=_GAIN,
        slowest=slowest,
        # Faster commands would leave the wheels no way to steer.
        fastest=base.reachable(speed)[0],
        speeding_up=_SPEEDING_UP,
        slowing_down=_SLOWING_DOWN,
    )
    began = robot.clock.time()
    deadline = began + pace.time_limit(course.length)
    adv, progress = 0.0, Progress(pace.least_progress)
    while abs(remaining := course.remaining()) > course.within:
        now = robot.clock.time()
        progress.note(now, remaining)
        if progress.is_stuck or now >= deadline:
            base.stop()
            raise StillDrivingError(
                "skill-still-driving",
                driven=round(course.length - remaining),
                distance=round(course.length),
                seconds=round(robot.clock.time() - began),
            )
        adv = pace.speed(remaining, adv)
        base.move(adv, course.turning(adv))
        robot.clock.sleep(PERIOD)
    base.stop()


def speed_of(speed: float) -> float:
    """A speed in mm/s.

    Raises:
        DeviceValueError: it is not more than 0.
    """
    return positive("advSpeed", speed, "skill-speed-not-positive")
