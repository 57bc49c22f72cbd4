"""A simulated robot in its world as the page shows it, whether or not a program runs.

What is asked here takes nothing from the program: its readings, its frames and its trace stay what
they are without anybody looking. All may be called from any thread.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import msgspec

from learnblock.client import Client
from learnblock.devices import Pose
from learnblock.errors import LearnBlockError
from learnblock.robots import RobotEntry
from learnblock.robots.manual_drive import ManualDrive
from learnblock.robots.picture import Picture, developed
from learnblock.robots.simulated import SimulatedRobot, Simulation, goal_of
from learnblock.robots.worlds import Lines, world_lines, world_values
from learnblock.simulator import LogEntry, RobotBody, World

#: In the order in which an accelerometer reads them.
_AXES = ("forward", "left", "up")


@dataclass(frozen=True, slots=True)
class Scene:
    """What stands in a world, for drawing it.

    Args:
        name: the world's.
        world: as its file says.
        lines: for each painted line the corners of its middle, mm.
        robots: name and description of each, ours first.
        start: (x mm, y mm, heading in degrees) where the next run begins.
    """

    name: str
    world: dict[str, Any]
    lines: Lines
    robots: tuple[tuple[str, dict[str, Any]], ...]
    start: Pose


@dataclass(frozen=True, slots=True)
class RobotNow:
    """A robot as it is now: mm, degrees, and colours of red, green and blue by the LED's key."""

    name: str
    x: float
    y: float
    heading: float
    joints: dict[str, float]
    leds: dict[str, tuple[int, int, int]]
    emotion: str


@dataclass(frozen=True, slots=True)
class GoalNow:
    """A goal of the world: ``open``, ``reached`` or ``failed``, and when that was decided, s."""

    name: str
    sort: str
    state: str
    time: float | None


@dataclass(frozen=True, slots=True)
class State:
    """A world as it is now.

    Args:
        time: seconds of the world.
        robots: ours first.
        pushed: (x, y, heading) of what can be pushed, boxes first, then cylinders.
        sensors: readings of our robot in the sensors' units; None where nothing is measured.
        goals: as they stand.
    """

    time: float
    robots: tuple[RobotNow, ...]
    pushed: tuple[Pose, ...]
    sensors: dict[str, float | bool | None]
    goals: tuple[GoalNow, ...]


