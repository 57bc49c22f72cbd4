"""The monitor of a simulated robot in its world.

Watching uses no random numbers and no camera frame, so the program's readings, frames and trace
are the same with a page and without one.
"""

import math
from collections.abc import Iterator, Sequence

import msgspec

from learnblock.devices import Pose
from learnblock.errors import LearnBlockError
from learnblock.monitor.games import game_now
from learnblock.monitor.manual_drive import ManualDrive
from learnblock.monitor.monitor import (
    GoalNow,
    Link,
    LinkState,
    Picture,
    Robot,
    Scene,
    Seen,
    State,
    Stroke,
    located,
)
from learnblock.monitor.pictures import develop, found
from learnblock.monitor.sensors import SENSOR_TYPES, Sensor, sensors_of
from learnblock.monitor.worlds import world_lines, world_values
from learnblock.robots.simulated import SimulatedRobot, Simulation, goal_of
from learnblock.simulator import LogEntry, RobotBody, World
from learnblock.simulator.robot_body import READINGS


class WorldMonitor:
    """The `Monitor` of a simulated robot.

    Args:
        simulation: the world.
        start: (x mm, y mm, heading in degrees) where the user placed the robot.
        client: the robot of the program that runs in this world.
        name: the robot's name, without a client.
    """

    def __init__(
        self,
        simulation: Simulation,
        start: Pose | None = None,
        client: SimulatedRobot | None = None,
        *,
        name: str = "robot",
    ) -> None:
        self._start = start
        self._simulation = simulation
        self._client = client
        self._name = client.name if client else name
        self._first = self._body.pose
        self._heard = 0
        self._drive: ManualDrive | None = None
        self._seen: tuple[object, Picture] | None = None

    @classmethod
    def of(cls, client: SimulatedRobot) -> "WorldMonitor":
        """Create the monitor of a program's robot."""
        return cls(client.simulation, client.start, client)

    @property
    def start(self) -> Pose | None:
        """The pose where the user placed the robot; None for the world's own start."""
        return self._start

    def scene(self) -> Scene:
        world = self._simulation.world
        return Scene(
            name=world.description.name,
            world=world_values(world.description),
            lines=world_lines(world.description),
            robots=tuple(
                (body.name, msgspec.to_builtins(body.description)) for body in self._bodies(world)
            ),
            cameras=tuple(camera.key for camera in self._body.description.camera),
            start=self._start or self._first,
            variant=world.description.variant,
        )

    def link(self) -> Link:
        return Link(LinkState.SIMULATED)

    def state(self) -> State:
        simulation = self._simulation
        with simulation.lock:
            world = simulation.world
            pushed = [thing.pose for thing in world.physics.pushed]
            pushed += [solid.pose for solid in world.game.solids]
            return State(
                time=world.time,
                robots=tuple(map(_robot_now, self._bodies(world))),
                pushed=tuple((pose.x, pose.y, pose.heading) for pose in pushed),
                sensors=tuple(_sensors(world.robots[self._name])),
                goals=tuple(
                    GoalNow(goal.name, goal.kind, goal.state, goal.time, goal.team)
                    for goal in map(goal_of, world.goals)
                ),
                game=game_now(world.game, world.time),
            )

    def place(self, x: float, y: float, heading: float) -> None:
        """Place the robot elsewhere (mm, mm, degrees); the next run starts there.

        Raises:
            ValueError: one of them is not a finite number.
        """
        self._simulation.place(self._name, x, y, heading)
        self._start = (x, y, heading)

    def handle(self, how: str) -> None:
        """Shake or tilt the robot, also while a program runs; see `Hand.move`."""
        self._simulation.handle(self._name, how)

    def drive(self, advance: float, rotation: float) -> None:
        """Drive by hand; the robot stops half a second after the last call.

        Args:
            advance: fraction of the robot's top speed, -1 to 1, forward positive.
            rotation: fraction of its top speed, -1 to 1, clockwise positive.

        Raises:
            LearnBlockError: a program drives the robot.
        """
        self._require_no_program()
        if self._drive is None:
            self._drive = ManualDrive(self._simulation, self._body)
        wheels = self._body.description.wheels
        fastest_turn = math.degrees(2 * wheels.maximum_speed / wheels.track)
        self._drive.command(advance * wheels.maximum_speed, rotation * fastest_turn)

    def found(self) -> tuple[Seen, ...] | None:
        return found(self._client.detected) if self._client else None

    def camera(self, key: str | None = None) -> Picture | None:
        """A camera's view, with the findings of perception; None without a camera.

        Args:
            key: which camera; the first one by default.

        Raises:
            UnknownNameError: the robot has no such camera.
        """
        cameras = self._body.description.camera
        if not cameras:
            return None
        return self._look(key or cameras[0].key)

    def sounds(self) -> Sequence[LogEntry]:
        """The commands to play, say, show or send something since the last call."""
        simulation = self._simulation
        with simulation.lock:
            body = simulation.world.robots[self._name]
            new = body.noted - self._heard
            self._heard = body.noted
            return body.log[-new:] if new else ()

    def strokes(self) -> Sequence[Stroke]:
        return tuple(self._simulation.world.drawing.strokes)

    def close(self) -> None:
        """End manual driving; calling it twice is harmless."""
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

    def _look(self, key: str) -> Picture:
        simulation, body = self._simulation, self._body
        with simulation.lock:
            world = simulation.world
            moment = (key, world, world.steps, body.pose)
            if self._seen and self._seen[0] == moment:
                return self._seen[1]
            view, time = body.view(key), world.time
        # Drawn without the lock, so that the world does not wait for it.
        picture = develop(view.picture(), time, drawn=True)
        self._seen = (moment, picture)
        return picture

    def _require_no_program(self) -> None:
        if self._client and not self._client.stopped:
            raise LearnBlockError("monitor-program-running")


def make_world_monitor(
    robot: type[SimulatedRobot],
    world: str | None = None,
    start: Pose | None = None,
    variant: int = 0,
) -> WorldMonitor:
    """A simulated robot in its own world, without a program.

    Args:
        robot: its class.
        world: a world's name or the path of its file; by default the robot's own.
        start: (x mm, y mm, heading in degrees); by default the world's own start.
        variant: the number of the world's variant; 0 is the world as it is drawn.

    Raises:
        LearnBlockError: there is no such world or variant, or it has no room.
    """
    simulation = robot.make_simulation(world=world, variant=variant)
    simulation.world.add_robot(robot.description(), start=start)
    return WorldMonitor(simulation, start)


def _robot_now(body: RobotBody) -> Robot:
    joints = {joint.key: body.joint(joint.key) for joint in body.description.joint}
    speed = body.chassis.speed
    return Robot(
        body.name,
        *located(body.pose),
        joints=joints,
        leds=dict(body.leds),
        emotion=body.emotion,
        speed=speed,
        text=body.text,
    )


def _sensors(body: RobotBody) -> Iterator[Sensor]:
    """The readings of every sensor."""
    keys = dict(device.split(":") for device in body.description.devices())
    for kind in SENSOR_TYPES:
        if kind in keys and kind in READINGS:
            yield from sensors_of(kind, READINGS[kind](body), keys[kind])
