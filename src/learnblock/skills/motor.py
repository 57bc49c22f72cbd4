"""Joints: the camera's tilt, and arms."""

from typing import TYPE_CHECKING

from learnblock.devices import JointMotor

if TYPE_CHECKING:
    from learnblock.client import Client

_CAMERA = "CAMERA"


def down_camera(robot: "Client", angle: float = 10) -> None:
    """Tilt the camera down from where it points.

    Args:
        angle: degrees.
    """
    _tilt_by(robot, -angle)


def look_floor(robot: "Client") -> None:
    """Look at the floor: tilt the camera 30 degrees down."""
    setAngleMotor(robot, _CAMERA, -30)


def look_front(robot: "Client") -> None:
    """Look straight ahead."""
    setAngleMotor(robot, _CAMERA, 0)


def look_up(robot: "Client") -> None:
    """Look up: tilt the camera 30 degrees up."""
    setAngleMotor(robot, _CAMERA, 30)


def setAngleCamera(robot: "Client", angle: float) -> None:
    """Tilt the camera.

    Args:
        angle: degrees; 0 is straight ahead, positive is up.
    """
    setAngleMotor(robot, _CAMERA, angle)


def setAngleMotor(robot: "Client", key: str, angle: float) -> None:
    """Start moving a joint to an angle; the program continues meanwhile.

    Args:
        key: which joint, such as ``CAMERA`` or ``ARM``.
        angle: degrees; 0 is level, positive is up.
    """
    joint = robot.device(JointMotor, key)
    if joint is not None:
        joint.move(angle)


def up_camera(robot: "Client", angle: float = 10) -> None:
    """Tilt the camera up from where it points.

    Args:
        angle: degrees.
    """
    _tilt_by(robot, angle)


def _tilt_by(robot: "Client", angle: float) -> None:
    joint = robot.device(JointMotor, _CAMERA)
    if joint is not None:
        joint.move_by(angle)