class Stage:
    """A robot in its world.

    Args:
        simulation: the world.
        start: (x mm, y mm, heading in degrees) where the robot was put, if it was.
        client: the robot of the program that runs in this world, if one does.
    """

    def __init__(
        self,
        simulation: Simulation,
        start: Pose | None = None,
        client: SimulatedRobot | None = None,
    ) -> None:
        #: Where somebody put the robot, and the next run begins; None for the world's own start.
        self.start = start
        self._simulation = simulation
        self._client = client
        self._name = client.name if client else "robot"
        self._first = self._body.pose
        self._heard = 0
        self._drive: ManualDrive | None = None
        self._seen: tuple[object, Picture] | None = None

    @classmethod
    def of(cls, client: Client) -> "Stage | None":
        """The stage on which a program's robot is; None for a robot that is not simulated."""
        if not isinstance(client, SimulatedRobot):
            return None
        return cls(client.simulation, client.start, client)

    def scene(self) -> Scene:
        """What stands here."""
        world = self._simulation.world
        return Scene(
            name=world.description.name,
            world=world_values(world.description),
            lines=world_lines(world.description),
            robots=tuple(
                (body.name, msgspec.to_builtins(body.description)) for body in self._bodies(world)
            ),
            start=self.start or self._first,
        )

    def state(self) -> State:
        """How it is now."""
        simulation = self._simulation
        with simulation.lock:
            world = simulation.world
            pushed = [thing.pose for thing in world.physics.pushed]
            return State(
                time=world.time,
                robots=tuple(map(_robot_now, self._bodies(world))),
                pushed=tuple((pose.x, pose.y, pose.heading) for pose in pushed),
                sensors=dict(_sensors(world.robots[self._name])),
                goals=tuple(
                    GoalNow(goal.name, goal.kind, goal.state, goal.time)
                    for goal in map(goal_of, world.goals)
                ),
            )

    def place(self, x: float, y: float, heading: float) -> None:
        """Set the robot down elsewhere (mm, mm, degrees), where the next run begins as well.

        Raises:
            ValueError: one of them is no finite number.
        """
        self._simulation.place(self._name, x, y, heading)
        self.start = (x, y, heading)

    def drive(self, advance: float, rotation: float) -> None:
        """Drive by hand; it stops by itself half a second after it was told last.

        Args:
            advance: of the robot's fastest, -1 to 1, forward positive.
            rotation: of the robot's fastest, -1 to 1, clockwise positive.

        Raises:
            LearnBlockError: a program drives the robot.
        """
        self._require_no_program("drive the robot")
        if self._drive is None:
            self._drive = ManualDrive(self._simulation, self._body)
        wheels = self._body.description.wheels
        fastest_turn = math.degrees(2 * wheels.maximum_speed / wheels.track)
        self._drive.command(advance * wheels.maximum_speed, rotation * fastest_turn)

    def reset(self) -> None:
        """Put everything back to where it was at first.

        Raises:
            LearnBlockError: a program runs in this world.
        """
        self._require_no_program("put the world back")
        self.close()
        before = self._simulation.world
        world = World(before.description, seed=before.seed)
        for body in self._bodies(before):
            world.add_robot(body.description, body.name)
        self._simulation = Simulation(world)
        self._first, self.start, self._heard = self._body.pose, None, 0

    def camera(self, key: str | None = None) -> Picture | None:
        """What a camera of the robot sees, with what perception finds in it; None without a camera.

        Args:
            key: which camera; the first one by default.

        Raises:
            UnknownNameError: the robot has no such camera.
        """
        cameras = self._body.description.camera
        if not cameras:
            return None
        return self._looked(key or cameras[0].key)

    def sounds(self) -> Sequence[LogEntry]:
        """What the robot has been told to play, say, show or send since this was last asked."""
        simulation = self._simulation
        with simulation.lock:
            body = simulation.world.robots[self._name]
            new = body.noted - self._heard
            self._heard = body.noted
            return body.log[-new:] if new else ()

    def close(self) -> None:
        """Let the robot stand; the second time it does nothing."""
        if self._drive:
            self._drive.close()
            self._drive = None

    @property
    def _body(self) -> RobotBody:
        return self._simulation.world.robots[self._name]

    def _bodies(self, world: World) -> Iterator[RobotBody]:
        ours = world.robots[self._name]
        yield ours
        yield from (body for body in world.robots.values() if body is not ours)

    def _looked(self, key: str) -> Picture:
        simulation, body = self._simulation, self._body
        with simulation.lock:
            world = simulation.world
            moment = (key, world, world.steps, body.pose)
            if self._seen and self._seen[0] == moment:
                return self._seen[1]
            view, time = body.view(key), world.time
        # Drawn without the lock: the world need not wait for it.
        picture = developed(view, time)
        self._seen = (moment, picture)
        return picture

    def _require_no_program(self, what: str) -> None:
        if self._client and not self._client.stopped:
            raise LearnBlockError(f"a program is running: stop it first to {what}")


def make_stage(
    entry: RobotEntry, world: str | None = None, start: Pose | None = None
) -> Stage | None:
    """A robot in a world of its own, without a program; None for one that is not simulated.

    Args:
        entry: which robot.
        world: a world's name or the path of its file; by default the robot's own.
        start: (x mm, y mm, heading in degrees); by default the world's own start.

    Raises:
        LearnBlockError: there is no such world, or no room in it.
    """
    robot = entry.load()
    if not issubclass(robot, SimulatedRobot):
        return None
    simulation = robot.make_simulation(world=world)
    simulation.world.add_robot(robot.description(), start=start)
    return Stage(simulation, start)


def _robot_now(body: RobotBody) -> RobotNow:
    joints = {joint.key: body.joint(joint.key) for joint in body.description.joint}
    return RobotNow(body.name, *body.pose, joints, dict(body.leds), body.emotion)


def _sensors(body: RobotBody) -> Iterator[tuple[str, float | bool | None]]:
    """Every sensor's reading by its name."""
    has = body.description
    for side, readings in body.distances().items():
        for number, reading in enumerate(readings, start=1):
            yield f"Distance {side} {number}", reading
    yield from ((f"Ground {side}", reading) for side, reading in _ground(body))
    if has.gyroscope:
        yield "Gyroscope", body.gyroscope()
    if has.accelerometer:
        for axis, acceleration in zip(_AXES, body.acceleration(), strict=True):
            yield f"Accelerometer {axis}", acceleration
    if has.bumper:
        yield "Bumper", body.bumper()
    if has.light:
        yield "Light", body.light()


def _ground(body: RobotBody) -> Iterator[tuple[str, float | None]]:
    present = {sensor.side for sensor in body.description.ground}
    return (entry for entry in body.ground().items() if entry[0] in present)
