"""Checks of a client's motors: signs, units and invalid values."""

import math
from time import monotonic

from learnblock.client import Client
from learnblock.devices import Base, Gyroscope, JointMotor, Pose
from learnblock.errors import DeviceValueError
from learnblock.testing.bench import Bench, BrokenClaimError, SkippedClaimError, require


def _base(robot: Client) -> Base:
    base = robot.device(Base)
    if base is None:
        raise SkippedClaimError("it has no base")
    return base


def drives_forward(bench: Bench) -> str:
    """Check the sign and unit of the speed by its odometry."""
    with bench.robot() as robot:
        base = _base(robot)
        before = pose(base)
        base.move(50, 0)
        robot.clock.sleep(1)
        base.stop()
        after = pose(base)
    heading = math.radians(before[2])
    ahead = (after[0] - before[0]) * math.cos(heading) - (after[1] - before[1]) * math.sin(heading)
    require(25 < ahead < 90, f"50 mm/s for 1 s moved it {ahead:.0f} mm forward")
    return f"{ahead:.0f} mm"


def pose(base: Base) -> Pose:
    """The pose by the odometry of a base.

    Raises:
        SkippedClaimError: it has no odometry.
    """
    if not base.has_odometry:
        raise SkippedClaimError("its base has no odometry")
    x, y, heading = base.pose()
    return float(x), float(y), float(heading)


def turns_right(bench: Bench) -> str:
    """Check the sign and unit of the rotation by its gyroscope or odometry."""
    with bench.robot() as robot:
        base, gyroscope = _base(robot), robot.device(Gyroscope, "Z_AXIS")
        read = gyroscope.read if gyroscope else lambda: pose(base)[2]
        before = read()
        base.move(0, 45)
        robot.clock.sleep(1)
        base.stop()
        turned = (read() - before + 180) % 360 - 180
    require(20 < turned < 80, f"45 degrees/s for 1 s turned it by {turned:.0f} degrees")
    return f"{turned:.0f} degrees"


def resets_gyroscope(bench: Bench) -> str:
    """Check that the gyroscope reads 0 after a reset."""
    with bench.robot() as robot:
        gyroscope = robot.device(Gyroscope, "Z_AXIS")
        if gyroscope is None:
            raise SkippedClaimError("it has no gyroscope")
        gyroscope.reset()
        reading = gyroscope.read()
    require(abs(reading) < 3, f"it reads {reading} after its reset")
    return ""


def moves_joints(bench: Bench) -> str:
    """Check that each joint that reports its angle reaches 10 degrees."""
    with bench.robot() as robot:
        joints = [
            (key, device) for key, device in robot.devices() if isinstance(device, JointMotor)
        ]
        if not joints:
            raise SkippedClaimError("it has no joint")
        for key, joint in joints:
            joint.move(10)
            read = joint.functions.get("read")
            if read is None:
                continue
            until = monotonic() + bench.patience
            while abs(read() - 10) > 3 and monotonic() < until:
                robot.clock.sleep(0.05)
            require(abs(read() - 10) <= 3, f"{key} is at {read():.1f} degrees after move(10)")
    return ", ".join(key for key, _ in joints)


def rejects_wrong_values(bench: Bench) -> str:
    """Check that a speed must be a finite number."""
    with bench.robot() as robot:
        base = _base(robot)
        for value in (math.nan, math.inf, "fast", None):
            try:
                base.move(value, 0)  # type: ignore[arg-type] # invalid on purpose
            except DeviceValueError:
                continue
            raise BrokenClaimError(f"move({value!r}, 0) is accepted")
    return ""
