"""The world: a step counter, the bodies in it, and their collisions."""

import copy
import math
from collections import Counter, deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import pymunk
from msgspec.structs import replace

from learnblock.errors import Diagnostic, KeyTakenError, UnknownNameError, WorldError
from learnblock.i18n import Phrase
from learnblock.simulator.chassis import Chassis
from learnblock.simulator.chipmunk import advance
from learnblock.simulator.drawing import Drawing
from learnblock.simulator.floor import Floor
from learnblock.simulator.game.game import WorldGame
from learnblock.simulator.geometry import Pose
from learnblock.simulator.goal import GoalState, RobotState
from learnblock.simulator.goals import goals
from learnblock.simulator.physics import DT, ROBOT, Physics, motion
from learnblock.simulator.robot_body import RobotBody
from learnblock.simulator.robot_description import RobotDescription
from learnblock.simulator.world_description import WorldDescription

if TYPE_CHECKING:
    from learnblock.simulator.camera import Surface
    from learnblock.simulator.scenery import Solid

STEPS_PER_SECOND = 100
GOAL_PERIOD = 5
"""Steps between two checks of the goals."""
EVENTS_KEPT = 10_000
RINGS = 30
"""The largest distance from a blocked start pose at which a robot is placed, in robot diameters."""
MAXIMUM_LIGHT = 1023.0

EventKind = Literal["goal-reached", "goal-failed", "collision"]


@dataclass(frozen=True, slots=True)
class WorldEvent:
    """An event.

    Args:
        time: the world's time in s.
        kind: a collision is reported when it begins.
        subject: the goal's name, or the robot that bumps.
        other: the robot that reached the goal, or what was bumped into.
    """

    time: float
    kind: EventKind
    subject: str
    other: str = ""


