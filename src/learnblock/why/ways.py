"""The way of a robot: where it was at any time, how far it drove and how far it turned."""

import math
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from learnblock.devices import Pose

#: A device is read at least this often, s: a value recorded later has not changed until then.
_PERIOD = 0.15


@dataclass(frozen=True)
class Way:
    """Poses in order of time, with headings without jumps.

    Args:
        times: in s.
        poses: (x mm, y mm, heading in degrees clockwise), with full turns counted.
    """

    times: tuple[float, ...]
    poses: tuple[Pose, ...]

    @classmethod
    def of(cls, poses: Iterable[tuple[float, Pose]]) -> "Way":
        """The way through some poses, with headings that may jump by full turns."""
        times: list[float] = []
        unwound: list[Pose] = []
        for time, (x, y, heading) in poses:
            if unwound:
                heading = unwound[-1][2] + math.remainder(heading - unwound[-1][2], 360)  # noqa: PLW2901
                if time - times[-1] > _PERIOD:
                    # It stood still until a moment ago.
                    times.append(time - _PERIOD)
                    unwound.append(unwound[-1])
            times.append(time)
            unwound.append((x, y, heading))
        return cls(tuple(times), tuple(unwound))

    def at(self, time: float) -> Pose:
        """The pose at a time; the first or last one outside of the recorded time."""
        index = bisect_right(self.times, time)
        if index in (0, len(self.times)):
            return self.poses[min(index, len(self.poses) - 1)]
        before, after = self.times[index - 1], self.times[index]
        part = (time - before) / (after - before)
        x, y, heading = (
            start + part * (end - start)
            for start, end in zip(self.poses[index - 1], self.poses[index], strict=True)
        )
        return (x, y, heading)

    def travel(self, first: float, last: float) -> float:
        """The mm driven forward between two times; backward is negative."""
        inside = self.poses[bisect_right(self.times, first) : bisect_left(self.times, last)]
        poses = [self.at(first), *inside, self.at(last)]
        return sum(_forward(pose, other) for pose, other in pairwise(poses))

    def turn(self, first: float, last: float) -> float:
        """The degrees turned clockwise between two times."""
        return self.at(last)[2] - self.at(first)[2]

    def moved_to(self, start: Pose) -> "Way":
        """The same way from another start."""
        if not self.poses:
            return self
        (x, y, heading), (to_x, to_y, to_heading) = self.poses[0], start
        angle = math.radians(to_heading - heading)
        cos, sin = math.cos(angle), math.sin(angle)

        def moved(pose: Pose) -> Pose:
            along, left = pose[0] - x, pose[1] - y
            # Headings are clockwise, and y is to the left of x.
            return (
                to_x + cos * along + sin * left,
                to_y - sin * along + cos * left,
                pose[2] + to_heading - heading,
            )

        return Way(self.times, tuple(map(moved, self.poses)))


def odometry(lines: Iterable[Mapping[str, Any]]) -> Way:
    """The way that a real robot reported."""
    return Way.of(
        (line["t"], (line["odometry"][0], line["odometry"][1], line["odometry"][2]))
        for line in lines
        if "odometry" in line
    )


def turned(lines: Iterable[Mapping[str, Any]]) -> Way:
    """The headings that a real robot's gyroscope measured, as a way that stays at one place."""
    headings: list[tuple[float, Pose]] = []
    zero = last = 0.0
    reset_at = -_PERIOD
    for line in lines:
        if line.get("device") == "Gyroscope" and line.get("do") == "reset":
            zero, last, reset_at = zero + last, 0.0, line["t"]
        elif _is_of_gyroscope(line) and line["t"] - reset_at >= _PERIOD:
            # A reading just after a reset may have been made before it.
            last = float(line["value"])
            headings.append((line["t"], (0.0, 0.0, zero + last)))
    return Way.of(headings)


def _is_of_gyroscope(line: Mapping[str, Any]) -> bool:
    return str(line.get("sensed", "")).startswith("Gyroscope:")


def _forward(pose: Pose, other: Pose) -> float:
    heading = math.radians((pose[2] + other[2]) / 2)
    return (other[0] - pose[0]) * math.cos(heading) - (other[1] - pose[1]) * math.sin(heading)
