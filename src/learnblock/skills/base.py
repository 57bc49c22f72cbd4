"""Driving and turning, and questions about the current movement."""

from dataclasses import replace
from typing import TYPE_CHECKING

from learnblock.client.senses.heading import UPRIGHT
from learnblock.devices import Base, Gyroscope, number, positive
from learnblock.skills.turning import BRISK, Manner, shortest, turn_by

if TYPE_CHECKING:
    from learnblock.client import Client

_CAREFUL = Manner(gain=0.5, slowest=5, fastest=15, settled_within=2)
_SLOWING_PERIOD = 0.1


def move_straight(robot: "Client", advSpeed: float = 40) -> None:
    """Drive straight until the next command.

    Args:
        advSpeed: mm/s; a negative speed drives backwards.
    """
    _move(robot, advSpeed, 0)


def move_left(robot: "Client", advSpeed: float = 20, rotSpeed: float = -15) -> None:
    """Drive in a curve to the left until the next command.

    Args:
        advSpeed: mm/s; a negative speed drives backwards.
        rotSpeed: degrees/s; negative turns to the left.
    """
    _move(robot, advSpeed, rotSpeed)


def move_right(robot: "Client", advSpeed: float = 20, rotSpeed: float = 15) -> None:
    """Drive in a curve to the right until the next command.

    Args:
        advSpeed: mm/s; a negative speed drives backwards.
        rotSpeed: degrees/s; positive turns to the right.
    """
    _move(robot, advSpeed, rotSpeed)


def turn_left(robot: "Client", rotSpeed: float = -23) -> None:
    """Turn to the left on the spot until the next command.

    Args:
        rotSpeed: degrees/s; negative turns to the left.
    """
    _move(robot, 0, rotSpeed)


def turn_right(robot: "Client", rotSpeed: float = 23) -> None:
    """Turn to the right on the spot until the next command.

    Args:
        rotSpeed: degrees/s; positive turns to the right.
    """
    _move(robot, 0, rotSpeed)


def set_move(robot: "Client", adv: float, rot: float) -> None:
    """Drive and turn at the same time until the next command.

    Args:
        adv: mm/s; a negative speed drives backwards.
        rot: degrees/s; positive turns to the right.
    """
    _move(robot, adv, rot)


def stop_bot(robot: "Client") -> None:
    """Stop the wheels."""
    _move(robot, 0, 0)


def turn(robot: "Client", angle: float, rotSpeed: float = 120) -> None:
    """Turn on the spot by an angle, then continue with the program.

    The robot slows down towards the end and stops within 1 degree of the angle by its gyroscope
    or, without one, by its wheels.

    Args:
        angle: degrees; positive to the right, negative to the left; 720 is two full turns.
        rotSpeed: degrees/s at most, more than 0.

    Raises:
        DeviceValueError: the speed is not more than 0.
        StillTurningError: the turn takes far too long; the robot may be stuck.
    """
    angle = number("angle", angle)
    speed = positive("rotSpeed", rotSpeed, "skill-turning-speed-not-positive")
    base = robot.device(Base)
    if base is not None:
        manner = replace(BRISK, fastest=speed, slowest=min(speed, BRISK.slowest))
        turn_by(robot, base, angle, manner)


def turn_90_left(robot: "Client") -> None:
    """Turn left by 90 degrees on the spot."""
    turn(robot, -90)


def turn_90_right(robot: "Client") -> None:
    """Turn right by 90 degrees on the spot."""
    turn(robot, 90)


def turn_back(robot: "Client") -> None:
    """Turn around by 180 degrees on the spot."""
    turn(robot, 180)


def reset_orientation(robot: "Client", keygyro: str = UPRIGHT) -> None:
    """Set the current heading to 0 degrees.

    Args:
        keygyro: which gyroscope; the one whose axis points up measures turns on the floor. A
            robot without it uses its wheels.
    """
    if keygyro == UPRIGHT:
        robot.senses.reset_heading()
        return
    gyroscope = robot.device(Gyroscope, keygyro)
    if gyroscope is not None:
        gyroscope.reset()
        robot.forget_readings()


def get_heading(robot: "Client") -> float | None:
    """How many degrees has the robot turned to the right since the last `reset_orientation`?"""
    return robot.senses.heading()


def set_orientation(robot: "Client", angle: float) -> None:
    """Turn on the spot to face a direction, the shorter way.

    The robot turns at 5 to 15 degrees/s, stops within 1 degree by its gyroscope or, without one,
    by its wheels, and corrects an error of more than 2 degrees after it has stopped.

    Args:
        angle: degrees to the right of the heading at the last `reset_orientation`.

    Raises:
        StillTurningError: the turn takes far too long; the robot may be stuck.
    """
    angle = number("angle", angle)
    base, heading = robot.device(Base), robot.senses.heading()
    if base is not None and heading is not None:
        turn_by(robot, base, shortest(angle - heading), _CAREFUL)


def slow_down(robot: "Client", decAdv: float = 4, decRot: float = 2) -> None:
    """Drive one step slower, until the robot stops; each step takes 0.1 seconds.

    Args:
        decAdv: mm/s by which each step reduces the speed; the sign does not matter.
        decRot: degrees/s by which each step reduces the turning; the sign does not matter.
    """
    base = robot.device(Base)
    if base is None or base.speed == (0, 0):
        return
    adv, rot = base.speed
    base.move(
        _nearer_zero(adv, number("decAdv", decAdv)), _nearer_zero(rot, number("decRot", decRot))
    )
    robot.clock.sleep(_SLOWING_PERIOD)


def is_moving_straight(robot: "Client") -> bool:
    """Is the robot driving straight, forward or backward?"""
    adv, rot = _speed(robot)
    return adv != 0 and rot == 0


def is_moving_left(robot: "Client") -> bool:
    """Is the robot driving in a curve to the left?"""
    adv, rot = _speed(robot)
    return adv != 0 and rot < 0


def is_moving_right(robot: "Client") -> bool:
    """Is the robot driving in a curve to the right?"""
    adv, rot = _speed(robot)
    return adv != 0 and rot > 0


def is_turning(robot: "Client") -> bool:
    """Is the robot turning on the spot?"""
    adv, rot = _speed(robot)
    return adv == 0 and rot != 0


def is_turning_left(robot: "Client") -> bool:
    """Is the robot turning to the left on the spot?"""
    adv, rot = _speed(robot)
    return adv == 0 and rot < 0


def is_turning_right(robot: "Client") -> bool:
    """Is the robot turning to the right on the spot?"""
    adv, rot = _speed(robot)
    return adv == 0 and rot > 0


def _move(robot: "Client", adv: float, rot: float) -> None:
    base = robot.device(Base)
    if base is not None:
        base.move(adv, rot)


def _speed(robot: "Client") -> tuple[float, float]:
    """The last command (mm/s, degrees/s)."""
    base = robot.device(Base)
    return (0.0, 0.0) if base is None else base.speed


def _nearer_zero(speed: float, step: float) -> float:
    step = abs(step)
    return max(0.0, speed - step) if speed > 0 else min(0.0, speed + step)