class World:
    """A world with its robots; each `step` is 10 ms.

    The same description, seed and commands give the same motion and the same readings.

    Args:
        description: from `load_world`.
        seed: the seed of the noise and of slight differences in wheel size.
    """

    def __init__(self, description: WorldDescription, seed: int = 0) -> None:
        self.description = description
        self.seed = seed
        self.sensor_noise = description.sensor_noise
        self.dt = DT
        self.steps = 0
        self.floor = Floor(description)
        self.physics = Physics(description)
        self.physics.space.on_collision(ROBOT, None, begin=self._touch)
        self.robots: dict[str, RobotBody] = {}
        self._chassis: list[Chassis] = []
        self.drawing = Drawing()
        self._goals = goals(description, self.physics.pushed)
        self.game = WorldGame(description, self.physics, seed, GOAL_PERIOD * DT)
        self._events: deque[WorldEvent] = deque(maxlen=EVENTS_KEPT)
        self._touched: set[tuple[str, str]] = set()
        self._bumps: Counter[str] = Counter()
        self._solids: dict[str, Solid] = {}

    def __repr__(self) -> str:
        return f"<World {self.description.name!r} at {self.time} s with {len(self.robots)} robots>"

    @property
    def time(self) -> float:
        """Seconds since the world was created: steps * dt, rounded once."""
        return self.steps / STEPS_PER_SECOND

    @property
    def goals(self) -> tuple[GoalState, ...]:
        """The states of the goals, kind by kind."""
        return tuple(goal.state for goal in self._goals)

    @property
    def slip(self) -> float:
        """The part of their rotation that wheels lose, on average."""
        return self.description.floor.slip

    def add_robot(
        self,
        description: RobotDescription,
        name: str = "robot",
        start: str | tuple[float, float, float] | None = None,
    ) -> RobotBody:
        """Add a robot to the world.

        Args:
            description: from `load_robot`.
            name: its name in `robots`.
            start: the name of a start pose, or (x, y, heading). Without it, the first start pose
                that no robot has taken. If it is blocked, free floor next to it is used.

        Raises:
            KeyTakenError: there is already a robot with this name.
            UnknownNameError: there is no start pose with this name.
            WorldError: there is no free floor left.
        """
        if name in self.robots:
            raise KeyTakenError("world-robot-taken", name=name)
        radius = description.body.reach
        pose = Pose(*start) if isinstance(start, tuple) else self._free_pose(start, radius)
        self.game.teams.add(name, start if isinstance(start, str) else None)
        group = len(self.robots) + 1
        self.robots[name] = RobotBody(description, name, self, group, pose)
        self._chassis.append(self.robots[name].chassis)
        self.game.add(name, self.robots[name].chassis)
        return self.robots[name]

    def step(self) -> None:
        """Advance by 10 ms."""
        for body in self._chassis:
            body.before_step()
        advance(self.physics.space, DT)
        self.steps += 1
        for body in self._chassis:
            body.after_step()
        if self.drawing.pens:
            self.drawing.extend()
        if self._touched:
            self._report_collisions()
        if self.steps % GOAL_PERIOD == 0:
            self._look()

    def _look(self) -> None:
        """Let things of games and robots meet, and check the goals."""
        if self.game.is_live:
            self.game.look(self.time)
        if self._goals:
            self._check_goals(list(map(self._state_of, self.robots.values())))

    def copy(self) -> "World":
        """A copy of the world, which continues from here on its own.

        The physics forgets the contacts of the last step, so after one the copy may go on slightly
        differently.
        """
        kinds = (robot.description for robot in self.robots.values())
        shared = (self.description, self.floor, *kinds, *self._solids.values())
        memo: dict[int, Any] = {id(body): body for body in shared}
        if "_scenery" in self.__dict__:
            memo[id(self._scenery)] = self._scenery
        return copy.deepcopy(self, memo)

    @property
    def state(self) -> tuple[object, ...]:
        """How everything in it moves now; two worlds that agree go on alike."""
        return (
            self.steps,
            *(robot.chassis.motion for robot in self.robots.values()),
            *(motion(thing.body) for thing in self.physics.pushed),
            *self.goals,
            dict(self._bumps),
            self.game.state,
        )

    def finish(self, name: str) -> None:
        """Check the goals once more when a robot's program has ended and it stays where it is."""
        states = map(self._state_of, self.robots.values())
        self._check_goals([replace(state, has_ended=state.name == name) for state in states])
        self.robots[name].pen.set(False)

    @property
    def has_events(self) -> bool:
        """Whether there are events to take."""
        return bool(self._events)

    def take_events(self) -> list[WorldEvent]:
        """The events since the last call, oldest first."""
        events = list(self._events)
        self._events.clear()
        return events

    def floor_at(self, x: float, y: float) -> float:
        """The brightness of the floor at (x, y), 0 to 100; 0 outside the floor."""
        return self.floor.reflectance(x, y)

    def light_at(self, x: float, y: float) -> float:
        """The light at (x, y), 0 to 1023."""
        level = self.description.ambient_light
        for lamp in self.description.light:
            away = math.hypot(x - lamp.x, y - lamp.y)
            level += lamp.brightness * lamp.z**2 / (lamp.z**2 + away**2)
        return min(level, MAXIMUM_LIGHT)

    def surfaces(self, without: str | None = None) -> "list[Surface]":
        """The surfaces that are visible to cameras now.

        Args:
            without: the robot with the camera, if any; it does not see itself.
        """
        return [*self._scenery, *self._moving(without)]

    def _free_pose(self, start: str | None, radius: float) -> Pose:
        wanted = self._start(start)
        for pose in _places_around(wanted, 2 * radius + 20):
            x, y = abs(pose.x) + radius, abs(pose.y) + radius
            if self.floor.reaches(x, y) and self.physics.is_free(pose.x, pose.y, radius):
                return pose
        world = self.description.name
        raise WorldError(world, [Diagnostic("no-room", Phrase("world-no-room", world=world))])

    def _start(self, name: str | None) -> Pose:
        starts = {start.name: start for start in self.description.start}
        if name is None:
            chosen = list(starts.values())[len(self.robots) : len(self.robots) + 1]
            chosen = chosen or list(starts.values())[:1]
            return Pose(chosen[0].x, chosen[0].y, chosen[0].heading) if chosen else Pose(0, 0, 0)
        if name not in starts:
            raise UnknownNameError("start-pose", name, starts)
        return Pose(starts[name].x, starts[name].y, starts[name].heading)

    def _touch(self, arbiter: pymunk.Arbiter, space: pymunk.Space, data: Any) -> None:  # noqa: ARG002 - pymunk's signature
        first, second = arbiter.shapes
        if first.collision_type != ROBOT:
            first, second = second, first
        names = self.physics.names[first], self.physics.names[second]
        both = second.collision_type == ROBOT
        self._touched.add((min(names), max(names)) if both else names)

    def _report_collisions(self) -> None:
        for robot, other in sorted(self._touched):
            self._events.append(WorldEvent(self.time, "collision", robot, other))
            self._bumps.update({robot, other} & self.robots.keys())
        self._touched.clear()

    def _check_goals(self, robots: Sequence[RobotState]) -> None:
        if self.game.is_decided:
            return
        for goal in filter(lambda goal: goal.state.is_open, self._goals):
            goal.look(self.time, robots)
            self._tell_end(goal.state)
        self.game.judge(self.goals, self.time)

    def _state_of(self, robot: RobotBody) -> RobotState:
        name, chassis, game = robot.name, robot.chassis, self.game
        pose, counts = chassis.pose, game.scores.of(name)
        return RobotState(
            name,
            self.time,
            pose,
            robot.emotion,
            chassis.distance_driven,
            self._bumps[name],
            self.floor.reaches(pose.x, pose.y),
            score=counts.score,
            lost_lives=counts.lost_lives,
            collected=counts.collected,
            gates=game.passed.get(name, 0),
            team=game.teams.robots.get(name, ""),
        )

    def _tell_end(self, state: GoalState) -> None:
        if state.reached_at is not None:
            self._events.append(WorldEvent(self.time, "goal-reached", state.name, state.robot))
        elif state.failed_at is not None:
            self._events.append(WorldEvent(self.time, "goal-failed", state.name))

    @cached_property
    def _scenery(self) -> "list[Surface]":
        # Imported here because a world without a camera does not need OpenCV.
        from learnblock.simulator.scenery import scenery  # noqa: PLC0415 - see above

        return scenery(self.description, self.floor)

    def _moving(self, without: str | None) -> "Iterator[Surface]":
        from learnblock.simulator.scenery import hull, solid  # noqa: PLC0415 - as above

        for index, pushed in enumerate(self.physics.pushed):
            key = f"pushed {index}"
            if key not in self._solids:
                self._solids[key] = solid(pushed.thing)
            yield from self._solids[key].at(pushed.pose)
        yield from self._solids_of_game()
        for name, robot in self.robots.items():
            key = f"robot {name}"
            if key not in self._solids:
                self._solids[key] = hull(robot.description.body, name)
            if name != without:
                yield from self._solids[key].at(robot.chassis.pose)

    def _solids_of_game(self) -> "Iterator[Surface]":
        from learnblock.simulator.scenery import solid  # noqa: PLC0415 - as above

        for index, (thing, pose) in enumerate(self.game.visible()):
            key = f"game {index} {thing.name}"
            if key not in self._solids:
                self._solids[key] = solid(thing)
            yield from self._solids[key].at(pose)


def _places_around(wanted: Pose, spacing: float) -> Iterator[Pose]:
    """The requested pose, then ever larger squares around it, with the same heading."""
    yield wanted
    for ring in range(1, RINGS + 1):
        for column in range(-ring, ring + 1):
            for row in range(-ring, ring + 1):
                if max(abs(column), abs(row)) == ring:
                    x, y = wanted.x + column * spacing, wanted.y + row * spacing
                    yield Pose(x, y, wanted.heading)
