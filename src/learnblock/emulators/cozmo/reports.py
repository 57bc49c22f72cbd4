"""The robot's reports of its state, about thirty per second."""

import math
from typing import Any

from pycozmo import protocol_encoder as packets
from pycozmo.robot import RobotStatusFlag

from learnblock.devices import Pose
from learnblock.simulator import RobotBody

PIVOT, ARM = 45.0, 66.0
"""The height of the lift's pivot and the length of its arm in mm (pycozmo.robot)."""
FULL_TURN = 2 * math.pi


class Reports:
    """The robot's reports, relative to an origin that its client sets."""

    def __init__(self) -> None:
        self._origin: Pose = (0.0, 0.0, 0.0)
        self._numbers = (0, 1)
        self._last: tuple[float, float] | None = None

    def set_origin(self, pose: Pose, frame: int, origin: int) -> None:
        """Use this pose as the origin; the client identifies it by the two numbers."""
        self._origin, self._numbers = pose, (frame, origin)

    def state(self, body: RobotBody, time: float, speeds: tuple[float, float]) -> Any:
        """Make a report.

        Args:
            body: the twin's body.
            time: the time of the twin's world in s.
            speeds: the speeds of the left and right tread in mm/s.
        """
        accelerations = [1000 * axis for axis in body.acceleration()]
        x, y, angle = seen_from(self._origin, body.pose)
        on_cliff = is_on_cliff(body)
        return packets.RobotState(
            timestamp=int(1000 * time),
            pose_frame_id=self._numbers[0],
            pose_origin_id=self._numbers[1],
            pose_x=x,
            pose_y=y,
            pose_angle_rad=angle,
            lwheel_speed_mmps=speeds[0],
            rwheel_speed_mmps=speeds[1],
            head_angle_rad=math.radians(body.joint("CAMERA")),
            lift_height_mm=PIVOT + ARM * math.sin(math.radians(body.joint("ARM"))),
            accel_x=accelerations[0],
            accel_y=accelerations[1],
            accel_z=accelerations[2],
            gyro_z=self._turn_rate(time, angle),
            battery_voltage=4.0,
            status=_status(on_cliff=on_cliff, moves=any(speeds)),
            cliff_data_raw=(0 if on_cliff else 1000,) * 4,
        )

    def _turn_rate(self, time: float, angle: float) -> float:
        """The turn rate since the last report in rad/s to the left."""
        before, self._last = self._last, (time, angle)
        if before is None or time <= before[0]:
            return 0.0
        return math.remainder(angle - before[1], FULL_TURN) / (time - before[0])


def is_on_cliff(body: RobotBody) -> bool:
    """Whether there is no floor under its front."""
    return body.ground()["central"] == 0


def seen_from(origin: Pose, pose: Pose) -> tuple[float, float, float]:
    """A pose relative to an origin: mm forward and to the left, and rad to the left."""
    x, y = pose[0] - origin[0], pose[1] - origin[1]
    angle = math.radians(origin[2])
    along, across = math.cos(angle), math.sin(angle)
    turned = math.remainder(math.radians(origin[2] - pose[2]), FULL_TURN)
    return x * along - y * across, x * across + y * along, turned


def _status(*, on_cliff: bool, moves: bool) -> int:
    flag = RobotStatusFlag
    status = flag.LIFT_IN_POS | flag.HEAD_IN_POS
    if on_cliff:
        status |= flag.CLIFF_DETECTED
    if moves:
        status |= flag.IS_MOVING | flag.ARE_WHEELS_MOVING
    return int(status)
