"""Where a real robot left the way of its twin, which executed the same commands.

The twin drives exactly as commanded. So any difference comes from the real robot: its wheels, its
floor, a sensor, or a world that is not as drawn.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from learnblock import robots
from learnblock.client import Client
from learnblock.devices import NOTHING_SEEN, Pose
from learnblock.errors import LearnBlockError
from learnblock.robots.simulated import SimulatedRobot, Simulation, find_world
from learnblock.simulator import World
from learnblock.why.recorded import Recorded
from learnblock.why.ways import Way, odometry, turned
from learnblock.why.world_again import NAME, WorldAgain, without_extra_camera

#: The twin's world if none was chosen.
EMPTY = "empty"
#: How far a robot may be from its twin's way: mm, and degrees. A command that is a tenth of a
#: second late, as on a busy radio, explains as much at 300 mm/s or 100 degrees/s.
FAR, ASKEW = 30.0, 10.0
#: A wire delays commands and answers, and not always equally: s.
LONGEST_DELAY, JITTER = 0.6, 0.1
_DELAY_STEP = 0.02
#: Seconds between two poses of the twin, and between two of its readings.
_POSES, _READINGS = 0.02, 0.1
#: What moves the robot, and the camera on it.
_MOVING = frozenset({"Base", "JointMotor"})


@dataclass(frozen=True, slots=True)
class Departure:
    """Where a real robot left the way of its twin.

    Args:
        time: when, in s.
        pose: where it was then, by its own report.
        twin: where its twin was.
        distance: mm from the nearest pose of the twin around that time.
        angle: degrees by which it faced more clockwise than the twin.
    """

    time: float
    pose: Pose
    twin: Pose
    distance: float
    angle: float


@dataclass(frozen=True)
class Prediction:
    """What a real robot did, and what its twin did with the same commands.

    Args:
        recorded: the log of the real robot's run.
        robot: the real robot's class.
        world: the name of the twin's world.
        real: the way that the real robot reported, from the twin's start; empty if it reports none.
        headings: what its gyroscope measured; empty without one.
        twin: the way of its twin.
        distances: for each time, the distances in mm in front of the real robot and its twin.
        delay: the delay of the real robot, in s.
        parting: where they parted; None if they did not.
    """

    recorded: Recorded
    robot: type[Client]
    world: str
    real: Way
    headings: Way
    twin: Way
    distances: tuple[tuple[float, float, float], ...]
    delay: float
    parting: Departure | None


def predict(recorded: Recorded, world: str = EMPTY) -> Prediction:
    """Run the twin of a real robot from the commands in the log of its run.

    Args:
        recorded: the log.
        world: the name or path of the world in which the robot was.

    Raises:
        LearnBlockError: it is not the log of a real robot with a twin, or there is no such world.
    """
    kind = robots.find(str(recorded.conditions.get("robot", ""))).load()
    again = WorldAgain(_moves_only(recorded), _twin(kind, world))
    end = max((line.get("t", 0.0) for line in recorded.lines), default=0.0)
    twin, fronts = _run(again, end)
    real = odometry(recorded.lines).moved_to(twin.poses[0])
    headings = turned(recorded.lines)
    delay = _delay(real, twin)
    return Prediction(
        recorded,
        kind,
        world,
        real,
        headings,
        twin,
        # Without a chosen world, the robot saw other things than its twin.
        () if world == EMPTY else tuple(_pairs(recorded, fronts)),
        delay,
        _parting(real, twin, delay),
    )


def _twin(kind: type[Client], world: str) -> "partial[SimulatedRobot]":
    if kind.lockstep or f"sim-{kind.model}" not in robots.entries():
        raise LearnBlockError("twin-none")
    twin = robots.find(f"sim-{kind.model}").load()
    if not issubclass(twin, SimulatedRobot):
        raise LearnBlockError("twin-none")
    return partial(_make, without_extra_camera(twin), world)


def _make(twin: type[SimulatedRobot], world: str) -> SimulatedRobot:
    return twin(simulation=Simulation(World(find_world(world), seed=0)), name=NAME)


def _moves_only(recorded: Recorded) -> Recorded:
    lines = (
        line
        for line in recorded.lines
        if line.get("device") in _MOVING or "end" in line or "run" in line
    )
    return replace(recorded, lines=tuple(lines))


def _run(again: WorldAgain, end: float) -> tuple[Way, dict[int, float]]:
    """The way of the twin, and the distances in mm in front of it, by the number of readings."""
    poses: list[tuple[float, Pose]] = []
    fronts: dict[int, float] = {}
    every = round(_READINGS / _POSES)
    for number in range(round(end / _POSES) + 1):
        robot = again.seek(number * _POSES)
        poses.append((number * _POSES, robot.where()))
        if number % every == 0 and (front := _front(_distances(robot))):
            fronts[number // every] = front
    return Way.of(poses), fronts


def _distances(robot: SimulatedRobot) -> Mapping[str, Any]:
    for _, device in robot.devices():
        if type(device).__name__ == "DistanceSensors":
            distances: Mapping[str, Any] = device.functions["read"]()
            return distances
    return {}


def _front(distances: Mapping[str, Any]) -> float | None:
    """The distance in front in mm; None if it is out of range."""
    nearest = min(distances.get("front") or [NOTHING_SEEN])
    return None if nearest >= NOTHING_SEEN else float(nearest)


def _pairs(recorded: Recorded, fronts: Mapping[int, float]) -> Iterator[tuple[float, float, float]]:
    for line in recorded.lines:
        if str(line.get("sensed", "")).startswith("DistanceSensors:"):
            real, twin = _front(line["value"]), fronts.get(round(line["t"] / _READINGS))
            if real is not None and twin is not None:
                yield line["t"], real, twin


def _delay(real: Way, twin: Way) -> float:
    """The delay of the real robot's movements with which both speeds agree best."""
    if len(real.times) < 2:
        return 0.0
    delays = [step * _DELAY_STEP for step in range(round(LONGEST_DELAY / _DELAY_STEP) + 1)]
    return min(delays, key=partial(_disagreement, real, twin))


def _disagreement(real: Way, twin: Way, delay: float) -> float:
    """The squares of the differences of both ways between each two poses: 1 mm counts as 1°."""
    return sum(
        (math.dist(pose[:2], other[:2]) - math.dist(*_pair(twin, first - delay, last - delay))) ** 2
        + (other[2] - pose[2] - twin.turn(first - delay, last - delay)) ** 2
        for first, last, pose, other in zip(
            real.times, real.times[1:], real.poses, real.poses[1:], strict=False
        )
    )


def _pair(way: Way, first: float, last: float) -> tuple[tuple[float, float], tuple[float, float]]:
    (x, y, _), (to_x, to_y, _) = way.at(first), way.at(last)
    return (x, y), (to_x, to_y)


def _parting(real: Way, twin: Way, delay: float) -> Departure | None:
    for time, pose in zip(real.times, real.poses, strict=True):
        near = _near(twin, time - delay)
        distance = min(math.dist(pose[:2], twin_pose[:2]) for twin_pose in near)
        angle = min((pose[2] - twin_pose[2] for twin_pose in near), key=abs)
        if distance > FAR or abs(angle) > ASKEW:
            return Departure(time, pose, twin.at(time - delay), round(distance, 1), round(angle, 1))
    return None


def _near(way: Way, time: float) -> list[Pose]:
    """The poses of a way around a time."""
    steps = round(JITTER / _DELAY_STEP)
    return [way.at(time + step * _DELAY_STEP) for step in range(-steps, steps + 1)]
